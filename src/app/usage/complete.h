#pragma once
#include <string>
#include <vector>

#include "command_tree.h"

namespace fusee::app {

/// What can stand in place of the last of `words`, which are those behind the program's name; the last one may be empty or begun. A line
/// each:
///     WORD<tab>MEANING   begins as the last word does; the meaning may be missing
///     /folders           folders
///     /files toml|csv    folders, and files with one of these endings
///     /open              no space follows the word
///     /behind --out=     only what is behind this in the last word is completed
/// The scripts of the shells (completions/) read them. Bash's "--out", "=", "FOLDER" is one word.
[[nodiscard]] std::string completions_of(const Command& program, std::vector<std::string> words);

}  // namespace fusee::app
