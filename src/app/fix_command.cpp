#include "arguments.h"
#include "fusee/core/progress.h"
#include "fusee/report/search.h"
#include "places.h"

namespace fusee::app {

namespace {

struct FixArguments {
    fs::path profile;
    bool force = false;
    search::fix::FixOptions options;
};

int run_fix(const FixArguments& arguments, Reply& reply) {
    require_thread();
    search::fix::FixOptions options = arguments.options;
    if (options.file.empty()) options.file = beside(arguments.profile, "-fixed");
    if (!reply.quiet()) options.progress = [&reply](const std::string& step) { reply.warn(fmt::format("fix: {}\n", step)); };
    options.stop = core::interrupted;
    for (const std::string& key : options.keep) profile::require_key("--keep", key);
    const std::string toml = core::read_file(arguments.profile, profile::kLargestFile);
    const profile::Profile profile = profile::parse_profile(toml, arguments.profile);
    require_new_profile("--out", options.file, arguments.profile, arguments.force);
    const search::fix::Fix found = with_places(profile, [&] { return search::fix::find_fix(profile, toml, options); });
    if (!found.file.empty()) core::write_file(found.file, found.toml);
    const bool cannot = found.end == search::fix::Fix::End::kCannot;
    const int code = cannot ? kRefused : 0;
    reply.set_all(report::fix_json(found));
    reply.close(code, report::fix_text(found));
    return code;
}

}  // namespace

void add_fix(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "fix", run_fix);
    add_profile(*command, arguments->profile, "Profile (*.toml) that cannot be made; it is not changed");
    command->add_option("-o,--out", arguments->options.file, "File of the new profile; default: PROFILE-fixed.toml in the same folder")
        ->type_name("FILE.toml");
    command->add_flag("--reviews", arguments->options.reviews, "Also remove the warnings");
    command
        ->add_option("--keep", arguments->options.keep,
                     "Key or table that stays unchanged, such as k_pe.hub.bore_mm or cable; may be repeated")
        ->type_name("KEY")
        ->expected(1)
        ->take_all();
    add_number(*command, "--most", arguments->options.most_judged, 1, 1000000, "Largest number of profiles that the search judges");
    add_jobs(*command, arguments->options.jobs, "Number of threads; 0: one per processor. The result does not depend on it");
    add_force_file(*command, arguments->force);
    command->footer(
        "Example:\n  fusee fix profiles/pnrvsa.toml --out /tmp/pnrvsa.toml\n\n"
        "Exit code: 0 the profile is fixed or needs no change, 1 it cannot be fixed (the binding limit is printed, nothing is written), "
        "2 bad input (file, line and key are named), 3 internal error, 130 stopped by Ctrl-C: nothing is written.");
}

}  // namespace fusee::app
