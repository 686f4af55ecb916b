#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "fusee/profile/edit.h"

namespace fusee::app {

namespace {

void print_names() {
    for (const std::string& name : profile::key_names()) fmt::print("{}\n", name);
}

}  // namespace

void add_keys(CLI::App& app, Action& action) {
    const auto names = std::make_shared<bool>(false);
    CLI::App* keys = app.add_subcommand("keys", "List every key of a profile with unit, allowed values and default");
    keys->add_flag("--names", *names, "Print only the names, one per line");
    keys->footer("Example:\n  fusee keys | less");
    keys->callback(
        [names, &action] { action = [names] { return *names ? print_names() : fmt::print("{}", profile::profile_reference()), 0; }; });
}

}  // namespace fusee::app
