#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <iostream>
#include <map>
#include <memory>

#include "arguments.h"
#include "commands.h"
#include "exit_codes.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"
#include "fusee/report/init.h"
#include "fusee/search/design.h"
#include "fusee/search/init.h"
#include "output.h"

namespace fusee::app {

namespace {

namespace fs = std::filesystem;

struct InitArguments {
    std::vector<std::string> columns;
    fs::path profile;
    std::map<std::string, std::string> answers;  // option to text
    bool yes = false;
    unsigned jobs = 0;
};

/// The file must be new, and its name that of a design.
void require_new(const fs::path& file) {
    if (file.extension() != ".toml") throw core::InvalidInput("init", file.string(), "a file name that ends in .toml");
    if (!profile::is_name(file.stem().string()))
        throw core::InvalidInput("init", file.string(), std::string("a file whose name without .toml is ") + profile::kAllowedName);
    core::require_new_file(file, false);
}

/// Waits for a line of the terminal: reading it would go on after Ctrl-C. @returns false after Ctrl-C
bool is_answered() {
    while (!core::interrupted()) {
        pollfd waiting{STDIN_FILENO, POLLIN, 0};
        if (::poll(&waiting, 1, -1) > 0) return true;
    }
    return false;
}

/// Asks again until the answer is allowed. @throws core::Stopped at the end of the input and after Ctrl-C
void ask(const search::init::Question& question, search::init::Answers& answers) {
    while (true) {
        print_out(question.prompt(answers));
        std::string line;
        if (!flush_out() || !is_answered() || !std::getline(std::cin, line)) {
            print_out("\n");
            throw core::Stopped();
        }
        if (line.empty()) return;
        try {
            return question.enter(answers, line);
        } catch (const core::InputError& e) {
            print_out(fmt::format("  {}\n", e.what()));
        }
    }
}

/// Options first; then, on a terminal, without --yes and --json, the questions that no option answers.
search::init::Answers answers_of(const InitArguments& arguments, const Reply& reply) {
    search::init::Answers answers;
    answers.columns = core::CsvMapping::of(arguments.columns);
    core::Mistakes mistakes;
    for (const search::init::Question& question : search::init::questions())
        if (const auto given = arguments.answers.find(question.option); given != arguments.answers.end())
            mistakes.collect([&] { question.enter(answers, given->second); });
    mistakes.throw_if_any();
    if (!arguments.yes && !reply.json() && ::isatty(STDIN_FILENO) != 0) {
        print_out("Enter takes the value in brackets; Ctrl-C leaves no file.\n");
        for (const search::init::Question& question : search::init::questions())
            if (!arguments.answers.contains(question.option)) ask(question, answers);
    }
    return answers;
}

constexpr std::size_t kSteps = 20;  ///< of the bar

int run_init(const InitArguments& arguments, Reply& reply) {
    require_thread();
    require_new(arguments.profile);
    const search::init::Answers answers = answers_of(arguments, reply);
    search::init::require_consistent(answers);
    const std::string name = arguments.profile.stem().string();
    search::init::Result result;
    {
        core::Progress progress("init", kSteps);
        const auto show = [&](double share, const std::string& step) { progress.reach(std::size_t(share * kSteps), step); };
        result = search::init::find_design(name, answers, {.jobs = arguments.jobs, .progress = show, .stop = core::interrupted});
    }
    if (!result.design) {
        reply.warn(report::init_text(result, arguments.profile.string()));
        return kRefused;
    }
    result.design->profile = search::codesign::moved(result.design->profile, fs::absolute(arguments.profile).parent_path());
    core::require_new_file(arguments.profile, false);  // it may have appeared since
    core::write_file(arguments.profile, search::init::profile_text(*result.design, answers));
    reply.result = {{"profile", arguments.profile.string()}};
    reply.say(report::init_text(result, arguments.profile.string()));
    return 0;
}

}  // namespace

void add_init(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<InitArguments>();
    CLI::App* command = add_command(app, "init");
    command->add_option("profile", arguments->profile, "Profile to write (*.toml); an existing file is refused")
        ->type_name("FILE.toml")
        ->required();
    const search::init::Answers defaults;
    for (const search::init::Question& question : search::init::questions())
        command
            ->add_option_function<std::string>(
                question.option, [arguments, option = question.option](const std::string& text) { arguments->answers[option] = text; },
                fmt::format("{}{}{} ({}); default: {}", question.text, question.unit.empty() ? "" : ", ", question.unit, question.allowed,
                            question.shown(defaults)))
            ->type_name("VALUE");
    add_columns(*command, arguments->columns);
    command->add_flag("-y,--yes", arguments->yes, "Ask nothing: the defaults answer what no option answers");
    add_jobs(*command, arguments->jobs, "Number of threads; 0: one per processor. The result does not depend on it");
    command->footer(
        "Example:\n  fusee init my_joint.toml\n  fusee init my_joint.toml --torque 1 --friction 0.05 --cable 'dyneema 0.8' --shaft 6 "
        "--yes\n\n"
        "Exit code: 0 the profile is written, 1 no such joint can be made (the binding limit and the nearest change are printed, nothing\n"
        "is written), 2 bad input, or the file exists, 3 internal error, 130 stopped by Ctrl-C: nothing is written.");
    command->callback([arguments, &action] { action = [arguments](Reply& reply) { return run_init(*arguments, reply); }; });
}

}  // namespace fusee::app
