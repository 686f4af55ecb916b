#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "reply.h"

namespace fusee::app {

/// Group of the help with the options of every command.
inline constexpr const char* kEverywhere = "Options of every command";

/// --json, --color, -q, -v of the program and of each command below it, so that they work before and after a command.
void add_settings(CLI::App& program, Settings& settings);

/// The command that the line names, "blind make"; "" for none.
[[nodiscard]] std::string command_path(const CLI::App& program);

/// A help for the reader of standard output: on a terminal in lines of its width.
[[nodiscard]] std::string shown_help(const std::string& text);

/// "--jbos: there is no such option; did you mean --jobs?", "mkae: there is no such command; did you mean make?": a line for each word that
/// no command expected.
[[nodiscard]] std::string unexpected_words(const CLI::App& program);

/// The first example of the command's help, "Example: fusee init my_joint.toml\n"; "" if it has none.
[[nodiscard]] std::string first_example(const CLI::App& program);

/// Is there a --json on the line? Asked where the line cannot be parsed.
[[nodiscard]] bool asks_for_json(int argc, char** argv);

/// A message of CLI11 as fusee's error: "--jobs: two (allowed: ...)" names field, value and what is allowed.
void fail_by_argument(Reply& reply, const std::string& message);

}  // namespace fusee::app
