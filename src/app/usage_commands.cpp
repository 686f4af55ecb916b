#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "fusee/core/provenance.h"
#include "numbers.h"
#include "reply.h"
#include "usage/complete.h"
#include "usage/render.h"

namespace fusee::app {

namespace {

int answer_text(const std::string& text, Reply& reply) {
    reply.result = {{"text", text}};
    reply.print(text);
    return 0;
}

}  // namespace

void add_completion(CLI::App& app, Action& action) {
    struct Asked {
        std::string of;
        std::vector<std::string> words;
    };
    const auto asked = std::make_shared<Asked>();
    CLI::App* completion = add_command(app, "completion");
    completion->add_option("shell", asked->of, "Shell that reads the script")->required()->check(one_of({"bash", "zsh", "fish", "words"}));
    completion->add_option("words", asked->words, "Of a command line; the script asks what can stand in place of the last one")->group("");
    completion->footer("Example:\n  source <(fusee completion bash)");
    completion->callback([asked, &app, &action] {
        action = [asked, &app](Reply& reply) {
            const bool script = asked->of != "words";
            return answer_text(script ? std::string(completion_script(asked->of)) : completions_of(read_command_tree(app), asked->words),
                               reply);
        };
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
