#include "command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "command_line.h"

namespace fusee::app {

namespace {

constexpr std::string_view kFile = "FILE.", kFolder = "FOLDER", kKey = "KEY";

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

/// What CLI11 prints behind the option: "FOLDER", "TEXT:{cgal,openscad}", "INT:1 to 10000".
void read_type(Argument& argument, const std::string& type) {
    const std::size_t colon = type.find(':'), brace = type.find(":{");
    argument.value = type;
    argument.takes = Takes::kText;
    if (brace != std::string::npos) {
        argument.takes = Takes::kChoice;
        argument.words = split(std::string_view(type).substr(brace + 2, type.size() - brace - 3), ',');
        argument.value = type.substr(brace + 1);
    } else if (colon != std::string::npos) {
        argument.value = type.substr(colon + 1);
    } else if (type.starts_with(kFile)) {
        argument.takes = Takes::kFile;
        argument.words = split(std::string_view(type).substr(kFile.size()), '|');
    } else if (type == kFolder) {
        argument.takes = Takes::kFolder;
    } else if (type.starts_with(kKey)) {
        argument.takes = Takes::kKey;
    }
}

Argument read_argument(const CLI::App& app, const CLI::Option& option) {
    Argument argument;
    argument.names = split(option.get_name(option.get_positional(), !option.get_positional()), ',');
    argument.meaning = option.get_description();
    argument.default_value = option.get_default_str();
    std::erase(argument.default_value, '"');
    argument.required = option.get_required();
    argument.repeats = option.get_expected_max() >= CLI::detail::expected_max_vector_size ||
                       option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    argument.everywhere = option.get_group() == kEverywhere;
    argument.ends = &option == app.get_help_ptr() || &option == app.get_version_ptr();
    if (option.get_items_expected_max() > 0) read_type(argument, option.get_type_name());
    return argument;
}

bool is_shown(const CLI::App* app) { return !app->get_group().empty(); }

Command read_command(const CLI::App& app, const std::string& path) {
    Command command{path, app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}};
    for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return !o->get_group().empty(); }))
        (option->get_positional() ? command.positionals : command.options).push_back(read_argument(app, *option));
    for (const CLI::App* below : app.get_subcommands(is_shown))
        command.commands.push_back(read_command(*below, path + (path.empty() ? "" : " ") + below->get_name()));
    return command;
}

}  // namespace

Command read_command_tree(const CLI::App& program) { return read_command(program, ""); }

std::vector<const Command*> all_commands(const Command& command) {
    std::vector<const Command*> all{&command};
    for (const Command& below : command.commands)
        for (const Command* one : all_commands(below)) all.push_back(one);
    return all;
}

std::string headline(const std::string& text) { return text.substr(0, std::min({text.find(": "), text.find("; "), text.find(". ")})); }

}  // namespace fusee::app
