#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fusee::app {

/// What an argument takes, as its type name in the help states.
enum class Takes {
    kNothing,  ///< a flag
    kText,     ///< a number or any text
    kChoice,   ///< one word of a set
    kFile,     ///< "FILE.toml|csv": a file with one of these endings
    kFolder,   ///< "FOLDER"
    kKey,      ///< "KEY" or "KEY=VALUE": a key of a profile
};

/// What CLI11 calls "UINT:0 to 1024" and "TEXT:{cgal,openscad}", for a person.
struct ValueText {
    std::string name;     ///< "NUMBER", "WORD", "FOLDER"
    std::string allowed;  ///< "0 to 1024", "cgal, openscad"; "": anything of its kind
};
[[nodiscard]] ValueText value_text(const std::string& type);

/// An option, or a positional argument.
struct Argument {
    std::vector<std::string> names;  ///< "-o", "--out"; of a positional argument: its name
    Takes takes = Takes::kNothing;
    ValueText value;
    std::vector<std::string> words;  ///< the choices, or the endings of the file
    std::string meaning, default_value;
    bool required = false, repeats = false;
    bool everywhere = false;  ///< of every command: the manual page lists it once
    bool ends = false;        ///< --help, --version: the command does nothing else
};

/// A command that the help lists, with its subcommands.
struct Command {
    std::string path;  ///< "blind make"; "" of the program
    std::string name, description, footer;
    std::vector<Argument> options, positionals;
    std::vector<Command> commands;
};

/// The program's commands as CLI11 parses them; hidden commands are left out.
[[nodiscard]] Command read_command_tree(const CLI::App& program);
/// The command and all below it, each before its subcommands.
[[nodiscard]] std::vector<const Command*> all_commands(const Command& command);
/// The text up to the first ": ", "; " or ". ": one line of a menu.
[[nodiscard]] std::string headline(const std::string& text);

}  // namespace fusee::app
