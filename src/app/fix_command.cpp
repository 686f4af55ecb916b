#include <fmt/format.h>

#include <memory>

#include "arguments.h"
#include "commands.h"
#include "exit_codes.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/profile/edit.h"
#include "fusee/report/fix.h"
#include "numbers.h"
#include "places.h"

namespace fusee::app {

namespace {

namespace fs = std::filesystem;

struct FixArguments {
    fs::path profile;
    bool json = false, force = false;
    fix::Options options;
};

/// In the folder of the profile: "x-fixed.toml" for "x.toml".
fs::path beside(const fs::path& profile) { return profile.parent_path() / (profile.stem().string() + "-fixed.toml"); }

int run_fix(const FixArguments& arguments) {
    core::catch_interrupts();
    require_thread();
    fix::Options options = arguments.options;
    if (options.file.empty()) options.file = beside(arguments.profile);
    options.progress = [](const std::string& step) { fmt::print(stderr, "fix: {}\n", step); };
    options.stop = core::interrupted;
    for (const std::string& key : options.keep) profile::require_key("--keep", key);
    const std::string toml = core::read_file(arguments.profile, profile::kLargestFile);
    const profile::Profile profile = profile::parse_profile(toml, arguments.profile);
    require_new_profile("--out", options.file, arguments.profile, arguments.force);
    const fix::Fix found = with_places(profile, [&] { return fix::find_fix(profile, toml, options); });
    if (!found.file.empty()) core::write_file(found.file, found.toml);
    const bool cannot = found.end == fix::Fix::End::kCannot;
    if (arguments.json)
        fmt::print("{}", report::fix_json(found));
    else
        fmt::print(cannot ? stderr : stdout, "{}", report::fix_text(found));
    return cannot ? kRefused : 0;
}

}  // namespace

void add_fix(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<FixArguments>();
    CLI::App* command =
        app.add_subcommand("fix", "Change a profile until it can be made: a new profile that states each change and its reason");
    command->add_option("profile", arguments->profile, "Profile (*.toml) that cannot be made; it is not changed")
        ->type_name("FILE.toml")
        ->required();
    command->add_option("-o,--out", arguments->options.file, "File of the new profile; default: PROFILE-fixed.toml in the same folder")
        ->type_name("FILE.toml");
    command->add_flag("--reviews", arguments->options.reviews, "Also remove the warnings");
    command
        ->add_option("--keep", arguments->options.keep,
                     "Key or table that stays unchanged, such as k_pe.hub.bore_mm or cable; may be repeated")
        ->type_name("KEY")
        ->expected(1)
        ->take_all();
    command->add_option("--most", arguments->options.most_judged, "Largest number of profiles that the search judges")
        ->check(number_within(1, 1000000))
        ->capture_default_str();
    command->add_flag("--json", arguments->json, "Print the changes as JSON instead of text");
    add_force_file(*command, arguments->force);
    command->footer(
        "Example:\n  fusee fix profiles/pnrvsa.toml --out /tmp/pnrvsa.toml\n\n"
        "Exit code: 0 the profile is fixed or needs no change, 1 it cannot be fixed (the binding limit is printed, nothing is written),\n"
        "2 bad input (file, line and key are named), 3 internal error, 130 stopped by Ctrl-C: nothing is written.");
    command->callback([arguments, &action] { action = [arguments] { return run_fix(*arguments); }; });
}

}  // namespace fusee::app
