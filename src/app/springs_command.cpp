#include <array>

#include "arguments.h"
#include "fusee/core/text.h"
#include "fusee/pipeline/check.h"
#include "fusee/report/findings.h"
#include "fusee/report/springs.h"
#include "places.h"

namespace fusee::app {

namespace {

struct SpringsArguments {
    fs::path profile, out, catalogue;
    bool bought = false, force = false;
    double within_percent = 2.0;
    std::string wire_class = "sh";
    std::vector<std::string> columns;
    pipeline::SpringSearchOptions options;
};

spring::WireClass class_of(const std::string& name) {
    const auto found = std::find(spring::kWireClassNames.begin(), spring::kWireClassNames.end(), name);
    return static_cast<spring::WireClass>(found - spring::kWireClassNames.begin());
}

/// @returns exit code; prints the binding findings of the design with its new springs
int judge_again(const profile::Profile& profile, Reply& reply) {
    const pipeline::Checked checked = pipeline::check(profile, std::array{profile.process.kind});
    const core::Findings all = checked.processes.front().all();
    reply.say(fmt::format("made again with them: {}, {}, {} not judged\n", core::counted(core::count(all, core::Severity::kError), "error"),
                          core::counted(core::count(all, core::Severity::kWarning), "warning"),
                          core::counted(core::count(all, core::Severity::kNotJudged), "rule")));
    for (const core::Finding& f : all)
        if (f.severity == core::Severity::kError) reply.warn(core::to_line(f) + "\n");
    reply.set("findings", report::findings_list_json(all));
    return core::any_error(all) ? kRefused : 0;
}

int refuse_search(const core::Findings& refusal, Reply& reply) {
    reply.show(refusal);
    return kRefused;
}

Json names_of(const std::vector<pipeline::FoundSpring>& springs) {
    Json names = Json::array();
    for (const pipeline::FoundSpring& spring : springs) names.push_back(spring.name);
    return names;
}

int search_springs(const SpringsArguments& arguments, const fs::path& out, const std::string& toml, const profile::Profile& profile,
                   const spring::Catalogue& catalogue, Reply& reply) {
    const auto design = pipeline::resolve(profile);
    if (!design) return refuse_search(design.refusal(), reply);
    pipeline::SpringSearchOptions options = arguments.options;
    options.within = 0.01 * arguments.within_percent;
    options.wire_class = class_of(arguments.wire_class);
    std::vector<profile::Edit> edits = profile::file_edits(profile, fs::absolute(out).parent_path());
    edits.push_back(profile::name_edit(profile, "-springs"));
    for (const cam::PartKind part : profile.part_kinds()) {
        const auto search = pipeline::find_springs(part, *design, catalogue, options);
        if (!search) return refuse_search(search.refusal(), reply);
        reply.print(report::springs_text(*search));
        reply.result["parts"].push_back(
            {{"part", search->table}, {"wound", names_of(search->wound)}, {"bought", names_of(search->bought)}});
        const auto& springs = arguments.bought ? search->bought : search->wound;
        if (springs.empty()) return kRefused;
        for (profile::Edit& edit : pipeline::spring_edits(part, springs.front(), profile)) edits.push_back(std::move(edit));
    }
    const std::string changed = profile::with_edits(toml, profile, edits);
    const profile::Profile again = profile::parse_profile(changed, out);
    core::write_file(out, changed);
    reply.result["file"] = out.string();
    reply.say(fmt::format("written: {}\n", out.string()));
    return with_places(again, [&] { return judge_again(again, reply); });
}

int run_springs(const SpringsArguments& arguments, Reply& reply) {
    const fs::path out = arguments.out.empty() ? beside(arguments.profile, "-springs") : arguments.out;
    const std::string toml = core::read_file(arguments.profile, profile::kLargestFile);
    const profile::Profile profile = profile::parse_profile(toml, arguments.profile);
    require_new_profile("--out", out, arguments.profile, arguments.force);
    const spring::Catalogue catalogue = arguments.catalogue.empty()
                                            ? profile.co_design.catalogue
                                            : spring::read_catalogue(arguments.catalogue, core::CsvMapping::of(arguments.columns));
    return with_places(profile, [&] {
        pipeline::require_parts(profile);
        return search_springs(arguments, out, toml, profile, catalogue, reply);
    });
}

}  // namespace

void add_springs(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "springs", run_springs);
    add_profile(*command, arguments->profile, "Profile (*.toml); it is not changed");
    command->add_option("-o,--out", arguments->out, "File of the new profile; default: PROFILE-springs.toml in the same folder")
        ->type_name("FILE.toml");
    add_catalogue(*command, arguments->catalogue, "Springs on sale; default: co_design.catalogue of the profile");
    add_columns(*command, arguments->columns);
    command->add_flag("--bought", arguments->bought, "Take the springs of the catalogue, not wound ones");
    command->add_option("--wire-class", arguments->wire_class, "Wire of EN 10270-1 where the profile states none")
        ->check(one_of(std::vector<std::string>(spring::kWireClassNames.begin() + 1, spring::kWireClassNames.end())))
        ->capture_default_str();
    add_number(*command, "--cycles", arguments->options.cycles, 1.0, 1e12, "Load cycles where the profile states none");
    add_number(*command, "--within", arguments->within_percent, 0.0, 10.0,
               "Largest difference of a wound spring's rate from the wanted one, in percent");
    add_number(*command, "--most", arguments->options.most, 1, 1000, "Springs to list of each kind");
    command->add_flag("--accept-reviews", arguments->options.accept_reviews, "Also take springs with warnings");
    add_force_file(*command, arguments->force);
    command->footer(
        "Example:\n  fusee springs profiles/pnrvsa.toml --out /tmp/pnrvsa.toml\n\n"
        "Exit code: 0 springs were found and the design can be made with them, 1 no spring passes or the design cannot be made with it, "
        "2 bad input (file, line and key are named), 3 internal error.");
}

}  // namespace fusee::app
