#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/markup.h"

namespace fusee::report {

using core::coordinate;
using core::escape;

/// `digits` significant digits, whole numbers in full; an en dash for NaN.
[[nodiscard]] std::string number(double value, int digits = 4);
/// "12.3 kB"
[[nodiscard]] std::string bytes_text(double bytes);

/// One cell of a table: HTML, and a class ("num", "code", ...) or "".
struct Cell {
    std::string html;
    std::string css;
};
/// @param head plain texts; escaped here
[[nodiscard]] std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<Cell>>& rows);
/// A list of name and value; both plain texts.
[[nodiscard]] std::string html_facts(const std::vector<std::pair<std::string, std::string>>& facts);
/// One figure of a page's head, inside `<div class="tiles">`; both plain texts.
[[nodiscard]] std::string html_tile(const std::string& value, const std::string& name);
/// A whole page that opens offline. @param title plain text; @param body HTML
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

}  // namespace fusee::report
