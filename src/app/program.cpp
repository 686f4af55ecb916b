#include "program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "build_name.h"
#include "catalogue.h"
#include "command_line.h"
#include "exit_codes.h"
#include "fusee/core/crash_report.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/progress.h"
#include "fusee/core/provenance.h"
#include "fusee/core/resource_error.h"
#include "output.h"
#include "source_lines.h"

namespace fusee::app {

namespace {

char** g_words = nullptr;               // the command line of this process
void (*g_pipe_handler)(int) = SIG_DFL;  // of SIGPIPE, as this process got it

/// The command as it stands in the help; the program that holds it reads the words behind it.
void add_stand_in(CLI::App& app, Action& action, const char* name) {
    CLI::App* command = add_command(app, name)->prefix_command();
    command->set_help_flag();
    command->callback([&action] { action = [](Reply&) -> int { continue_in_whole_program(); }; });
}

void add_commands(CLI::App& app, Action& action, std::span<const HeldCommand> held) {
    for (const CommandInfo& info : kCommands) {
        if (const HeldCommand* one = core::find_by(held, &HeldCommand::name, std::string_view(info.name)))
            one->add(app, action);
        else
            add_stand_in(app, action, info.name);
    }
}

/// A person who types `fusee` alone asks what it can do; under --json a command is missing.
int answer_without_command(const CLI::App& app, Reply& reply) {
    if (!reply.json()) return print_out(shown_help(app.help())), 0;
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); }))
        commands.push_back(command->get_name());
    const std::string message = fmt::format("A command is required: {}", fmt::join(commands, ", "));
    reply.fail(message);
    reply.warn(message + "\n");
    return kBadInput;
}

int refuse(const std::exception& e, Reply& reply) {
    const auto* system = dynamic_cast<const std::system_error*>(&e);
    if (dynamic_cast<const core::ResourceError*>(&e) != nullptr || (system != nullptr && core::is_lack(system->code().value())))
        reply.lack_resources();
    if (const auto* input = dynamic_cast<const core::InputError*>(&e))
        reply.fail(*input);
    else
        reply.fail(std::string(e.what()));
    reply.warn(with_source_lines(fmt::format("fusee: {}\n", e.what())));
    return kBadInput;
}

/// What the user's limit of processor time ends (SIGXCPU) is out of resources, as by other limits.
constexpr const char* kOutOfTime = "out of processor time: the limit (ulimit -t) is less than this needs";

constexpr const char* kDropped = "stopped: unfinished work is dropped";

int run(const Action& action, Reply& reply) {
    try {
        const int code = action(reply);
        if (code == kInterrupted && core::stop_signal() == SIGXCPU) throw core::Stopped();
        if (code == kInterrupted && reply.failure().empty()) reply.fail(std::string(kDropped)), reply.warn(fmt::format("{}\n", kDropped));
        return code;
    } catch (const core::InputError& e) {
        return refuse(e, reply);
    } catch (const std::system_error& e) {  // a full disk, a folder that is a file, no more threads
        return refuse(e, reply);
    } catch (const std::bad_alloc&) {
        reply.lack_resources();
        return refuse(core::InputError("out of memory: the machine or its limit (ulimit -v) has less than this needs"), reply);
    } catch (const core::Stopped&) {
        if (core::stop_signal() == SIGXCPU) return reply.lack_resources(), refuse(core::InputError(kOutOfTime), reply);
        reply.fail(std::string("stopped: nothing was written"));
        reply.warn("stopped: nothing was written\n");
        return kInterrupted;
    } catch (const std::exception& e) {
        reply.fail(std::string(e.what()));
        reply.warn(fmt::format("fusee: internal error, please report it: {}\n", e.what()));
        return kFailed;
    }
}

/// A fault is never without its report: version, command, inputs and stack.
void report_fault(const Reply& reply) {
    const std::string folder = core::write_crash_report(reply.failure().c_str());
    if (!folder.empty()) reply.warn(fmt::format("fusee: what reproduces it is in {}\n", folder));
}

int timed_run(const Action& action, Reply& reply) {
    const auto begin = std::chrono::steady_clock::now();
    const int code = run(action, reply);
    if (code == kFailed) report_fault(reply);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    reply.detail(fmt::format("{:.2f} s in all\n", seconds));
    return code;
}

/// The end of every command: under --json the envelope is all of standard output.
int finish(const Reply& reply, const std::string& command, int code) {
    if (reply.json()) print_out(reply.envelope(command, code));
    return close_out(code);
}

/// What a command says that did not end by itself after a signal (fusee/core/progress.h).
std::function<int(int)> farewell(const Settings& settings, const std::string& command) {
    const auto texts = [&](const std::string& message, int code) {
        Reply reply(settings);
        reply.fail(message);
        if (code == kBadInput) reply.lack_resources();
        return std::pair(message + "\n", settings.json ? reply.envelope(command, code) : "");
    };
    return [stopped = texts(kDropped, kInterrupted), late = texts(kOutOfTime, kBadInput)](int signal) {
        const auto& [message, envelope] = signal == SIGXCPU ? late : stopped;
        put_without_waiting(STDERR_FILENO, message);
        if (!envelope.empty()) put_without_waiting(STDOUT_FILENO, envelope);
        return signal == SIGXCPU ? kBadInput : kInterrupted;
    };
}

