#include <memory>
#include <string>

#include "commands.h"
#include "fusee/core/provenance.h"
#include "numbers.h"
#include "usage/render.h"

namespace fusee::app {

namespace {

std::string completion_of(const std::string& shell, const Command& program) {
    if (shell == "bash") return bash_completion(program);
    return shell == "zsh" ? zsh_completion(program) : fish_completion(program);
}

int answer_text(const std::string& text, Reply& reply) {
    reply.result = {{"text", text}};
    reply.print(text);
    return 0;
}

}  // namespace

void add_completion(CLI::App& app, Action& action) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* completion = add_command(app, "completion");
    completion->add_option("shell", *shell, "Shell that reads the script")->required()->check(one_of({"bash", "zsh", "fish"}));
    completion->footer("Example:\n  source <(fusee completion bash)");
    completion->callback([shell, &app, &action] {
        action = [shell, &app](Reply& reply) { return answer_text(completion_of(*shell, read_command_tree(app)), reply); };
    });
}

void add_man(CLI::App& app, Action& action) {
    CLI::App* man = add_command(app, "man");
    man->footer("Example:\n  fusee man | man -l -");
    man->callback([&app, &action] {
        action = [&app](Reply& reply) { return answer_text(man_page(read_command_tree(app), core::version()), reply); };
    });
}

}  // namespace fusee::app
