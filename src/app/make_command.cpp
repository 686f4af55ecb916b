#include <fmt/format.h>

#include <memory>

#include "arguments.h"
#include "commands.h"
#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/profile/find_profiles.h"

namespace fusee::app {

namespace {

struct MakeArguments {
    std::vector<std::filesystem::path> paths;
    batch::MakeOptions options;
    std::string via = to_string(options.via);
    unsigned jobs = 0;
};

int make(const MakeArguments& arguments) {
    core::catch_interrupts();
    require_thread();
    if (arguments.paths.empty()) throw core::InvalidInput("make", "no profile", "at least one profile (*.toml) or folder of profiles");
    const auto rows = batch::make_all(profile::find_profiles(arguments.paths), arguments.options, arguments.jobs);
    const int code = batch::exit_code(rows);
    fmt::print(code == 0 ? stdout : stderr, "{}", batch::closing_table(rows));
    return code;
}

}  // namespace

void add_make(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<MakeArguments>();
    CLI::App* command =
        app.add_subcommand("make", "Make checked cams from profiles: out/NAME with STL, 3MF, DXF, SCAD, PART.json and a report");
    command->add_option("profiles", arguments->paths, "One or more profiles (*.toml) or folders of profiles")->type_name("FILE.toml");
    command->add_option("-o,--out", arguments->options.out, "Folder of the results; each design gets a folder in it")
        ->type_name("FOLDER")
        ->capture_default_str();
    command->add_option("--via", arguments->via, "Kernel that makes the STL: cgal (direct and fast) or openscad (independent, slower)")
        ->check(CLI::IsMember({"cgal", "openscad"}))
        ->capture_default_str();
    add_force(*command, arguments->options.force);
    add_jobs(*command, arguments->jobs, "Number of designs made at the same time; 0: one per processor");
    command->footer(
        "Example:\n  fusee make profiles/pnrvsa.toml\n  fusee make profiles --out /tmp/cams --jobs 2\n\n"
        "Exit code: 0 all designs are made, 1 a design cannot be made (its binding limit and the nearest feasible change are printed),\n"
        "2 bad input (file, line and key are named), 3 internal error, 130 stopped by Ctrl-C. A design "
        "that is not made leaves no file.");
    command->callback([arguments, &action] {
        arguments->options.via = arguments->via == "cgal" ? pipeline::Via::kCgal : pipeline::Via::kOpenScad;
        action = [arguments] { return make(*arguments); };
    });
}

}  // namespace fusee::app
