#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <vector>

#include "arguments.h"
#include "commands.h"
#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "fusee/exchange/mesh_file.h"
#include "fusee/inspect/rule.h"
#include "fusee/pipeline/check.h"
#include "fusee/profile/limits.h"
#include "fusee/report/check.h"
#include "mesh_check.h"
#include "places.h"

namespace fusee::app {

namespace {

struct CheckArguments {
    std::filesystem::path input;
    std::string process;
    std::filesystem::path profile, limits, out;
    bool json = false, force = false;
    unsigned jobs = 0;
};

constexpr const char* kAll = "all";

std::vector<std::string> process_words() {
    std::vector<std::string> words;
    for (const checks::ProcessLimits& row : checks::process_table()) words.emplace_back(checks::to_string(row.kind));
    words.emplace_back(kAll);
    return words;
}

/// "FILE.toml|stl|...", for the help and the completion.
std::string input_type() {
    std::string type = "FILE.toml";
    for (const std::string& ending : exchange::mesh_endings()) type += "|" + ending.substr(1);
    return type;
}

/// @pre `word` is one of process_words
std::vector<checks::ProcessKind> kinds_of(const std::string& word) {
    std::vector<checks::ProcessKind> kinds;
    for (const checks::ProcessLimits& row : checks::process_table())
        if (word == kAll || word == checks::to_string(row.kind)) kinds.push_back(row.kind);
    return kinds;
}

pipeline::Checked check_profile(const CheckArguments& arguments) {
    if (!arguments.out.empty() || !arguments.profile.empty() || !arguments.limits.empty())
        throw core::InvalidInput(
            "check", arguments.input.string(),
            "a mesh with --out, --profile and --limits; of a profile no file is written, and it has its own [[limits]]");
    const profile::Profile profile = profile::read_profile(arguments.input);
    const auto kinds = arguments.process.empty() ? std::vector{profile.process.kind} : kinds_of(arguments.process);
    return with_places(profile, [&] { return pipeline::check(profile, kinds); });
}

/// How a mesh is to be made: by the profile's figures where they are for that process, else by the process's defaults.
std::vector<Machine> machines_for(const CheckArguments& arguments) {
    std::vector<Machine> machines;
    if (!arguments.profile.empty()) {
        const profile::Profile profile = profile::read_profile(arguments.profile);
        if (!profile.has_parts)
            throw core::InvalidInput("--profile", arguments.profile.string(), "a profile with [process], the machine that makes the mesh");
        const auto kinds = arguments.process.empty() ? std::vector{profile.process.kind} : kinds_of(arguments.process);
        for (const checks::ProcessKind kind : kinds) {
            const bool own = kind == profile.process.kind;
            const checks::Process process = pipeline::by_process(profile, kind).profile.process;
            machines.push_back({process, own ? "[process] of the profile" : pipeline::default_figures(process), own});
        }
        return machines;
    }
    if (arguments.process.empty())
        throw core::InvalidInput("check --process", "missing",
                                 fmt::format("how the mesh is to be made: {}", fmt::join(process_words(), ", ")));
    for (const checks::ProcessKind kind : kinds_of(arguments.process)) {
        checks::Process process;
        process.kind = kind;
        machines.push_back({process, pipeline::default_figures(process)});
    }
    return machines;
}

MeshCheck checked(const CheckArguments& arguments) {
    if (arguments.input.extension() == ".toml") return {check_profile(arguments), {}};
    if (!exchange::is_mesh_file(arguments.input))
        throw core::InvalidInput("check", arguments.input.string(),
                                 fmt::format("a profile (.toml) or a mesh ({})", fmt::join(exchange::mesh_endings(), ", ")));
    const auto limits =
        arguments.limits.empty() ? std::vector<checks::Override>{} : profile::read_limits(arguments.limits, inspect::rule_infos());
    std::vector<Machine> machines = machines_for(arguments);
    for (Machine& machine : machines)
        if (!limits.empty()) machine.figures += "; [[limits]] of " + arguments.limits.filename().string();
    return check_mesh(arguments.input, machines, limits, arguments.out, arguments.force, arguments.jobs);
}

int check(const CheckArguments& arguments) {
    const MeshCheck result = checked(arguments);
    const bool good = result.checked.makeable();
    if (arguments.json) {
        fmt::print("{}", report::check_json(result.checked));
    } else {
        fmt::print(good ? stdout : stderr, "{}", report::check_text(result.checked));
        if (!result.coloured.empty())
            fmt::print(good ? stdout : stderr, "Where: {} (red: error, orange: warning)\n", core::printable(result.coloured.string()));
    }
    return good ? 0 : 1;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command = app.add_subcommand("check", "Run every rule on a profile's cams, or on a third-party mesh, without making files");
    command->add_option("input", arguments->input, "Profile (.toml), or mesh: STL, OBJ, 3MF, STEP")->type_name(input_type())->required();
    command->add_option("--process", arguments->process, "How it is made, in place of the profile's; all: a table of all of them")
        ->check(CLI::IsMember(process_words()));
    command->add_option("--profile", arguments->profile, "Of a mesh: profile whose [process] states machine and limits")
        ->type_name("FILE.toml");
    command->add_option("--limits", arguments->limits, "Of a mesh: file of [[limits]] in the place of the rules' own, each with its reason")
        ->type_name("FILE.toml");
    command->add_option("-o,--out", arguments->out, "Of a mesh: folder for NAME_check.3mf, which shows in colours where")
        ->type_name("FOLDER");
    command->add_flag("--json", arguments->json, "As JSON");
    add_jobs(*command, arguments->jobs, "Threads for a mesh; 0 = one for each processor");
    add_force(*command, arguments->force);
    command->footer(
        "Example:\n  fusee check profiles/pnrvsa.toml\n  fusee check profiles/pnrvsa.toml --process all\n  fusee check bracket.stl "
        "--process "
        "fdm --out /tmp/bracket\n\n"
        "Exit code: 0 nothing that has to be changed (of several processes: for one of them), 1 a required change, 2 bad input, 3 a "
        "failure "
        "inside.");
    command->callback([arguments, &action] { action = [arguments] { return check(*arguments); }; });
}

}  // namespace fusee::app
