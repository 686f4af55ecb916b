#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "commands.h"
#include "exit_codes.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/core/provenance.h"
#include "fusee/exchange/mesh_isolated.h"

namespace fusee::app {

namespace {

void add_commands(CLI::App& app, Action& action) {
    for (const auto& add : {add_make,     add_batch,     add_query,    add_fix,     add_budget,        add_springs, add_simulate,
                            add_identify, add_design,    add_diagnose, add_predict, add_case_template, add_blind,   add_paper,
                            add_coupons,  add_calibrate, add_check,    add_rules,   add_keys,          add_usage})
        add(app, action);
}

int refuse_without_command(const CLI::App& app) {
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); }))
        commands.push_back(command->get_name());
    fmt::print(stderr, "A command is required: {}\nRun with --help for more information.\n", fmt::join(commands, ", "));
    return kBadInput;
}

int refuse(const std::exception& e) {
    fmt::print(stderr, "fusee: {}\n", e.what());
    return kBadInput;
}

/// Flushes standard output; reports a table that could not be written.
int with_output(int code) {
    std::cout.flush();
    const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
    if (!lost) return code;
    fmt::print(stderr, "fusee: standard output cannot be written: {}\n", errno != 0 ? std::strerror(errno) : "it is closed");
    return std::max(code, kBadInput);
}

/// Opens closed standard files: otherwise the next opened file would take their number and receive the output.
void keep_standard_files() {
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(file, F_GETFD) < 0) (void)::open("/dev/null", O_RDONLY);  // takes the lowest free number; writing to it fails
}

int run(const Action& action) {
    try {
        return action();
    } catch (const core::InputError& e) {
        return refuse(e);
    } catch (const std::system_error& e) {  // a full disk, a folder that is a file, no more threads
        return refuse(e);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "fusee: out of memory: the machine or its limit (ulimit -v) has less than this needs\n");
        return kBadInput;
    } catch (const core::Stopped&) {
        fmt::print(stderr, "stopped: nothing was written\n");
        return kInterrupted;
    } catch (const std::exception& e) {
        fmt::print(stderr, "fusee: internal error, please report it: {}\n", e.what());
        return kFailed;
    }
}

}  // namespace

}  // namespace fusee::app

int main(int argc, char** argv) {
    using namespace fusee;
    app::keep_standard_files();
    if (argc == 3 && std::string_view(argv[1]) == exchange::kReadMesh) return exchange::serve_mesh_file(argv[2]);  // for mesh_check.cpp
    CLI::App app("Turn the spring energies of a variable-stiffness joint into cams, check and export them, and diagnose the built joint",
                 "fusee");
    app.set_version_flag("--version", core::version());
    app.require_subcommand(0, 1);  // a missing command is refused below: CLI11 would not name a wrong word
    app.footer(
        "Example:\n  fusee make profiles/pnrvsa.toml\n\n"
        "Exit code: 0 done, 1 a design cannot be made, 2 bad input, 3 internal error, 130 stopped by Ctrl-C.\n\n"
        "Help of a command:\n  fusee COMMAND --help\nCompletion in bash (also zsh, fish):\n  source <(fusee completion bash)");
    app::Action action;
    app::add_commands(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? app::with_output(0) : app::kBadInput;
    }
    return action ? app::with_output(app::run(action)) : app::refuse_without_command(app);
}
