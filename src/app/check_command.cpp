#include <fmt/ranges.h>

#include "arguments.h"
#include "fusee/checks/limits.h"
#include "fusee/core/text.h"
#include "fusee/exchange/mesh_file.h"
#include "fusee/report/check.h"
#include "mesh_check.h"
#include "places.h"

namespace fusee::app {

namespace {

struct CheckArguments {
    std::filesystem::path input;
    std::string process;
    std::filesystem::path profile, limits, out;
    bool force = false;
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
            "a mesh, if --out, --profile or --limits is given; a profile has its own [[limits]], and its check writes no file");
    const profile::Profile profile = profile::read_profile(arguments.input);
    const auto kinds = arguments.process.empty() ? std::vector{profile.process.kind} : kinds_of(arguments.process);
    return with_places(profile, [&] { return pipeline::check(profile, kinds); });
}

/// The processes that make a mesh. The profile's figures apply to its own process, default figures to the others.
std::vector<Machine> machines_for(const CheckArguments& arguments) {
    std::vector<Machine> machines;
    if (!arguments.profile.empty()) {
        const profile::Profile profile = profile::read_profile(arguments.profile);
        if (!profile.has_parts) throw core::InvalidInput("--profile", arguments.profile.string(), "a profile with [process] for the mesh");
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
                                 fmt::format("the process that makes the mesh: {}", fmt::join(process_words(), ", ")));
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
                                 fmt::format("a profile (.toml) or a mesh ({}){}", fmt::join(exchange::mesh_endings(), ", "),
                                             core::did_you_mean(arguments.input.extension().string(), exchange::mesh_endings())));
    std::vector<Machine> machines = machines_for(arguments);
    for (Machine& machine : machines)
        if (!arguments.limits.empty()) machine.figures += "; [[limits]] of " + arguments.limits.filename().string();
    return check_mesh(arguments.input, machines, arguments.limits, arguments.out, arguments.force, arguments.jobs);
}

int check(const CheckArguments& arguments, Reply& reply) {
    const MeshCheck result = checked(arguments);
    const bool good = result.checked.makeable();
    const int code = good ? 0 : kRefused;
    reply.set_all(report::check_json(result.checked));
    reply.close(code, report::check_text(result.checked));
    if (!result.coloured.empty())
        reply.close(code, fmt::format("Marked in: {} (red: error, orange: warning)\n", core::printable(result.coloured.string())));
    return code;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "check", check);
    command->add_option("input", arguments->input, "Profile (.toml), or mesh (STL, OBJ, 3MF, STEP)")
        ->type_name(input_type())
        ->check(reads({FileKind::kProfile, FileKind::kMesh}, "a profile, or a mesh"))
        ->required();
    command->add_option("--process", arguments->process, "Process; replaces that of the profile. all: one table of all processes")
        ->check(one_of(process_words()));
    command->add_option("--profile", arguments->profile, "Profile whose [process] states machine and limits; for a mesh")
        ->type_name("FILE.toml")
        ->check(reads_profile());
    command->add_option("--limits", arguments->limits, "File of [[limits]], each with its reason; for a mesh")->type_name("FILE.toml");
    command->add_option("-o,--out", arguments->out, "Folder of NAME_check.3mf, which shows the findings in colours; for a mesh")
        ->type_name("FOLDER");
    add_jobs(*command, arguments->jobs, "Number of threads for a mesh; 0: one per processor");
    add_force(*command, arguments->force);
    command->footer(
        "Which family of parts can follow the law of one spring, with size, torque band, stress and friction: fusee design.\n"
        "Example:\n  fusee check profiles/pnrvsa.toml\n  fusee check profiles/pnrvsa.toml --process all\n"
        "  fusee check bracket.stl --process fdm --out /tmp/bracket\n\n"
        "Exit code: 0 no error (of several processes: for at least one), 1 an error, 2 bad input, 3 internal error.");
}

}  // namespace fusee::app
