#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "fusee/core/text.h"
#include "render.h"

namespace fusee::app {

namespace {

// clang-format off
constexpr const char* kHead = R"script(#compdef fusee
# zsh completion for fusee, printed by `fusee completion zsh`; as _fusee in a folder of $fpath, or sourced

# The keys of a profile; the program prints them.
__fusee_keys() {
    local -a keys=(${(f)"$(_call_program keys $program keys --names 2>/dev/null)"})
    compadd -S '' -a keys
}
)script";

constexpr const char* kTail = R"script(
if [[ $funcstack[1] == _fusee ]]; then
    _fusee "$@"
else
    compdef _fusee fusee
fi
)script";
// clang-format on

/// An explanation as _arguments takes it: "[Folder of the results]".
std::string bracketed(std::string_view text) {
    std::string out = "[";
    for (const char c : text) {
        if (c == '[' || c == ']') out += '\\';
        out += c;
    }
    return out + "]";
}

/// ":MESSAGE:ACTION" of _arguments.
std::string zsh_values(const Argument& argument) {
    switch (argument.takes) {
        case Takes::kNothing:
            return "";
        case Takes::kChoice:
            return fmt::format("':choice:({})'", fmt::join(argument.words, " "));
        case Takes::kFile:
            return fmt::format("':file:_files -g \"*.({})(-.)\"'", fmt::join(argument.words, "|"));
        case Takes::kFolder:
            return "':folder:_files -/'";
        case Takes::kKey:
            return "':key:__fusee_keys'";
        case Takes::kText:
            break;
    }
    return core::shell_word(":" + headline(argument.value) + ": ");
}

/// '(-o --out)'{-o+,--out=}'[Folder of the results]'':folder:_files -/'
std::string option_spec(const Argument& option) {
    const bool valued = option.takes != Takes::kNothing;
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(name + (!valued ? "" : name.starts_with("--") ? "=" : "+"));
    const std::string excluded = option.ends ? "- *" : fmt::format("{}", fmt::join(option.names, " "));
    std::string spec = option.repeats ? "'*'" : "'(" + excluded + ")'";
    spec += names.size() == 1 ? names.front() : fmt::format("{{{}}}", fmt::join(names, ","));
    return spec + core::shell_word(bracketed(headline(option.meaning))) + zsh_values(option);
}

std::string positional_spec(const Argument& positional, std::size_t number) {
    return (positional.repeats ? "'*'" : fmt::format("'{}'", number)) + zsh_values(positional);
}

std::string function_name(const Command& command) {
    std::string name = "_fusee";
    if (!command.path.empty()) name += "_" + command.path;
    for (char& c : name)
        if (c == ' ') c = '_';
    return name;
}

/// The function of a command with subcommands: it calls the function of the one that is typed.
std::string dispatch(const Command& command, const std::string& name) {
    std::string menu;
    for (const Command& below : command.commands)
        menu += "        " + core::shell_word(fmt::format("{}:{}", below.name, headline(below.description))) + "\n";
    return fmt::format(
        " \\\n        '1:command:->command' '*::argument:->argument'\n"
        "    local -a menu=(\n{}    )\n"
        "    case $state in\n"
        "        command) _describe command menu ;;\n"
        "        argument) (($+functions[{}_$words[1]])) && {}_$words[1] ;;\n"
        "    esac\n",
        menu, name, name);
}

std::string function(const Command& command) {
    const std::string name = function_name(command);
    std::string text = "\n" + name + "() {\n";
    if (command.path.empty()) text += "    local program=$words[1]\n";
    if (!command.commands.empty()) text += "    local context state state_descr line curcontext=$curcontext\n    typeset -A opt_args\n";
    text += command.commands.empty() ? "    _arguments -s" : "    _arguments -s -C";
    for (const Argument& option : command.options) text += " \\\n        " + option_spec(option);
    std::size_t number = 0;
    for (const Argument& positional : command.positionals) text += " \\\n        " + positional_spec(positional, ++number);
    return text + (command.commands.empty() ? "\n" : dispatch(command, name)) + "}\n";
}

}  // namespace

std::string zsh_completion(const Command& program) {
    std::string text = kHead;
    for (const Command* command : all_commands(program)) text += function(*command);
    return text + kTail;
}

}  // namespace fusee::app
