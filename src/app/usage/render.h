#pragma once
#include <string>
#include <string_view>

#include "command_tree.h"

namespace fusee::app {

/// completions/fusee.SHELL, which is built in. @pre "bash", "zsh" or "fish"
[[nodiscard]] std::string_view completion_script(std::string_view shell);
/// The manual page in the roff macros of man(7).
[[nodiscard]] std::string man_page(const Command& program, const std::string& version);

}  // namespace fusee::app
