#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

#include "commands.h"
#include "completions.h"
#include "fusee/profile/profile.h"

namespace fusee::app {

namespace {

int print_completion(const std::string& shell) {
    const std::map<std::string, std::string_view> scripts{{"bash", kBashCompletion}, {"zsh", kZshCompletion}, {"fish", kFishCompletion}};
    fmt::print("{}", scripts.at(shell));
    return 0;
}

}  // namespace

void add_lists(CLI::App& app, Action& action) {
    CLI::App* keys = app.add_subcommand("keys", "List every key of a profile with unit, allowed values and default");
    keys->footer("Example:\n  fusee keys | less");
    keys->callback([&action] { action = [] { return fmt::print("{}", profile::profile_reference()), 0; }; });

    const auto shell = std::make_shared<std::string>();
    CLI::App* completion = app.add_subcommand("completion", "Print the completion script of a shell");
    completion->add_option("shell", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
    completion->footer("Example:\n  source <(fusee completion bash)");
    completion->callback([shell, &action] { action = [shell] { return print_completion(*shell); }; });
}

}  // namespace fusee::app
