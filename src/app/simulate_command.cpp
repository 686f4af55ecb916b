#include <charconv>
#include <cmath>
#include <optional>

#include "arguments.h"
#include "fusee/batch/batch.h"
#include "fusee/profile/places.h"
#include "fusee/report/findings.h"
#include "fusee/report/simulation.h"
#include "source_lines.h"

namespace fusee::app {

namespace {

struct SimulateArguments {
    std::vector<std::filesystem::path> paths;
    std::filesystem::path out = "out", mjcf;
    pipeline::SimulateOptions options;
    std::vector<std::string> at;  ///< checked by parse_torques
    unsigned jobs = 0;
    bool force = false;
};

constexpr double kLargestTorque = 1e4;

/// "1,0.8,0" as (tau_1, tau_2, tau_q) [Nm]; nothing if the text is not three torques.
std::optional<Eigen::Vector3d> parse_torques(const std::string& text) {
    Eigen::Vector3d torques;
    const char* next = text.data();
    const char* const end = next + text.size();
    for (int i = 0; i < 3; ++i) {
        if (i > 0 && (next == end || *next++ != ',')) return std::nullopt;
        const auto [rest, error] = std::from_chars(next, end, torques[i]);
        if (error != std::errc() || !(std::abs(torques[i]) <= kLargestTorque)) return std::nullopt;
        next = rest;
    }
    return next == end ? std::optional(torques) : std::nullopt;
}

std::string three_torques(const std::string& text) {
    if (parse_torques(text)) return "";
    return fmt::format("{} (allowed: three torques in Nm with commas between them, each from {:g} to {:g}, such as 1,0.8,0)", text,
                       -kLargestTorque, kLargestTorque);
}

Json simulation_json(const batch::SimulationRow& row) {
    Json j{{"profile", row.profile.string()}, {"outcome", batch::to_string(row.outcome)}};
    j["folder"] = row.folder.empty() ? Json() : Json(row.folder.string());
    j["mjcf"] = row.mjcf.empty() ? Json() : Json(row.mjcf.string());
    j["error"] = row.error.empty() ? Json() : Json{{"message", row.error}, {"mistakes", mistakes_json(row.mistakes)}};
    j["findings"] = Json::parse(report::findings_list_json(row.refusal));
    j["simulation"] = row.simulation ? Json::parse(report::simulation_json(*row.simulation)) : Json();
    return j;
}

int simulate(const SimulateArguments& arguments, Reply& reply) {
    if (arguments.paths.empty()) throw core::InvalidInput("simulate", "no profile", "at least one profile (*.toml) or folder of profiles");
    if (!arguments.mjcf.empty()) require_other_folder("--write-mjcf", arguments.mjcf, arguments.out, "--out");
    pipeline::SimulateOptions options = arguments.options;
    for (const std::string& torques : arguments.at) options.at.push_back(*parse_torques(torques));
    auto rows = batch::simulate_all(profile::find_profiles(arguments.paths), arguments.out, options, arguments.jobs, arguments.force,
                                    arguments.mjcf);
    name_other_kinds(rows);
    const int code = batch::exit_code(rows);
    if (reply.json()) reply.result["joints"] = Json::array();
    for (const batch::SimulationRow& row : rows) {
        if (reply.json()) reply.result["joints"].push_back(simulation_json(row));
        if (!row.error.empty()) reply.fail(row.error, row.mistakes);
        if (row.outcome == batch::Outcome::kOutOfResources) reply.lack_resources();
    }
    reply.close(code, with_source_lines(batch::closing_table(rows)));
    return code;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
    constexpr int kMostLevels = 1000;
    const auto [command, arguments] = add_command(app, action, "simulate", simulate);
    command->add_option("profiles", arguments->paths, "One or more profiles (*.toml) or folders of profiles")->type_name("FILE.toml");
    add_out(*command, arguments->out, "Folder of the results; each profile gets a folder in it. Other files there stay");
    command->add_option("--levels", arguments->options.levels, "Number of levels of co-contraction; replaces that of the profile")
        ->check(number_within(2, kMostLevels));
    command
        ->add_option("--push-torque", arguments->options.push_torque,
                     "Joint torque of the push-and-release test [Nm]; 0: large enough to move the joint")
        ->check(number_within(0.0, kLargestTorque));
    command
        ->add_option(
            "--at", arguments->at,
            "Torques of agonist, antagonist and joint [Nm], such as 1,0.8,0: computes equilibrium, sensitivity and dead-band; may be "
            "repeated")
        ->allow_extra_args(false)
        ->type_name("T1,T2,TQ")
        ->check(CLI::Validator(three_torques, ""));
    command
        ->add_option("--write-mjcf", arguments->mjcf,
                     "Folder of the joints as models for MuJoCo, with companion programs that apply the exact laws; each profile gets a "
                     "folder in it")
        ->type_name("FOLDER");
    add_force(*command, arguments->force);
    add_jobs(*command, arguments->jobs, "Number of profiles simulated at the same time; 0: one per processor");
    command->footer(
        "Example:\n  fusee simulate profiles/pnrvsa.toml\n  fusee simulate profiles/relatives --levels 5\n  fusee simulate "
        "profiles/pnrvsa.toml --at 1,0.9,0 --at 1,1,0.05\n\n"
        "Exit code: 0 all profiles are simulated, 1 a law or an equilibrium is not possible (the binding limit and the nearest feasible\n"
        "change are printed), "
        "2 bad input (file, line and key are named), 3 internal error, 130 stopped by Ctrl-C.");
}

}  // namespace fusee::app
