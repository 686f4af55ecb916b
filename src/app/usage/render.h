#pragma once
#include <string>

#include "command_tree.h"

/// Each returns a complete file: completions/fusee.SHELL, docs/fusee.1.
namespace fusee::app {

[[nodiscard]] std::string bash_completion(const Command& program);
[[nodiscard]] std::string zsh_completion(const Command& program);
[[nodiscard]] std::string fish_completion(const Command& program);
/// In the roff macros of man(7).
[[nodiscard]] std::string man_page(const Command& program, const std::string& version);

}  // namespace fusee::app
