#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"

namespace fusee::app {

namespace {

struct SimulateArguments {
    std::vector<std::filesystem::path> paths;
    std::filesystem::path out = "out";
    pipeline::SimulateOptions options;
    unsigned jobs = 0;
};

int simulate(const SimulateArguments& arguments) {
    core::catch_interrupts();
    if (arguments.paths.empty()) throw core::InvalidInput("simulate", "no profile", "at least one profile (*.toml) or folder of them");
    const auto rows = batch::simulate_all(batch::find_profiles(arguments.paths), arguments.out, arguments.options, arguments.jobs);
    const int code = batch::exit_code(rows);
    fmt::print(code == 0 ? stdout : stderr, "{}", batch::closing_table(rows));
    return code;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
    constexpr int kMostLevels = 1000;
    constexpr double kLargestPush = 1e4;
    const auto arguments = std::make_shared<SimulateArguments>();
    CLI::App* command = app.add_subcommand(
        "simulate", "Say what the joints of profiles do: out/NAME with dead_band.csv, simulation.json and a page of pictures");
    command->add_option("profiles", arguments->paths, "Profiles (*.toml), or folders of them: at least one");
    command->add_option("-o,--out", arguments->out, "Folder that gets one folder per profile; what lies there already stays")
        ->capture_default_str();
    command->add_option("--levels", arguments->options.levels, "Levels of co-contraction in place of the profile's")
        ->check(CLI::Range(2, kMostLevels));
    command
        ->add_option("--push-torque", arguments->options.push_torque, "Joint torque of the push-and-release test [Nm]; 0 = strong enough")
        ->check(CLI::Range(0.0, kLargestPush));
    command->add_option("-j,--jobs", arguments->jobs, "Profiles simulated at the same time; 0 = one for each processor")
        ->capture_default_str();
    command->footer(
        "Example:\n  fusee simulate profiles/pnrvsa.toml\n  fusee simulate profiles/relatives --levels 5\n\n"
        "Exit code: 0 all simulated, 1 a law cannot be (the binding limit and the nearest feasible change are printed),\n"
        "2 bad input (file, line and key are named), 3 a failure inside, 130 stopped by Ctrl-C.");
    command->callback([arguments, &action] { action = [arguments] { return simulate(*arguments); }; });
}

}  // namespace fusee::app
