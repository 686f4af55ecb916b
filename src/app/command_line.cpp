#include "command_line.h"

#include <unistd.h>

#include <memory>
#include <regex>
#include <sstream>
#include <string_view>

#include "numbers.h"
#include "usage/command_tree.h"

namespace fusee::app {

namespace {

constexpr std::size_t kColumn = 20;  // of the explanations in a help

/// The last command that the line names.
const CLI::App* named(const CLI::App* program) {
    while (!program->get_subcommands().empty()) program = program->get_subcommands().front();
    return program;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> command_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; })) names.push_back(below->get_name());
    return names;
}

/// A line for each word that this command did not expect before the next command. Words behind an unknown command are its own.
std::string unexpected_of(const CLI::App& command) {
    std::vector<std::string> commands = command_names(command);
    if (command.get_parent() == nullptr) commands.emplace_back("help");
    std::string text;
    bool unknown = false;
    for (const std::string& word : command.remaining()) {
        const bool option = word.starts_with('-');
        if (!option && !commands.empty() && std::exchange(unknown, true)) continue;
        const char* what = option ? "there is no such option" : commands.empty() ? "is one argument too many" : "there is no such command";
        const std::string near = core::did_you_mean(word.substr(0, word.find('=')), option ? option_names(command) : commands);
        text += fmt::format("{}: {}{}\n", core::printable(word, 60), what, near);
    }
    return text;
}

/// "--shard, --merge"
std::string listed(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options)
        names.push_back(option->get_lnames().empty() ? option->get_name() : "--" + option->get_lnames().front());
    std::sort(names.begin(), names.end());
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Lists each command with the first part of its description; the rest is in the command's own help. What a value may be, and its default,
/// stand in words behind the meaning: CLI11 writes "UINT:0 to 1024=0".
class Help : public CLI::Formatter {
public:
    std::string make_option_opts(const CLI::Option* option) const override {
        if (option->get_type_size() == 0) return "";
        const bool repeats = option->get_expected_max() == CLI::detail::expected_max_vector_size;
        return " " + value_text(option->get_type_name()).name + (repeats ? " ..." : "");
    }
    std::string make_option_desc(const CLI::Option* option) const override {
        const bool takes = option->get_type_size() != 0;
        std::vector<std::string> more;
        if (const std::string allowed = value_text(option->get_type_name()).allowed; takes && !allowed.empty()) more.push_back(allowed);
        if (takes && !option->get_default_str().empty()) more.push_back("default " + option->get_default_str());
        if (option->get_required() && !option->get_positional()) more.emplace_back("required");
        if (!option->get_needs().empty()) more.push_back("with " + listed(option->get_needs()));
        if (!option->get_excludes().empty()) more.push_back("not with " + listed(option->get_excludes()));
        return option->get_description() + (more.empty() ? "" : fmt::format(" [{}]", fmt::join(more, "; ")));
    }
    std::string make_subcommand(const CLI::App* command) const override {
        std::ostringstream line;
        CLI::detail::format_help(line, command->get_name(), headline(command->get_description()), get_column_width());
        return line.str();
    }
};

}  // namespace

void add_settings(CLI::App& program, Settings& settings) {
    const auto add = [&settings](CLI::App& app) {
        app.add_flag("--json", settings.json, "Print one JSON object instead of text (docs/json.md)")->group(kEverywhere);
        app.add_option("--color", settings.colour, "Colour of severity words; auto: on a terminal, unless NO_COLOR is set")
            ->check(one_of({"auto", "always", "never"}))
            ->default_str("auto")
            ->group(kEverywhere);
        app.add_flag("-q,--quiet", settings.quiet, "Print errors and what was asked for; no progress")->group(kEverywhere);
        app.add_flag("-v,--verbose", settings.verbose, "Print more: times of the stages, what was not judged")->group(kEverywhere);
    };
    add(program);
    auto help = std::make_shared<Help>();
    help->column_width(kColumn);
    help->label("Positionals", "Arguments");
    help->label("SUBCOMMAND", "COMMAND");
    program.formatter(help);
    for (CLI::App* below : program.get_subcommands([](const CLI::App*) { return true; })) add_settings(*below, settings);
}

std::string command_path(const CLI::App& program) {
    std::string path;
    for (const CLI::App* app = &program; !app->get_subcommands().empty();) {
        app = app->get_subcommands().front();
        path += (path.empty() ? "" : " ") + app->get_name();
    }
    return path;
}

std::string shown_help(const std::string& text) {
    return core::is_terminal(STDOUT_FILENO) ? core::fitted(text, core::terminal_columns(), kColumn) : text;
}

std::string unexpected_words(const CLI::App& program) {
    std::string text = unexpected_of(program);
    for (const CLI::App* app = &program; !app->get_subcommands().empty();) {
        app = app->get_subcommands().front();
        text += unexpected_of(*app);
    }
    return text.substr(0, text.find_last_not_of('\n') + 1);
}

std::string first_example(const CLI::App& program) {
    static const std::regex kFirst(R"(Example:\n +([^\n]+))");
    const std::string footer = named(&program)->get_footer();
    std::smatch found;
    return std::regex_search(footer, found, kFirst) ? "Example: " + found[1].str() + "\n" : "";
}

bool asks_for_json(int argc, char** argv) {
    return std::any_of(argv + 1, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
}

void fail_by_argument(Reply& reply, const std::string& message) {
    static const std::regex kParts(R"(^(-{0,2}[A-Za-z_-]+): (.*) \(allowed: (.*)\)$)");
    std::smatch parts;
    if (std::regex_match(message, parts, kParts))
        reply.fail(message, {core::InvalidInput(parts[1], parts[2], parts[3])});
    else
        reply.fail(message);
}

}  // namespace fusee::app
