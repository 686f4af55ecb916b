#include <fmt/format.h>
#include <fmt/ranges.h>

#include "render.h"

namespace fusee::app {

namespace {

// clang-format off
constexpr const char* kHead = R"script(# fish completion for fusee, printed by `fusee completion fish`

# Is this the command that is typed?
function __fusee_at
    set -l words (commandline -opc)
    set -e words[1]
    set -l path
    for word in $words
        if contains -- "$path $word" @COMMANDS@
            set path "$path $word"
        end
    end
    test "$path" = "$argv"
end

# Folders, and files with one of these endings.
function __fusee_files
    __fish_complete_path (commandline -ct) | string match -r -- '.*(?:/|\.(?:'(string join '|' $argv)'))(?:\t.*)?$'
end

# The keys of a profile; the program prints them.
function __fusee_keys
    set -l words (commandline -opc)
    $words[1] keys --names 2>/dev/null
end

complete -c fusee -f
)script";
// clang-format on

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') out += '\\';
        out += c;
    }
    return out + "'";
}

/// The arguments of `complete` that offer the values.
std::string fish_values(const Argument& argument) {
    switch (argument.takes) {
        case Takes::kChoice:
            return fmt::format(" -a '{}'", fmt::join(argument.words, " "));
        case Takes::kFile:
            return fmt::format(" -a '(__fusee_files {})'", fmt::join(argument.words, " "));
        case Takes::kFolder:
            return " -a '(__fish_complete_directories)'";
        case Takes::kKey:
            return " -a '(__fusee_keys)'";
        case Takes::kNothing:
        case Takes::kText:
            break;
    }
    return "";
}

std::string option_line(const std::string& at, const Argument& option) {
    std::string line = at;
    for (const std::string& name : option.names) line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.takes != Takes::kNothing) line += " -x" + fish_values(option);
    return line + " -d " + quoted(headline(option.meaning)) + "\n";
}

std::string lines(const Command& command) {
    const std::string at = fmt::format("complete -c fusee -n \"__fusee_at '{}'\"", command.path.empty() ? "" : " " + command.path);
    std::string text = "\n";
    for (const Command& below : command.commands) text += at + " -a " + below.name + " -d " + quoted(headline(below.description)) + "\n";
    for (const Argument& positional : command.positionals) text += at + fish_values(positional) + "\n";
    for (const Argument& option : command.options) text += option_line(at, option);
    return text;
}

}  // namespace

std::string fish_completion(const Command& program) {
    std::string all = insert_paths(kHead, program, " ");
    for (const Command* command : all_commands(program)) all += lines(*command);
    return all;
}

}  // namespace fusee::app
