#include <fmt/format.h>
#include <fmt/ranges.h>

#include "render.h"

namespace fusee::app {

namespace {

// clang-format off
constexpr const char* kHead = R"script(# bash completion for fusee, printed by `fusee completion bash`
# shellcheck shell=bash disable=SC2207  # one word per line, whatever spaces it holds

_fusee_words() {
    local word=$1
    shift
    mapfile -t COMPREPLY < <(compgen -W "$*" -- "$word")
}

_fusee_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$1")
}

# Folders, and files with one of these endings.
_fusee_files() {
    local IFS=$'\n' word=$1 ending
    _fusee_folders "$word"
    shift
    for ending; do COMPREPLY+=($(compgen -f -X "!*.$ending" -- "$word")); done
}

# The keys of a profile; the program prints them.
_fusee_keys() {
    compopt -o nospace 2>/dev/null
    _fusee_words "$1" "$("${COMP_WORDS[0]}" keys --names 2>/dev/null)"
}

_fusee() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
    COMPREPLY=()
    # --out=FOLDER arrives as three words.
    [ "$before" = = ] && before=${COMP_WORDS[COMP_CWORD - 2]}
    [ "$word" = = ] && word=''
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$command ${COMP_WORDS[i]}" in
            @COMMANDS@) command+=" ${COMP_WORDS[i]}" ;;
        esac
    done
    case $command in
)script";

constexpr const char* kTail = R"script(    esac
}

complete -F _fusee fusee
)script";
// clang-format on

std::string bash_values(const Argument& argument) {
    switch (argument.takes) {
        case Takes::kChoice:
            return fmt::format("_fusee_words \"$word\" {} ", fmt::join(argument.words, " "));
        case Takes::kFile:
            return fmt::format("_fusee_files \"$word\" {} ", fmt::join(argument.words, " "));
        case Takes::kFolder:
            return "_fusee_folders \"$word\" ";
        case Takes::kKey:
            return "_fusee_keys \"$word\" ";
        case Takes::kNothing:
        case Takes::kText:
            break;
    }
    return "";
}

std::string menu(const Command& command) {
    std::vector<std::string> words;
    for (const Command& below : command.commands) words.push_back(below.name);
    for (const Argument& option : command.options) words.push_back(option.long_name());
    return fmt::format("_fusee_words \"$word\" {} ", fmt::join(words, " "));
}

/// The words after `command`: the value of an option, an option, a positional argument.
std::string branch(const Command& command) {
    std::string text = fmt::format("        '{}')\n            case $word:$before in\n", command.path.empty() ? "" : " " + command.path);
    for (const Argument& option : command.options)
        if (option.takes != Takes::kNothing)
            text += fmt::format("                *:{}) {};;\n", fmt::join(option.names, " | *:"), bash_values(option));
    if (command.positionals.empty()) {
        text += fmt::format("                *) {};;\n", menu(command));
    } else {
        text += fmt::format("                -*) {};;\n", menu(command));
        text += fmt::format("                *) {};;\n", bash_values(command.positionals.front()));
    }
    return text + "            esac ;;\n";
}

}  // namespace

std::string bash_completion(const Command& program) {
    std::string branches;
    for (const Command* command : all_commands(program)) branches += branch(*command);
    return insert_paths(kHead, program, " | ") + branches + kTail;
}

}  // namespace fusee::app
