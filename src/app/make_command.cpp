#include "arguments.h"
#include "fusee/batch/batch.h"
#include "fusee/core/text.h"
#include "fusee/profile/places.h"
#include "fusee/report/findings.h"
#include "source_lines.h"

namespace fusee::app {

namespace {

struct MakeArguments {
    std::vector<std::filesystem::path> paths;
    batch::OutFolder folder;
    std::string via = to_string(pipeline::Via::kCgal);
    unsigned jobs = 0;
    bool no_frame = false;
};

Json row_json(const batch::Row& row) {
    Json j{{"profile", row.profile.string()}, {"outcome", batch::to_string(row.outcome)}, {"name", row.result.name}};
    j["folder"] = row.result.folder.empty() ? Json() : Json(row.result.folder.string());
    j["error"] = row.error.empty() ? Json() : Json{{"message", row.error}, {"mistakes", mistakes_json(row.mistakes)}};
    j["findings"] = Json::parse(report::findings_list_json(row.result.findings));
    return j;
}

/// Times of the stages, and what no rule judged.
std::string more_about(const batch::Row& row) {
    std::string text = core::printable(row.profile.string()) + ":\n";
    for (const batch::Stage& stage : row.result.stages) text += fmt::format("  {:6.2f} s  {}\n", stage.seconds, stage.name);
    for (const core::Finding& finding : row.result.findings)
        if (finding.severity == core::Severity::kNotJudged) text += "  " + core::to_line(finding) + "\n";
    return text;
}

void answer(const std::vector<batch::Row>& rows, Reply& reply) {
    if (reply.json()) reply.result["designs"] = Json::array();
    for (const batch::Row& row : rows) {
        if (reply.json()) reply.result["designs"].push_back(row_json(row));
        if (!row.error.empty()) reply.fail(row.error, row.mistakes);
        if (row.outcome == batch::Outcome::kOutOfResources) reply.lack_resources();
        if (reply.verbose()) reply.detail(more_about(row));
    }
}

int make(const MakeArguments& arguments, Reply& reply) {
    require_thread();
    if (arguments.paths.empty()) throw core::InvalidInput("make", "no profile", "at least one profile (*.toml) or folder of profiles");
    const pipeline::Via via = arguments.via == "cgal" ? pipeline::Via::kCgal : pipeline::Via::kOpenScad;
    auto rows = batch::make_all(profile::find_profiles(arguments.paths), arguments.folder, arguments.jobs, via, !arguments.no_frame);
    name_other_kinds(rows);
    const int code = batch::exit_code(rows);
    answer(rows, reply);
    reply.close(code, with_source_lines(batch::closing_table(rows)));
    return code;
}

}  // namespace

void add_make(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "make", make);
    command->add_option("profiles", arguments->paths, "One or more profiles (*.toml) or folders of profiles")->type_name("FILE.toml");
    add_out(*command, arguments->folder.out, "Folder of the results; each design gets a folder in it");
    command->add_option("--via", arguments->via, "Kernel that makes the STL: cgal (direct and fast) or openscad (independent, slower)")
        ->check(one_of({"cgal", "openscad"}))
        ->capture_default_str();
    command->add_flag("--no-frame", arguments->no_frame, "Leave out the frame of the joint, as assembly.frame = false does");
    add_force(*command, arguments->folder.force);
    add_jobs(*command, arguments->jobs, "Number of designs made at the same time; 0: one per processor");
    command->footer(
        "Example:\n  fusee make profiles/pnrvsa.toml\n  fusee make profiles --out /tmp/cams --jobs 2\n\n"
        "Exit code: 0 all designs are made, 1 a design cannot be made (its binding limit and the nearest feasible change are printed), "
        "2 bad input (file, line and key are named), 3 internal error, 130 stopped by Ctrl-C. A design "
        "that is not made leaves no file.");
}

}  // namespace fusee::app
