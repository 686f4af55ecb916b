#include "command_tree.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "command_line.h"
#include "fusee/core/lists.h"

namespace fusee::app {

namespace {

constexpr std::string_view kFile = "FILE.", kFolder = "FOLDER", kKey = "KEY";

/// "cgal", "openscad" of "TEXT:{cgal,openscad}"; none of another type.
std::vector<std::string> choices(const std::string& type) {
    const std::size_t brace = type.find(":{");
    if (brace == std::string::npos) return {};
    return core::pieces_of<std::string>(std::string_view(type).substr(brace + 2, type.size() - brace - 3), ",");
}

void read_type(Argument& argument, const std::string& type) {
    argument.value = value_text(type);
    argument.takes = Takes::kText;
    argument.words = choices(type);
    if (!argument.words.empty()) {
        argument.takes = Takes::kChoice;
    } else if (type.starts_with(kFile)) {
        argument.takes = Takes::kFile;
        argument.words = core::pieces_of<std::string>(std::string_view(type).substr(kFile.size()), "|");
    } else if (type == kFolder) {
        argument.takes = Takes::kFolder;
    } else if (type.starts_with(kKey)) {
        argument.takes = Takes::kKey;
    }
}

Argument read_argument(const CLI::App& app, const CLI::Option& option) {
    Argument argument;
    argument.names = core::pieces_of<std::string>(option.get_name(option.get_positional(), !option.get_positional()), ",");
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

ValueText value_text(const std::string& type) {
    const std::string kind = type.substr(0, type.find(':'));
    if (const std::vector<std::string> words = choices(type); !words.empty()) return {"WORD", fmt::format("{}", fmt::join(words, ", "))};
    const bool number = kind == "UINT" || kind == "INT" || kind == "FLOAT";
    return {number ? "NUMBER" : kind, kind.size() == type.size() ? "" : type.substr(kind.size() + 1)};
}

Command read_command_tree(const CLI::App& program) { return read_command(program, ""); }

std::vector<const Command*> all_commands(const Command& command) {
    std::vector<const Command*> all{&command};
    for (const Command& below : command.commands)
        for (const Command* one : all_commands(below)) all.push_back(one);
    return all;
}

std::string headline(const std::string& text) { return text.substr(0, std::min({text.find(": "), text.find("; "), text.find(". ")})); }

}  // namespace fusee::app