/// Help and version are printed; any other word that the line should not have is refused.
int finish_unparsed(const CLI::App& app, const CLI::ParseError& e, bool json) {
    if (e.get_exit_code() == 0) {
        std::ostringstream text;
        app.exit(e, text, text);
        return print_out(shown_help(text.str())), close_out(0);
    }
    Settings settings;
    settings.json = json;
    Reply reply(settings);
    const bool extra = e.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError),
               missing = e.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
    const std::string path = command_path(app), unexpected = unexpected_words(app);
    const std::string wrong = extra && !unexpected.empty() ? unexpected : e.what() + (unexpected.empty() ? "" : "\n" + unexpected);
    fail_by_argument(reply, wrong);
    reply.warn(fmt::format("{}\n{}More: fusee {}--help\n", wrong, missing ? first_example(app) : "", path.empty() ? "" : path + " "));
    return finish(reply, path, kBadInput);
}

/// A page that went back to the system costs a fault when it is asked for again: a quarter of those of `make`.
void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int kMiB = 1 << 20;
    (void)::mallopt(M_MMAP_THRESHOLD, 16 * kMiB);
    (void)::mallopt(M_TRIM_THRESHOLD, 64 * kMiB);
    (void)::mallopt(M_TOP_PAD, kMiB);
#endif
}

/// `fusee help COMMAND` is `fusee COMMAND --help`, here and in the program that continues this one.
char** with_help_last(int argc, char** argv) {
    static char help[] = "--help";
    static std::vector<char*> words;
    if (argc < 2 || std::string_view(argv[1]) != "help") return argv;
    words.assign(argv, argv + argc);
    words.erase(words.begin() + 1);
    words.insert(words.end(), {help, nullptr});
    return words.data();
}

/// Is the help of a command asked that does not exist? `fusee help mkae`
bool is_help_of_nothing(const CLI::App& app, const CLI::ParseError& e) {
    const std::vector<std::string> unknown = app.remaining();
    return e.get_name() == "CallForHelp" && !unknown.empty() && !unknown.front().starts_with('-');
}

}  // namespace

CLI::App* add_command(CLI::App& app, const char* name) {
    const CommandInfo* info = core::find_by(kCommands, &CommandInfo::name, std::string_view(name));
    return app.add_subcommand(info->name, info->description)->group(info->group);
}

void continue_in_whole_program() {
    std::error_code none;
    const char* launcher = std::getenv("FUSEE_LAUNCHER");
    const fs::path whole = launcher != nullptr ? fs::path(launcher) : fs::read_symlink("/proc/self/exe", none).parent_path() / "fusee";
    std::signal(SIGPIPE, g_pipe_handler);
    (void)::setenv("FUSEE_DOOR", "whole", 1);
    (void)::execv(whole.c_str(), g_words);
    throw core::InputError(fmt::format("{}: this program holds a part of fusee's commands, and the whole one, {}, does not start",
                                       g_words[0], whole.string()));
}

int run_program(int argc, char** argv, std::span<const HeldCommand> held) {
    keep_freed_memory();
    keep_standard_files();
    g_words = argv = with_help_last(argc, argv);
    g_pipe_handler = std::signal(SIGPIPE, SIG_IGN);  // a reader that leaves is noticed when it is written to (output.h)
    core::catch_interrupts();
    CLI::App app("Turn the spring energies of a variable-stiffness joint into cams, check and export them, and diagnose the built joint",
                 "fusee");
    app.set_version_flag("-V,--version", fmt::format("fusee {} ({})", core::version(), build_name()));
    app.require_subcommand(0, 1);  // a missing command is refused below: CLI11 would not name a wrong word
    app.footer(
        "Example:\n  fusee make profiles/pnrvsa.toml\n  fusee explain cable.bend_ratio\n\n"
        "Exit code: 0 done, 1 a design cannot be made, 2 bad input, 3 internal error, 130 stopped by Ctrl-C or a signal.\n\n"
        "Help of a command:\n  fusee help COMMAND\nCompletion in bash (also zsh, fish):\n  source <(fusee completion bash)");
    core::begin_crash_reports(fmt::format("fusee {} ({})", core::version(), build_name()), {argv, argv + argc});
    Action action;
    add_commands(app, action, held);
    Settings settings;
    add_settings(app, settings);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        const bool json = asks_for_json(argc, argv);
        return is_help_of_nothing(app, e) ? finish_unparsed(app, CLI::ExtrasError(app.remaining()), json) : finish_unparsed(app, e, json);
    }
    Reply reply(settings);
    core::end_after_signal(farewell(settings, command_path(app)));
    if (settings.quiet) core::hide_progress();
    if (settings.quiet && settings.verbose)
        action = [](Reply&) -> int { throw core::InvalidInput("--quiet", "with --verbose", "one of the two"); };
    const int code = action ? timed_run(action, reply) : answer_without_command(app, reply);
    return finish(reply, command_path(app), code);
}

}  // namespace fusee::app
