#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/markup.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"

/// What every page is built of. Parameters named `text`, `title`, `name` or `value` are plain texts and escaped here; `html` is taken as it
/// is.
namespace fusee::report {

using core::bytes_text;
using core::coordinate;
using core::counted;
using core::deg_from_rad;
using core::escape;

/// `digits` significant digits, whole numbers in full; an en dash for NaN and infinities.
[[nodiscard]] std::string number(double value, int digits = 4);
/// An angle in degrees, without the unit.
[[nodiscard]] std::string deg(double rad, int digits = 4);
/// "0.85 Nm"
[[nodiscard]] std::string newton_metres(double torque, int digits = 3);
/// "0.12 to 0.5"; an en dash if an end is not known.
[[nodiscard]] std::string span(const core::Range& range, int digits = 3);
/// "9.1 \u2192 1.04"
[[nodiscard]] std::string change(double before, double after);
/// 0.62 is "62 %".
[[nodiscard]] std::string percent(double share);

/// One cell of a table: HTML, a class ("num", "code", ...) or "", and an id for links or "".
struct Cell {
    std::string html;
    std::string css;
    std::string id = {};
};
using Rows = std::vector<std::vector<Cell>>;
[[nodiscard]] Cell plain(std::string_view text);
[[nodiscard]] Cell faint(std::string_view text);
[[nodiscard]] Cell code(std::string_view text);
[[nodiscard]] Cell num(std::string_view text);
[[nodiscard]] Cell num(double value, int digits = 4);
/// A computed angle with its difference from another one: "20.1 (+1.2)", in degrees.
[[nodiscard]] Cell compared(double computed_rad, double measured_rad);
/// A share of 1 as a bar with `text` next to it.
[[nodiscard]] Cell share_cell(double share, std::string_view text);
/// @param caption what the table holds, read aloud and not shown: a heading stands above it. @param head plain texts; "" for no heading
[[nodiscard]] std::string html_table(std::string_view caption, const std::vector<std::string>& head, const Rows& rows);
/// A table in small type.
[[nodiscard]] std::string dense_table(std::string_view caption, const std::vector<std::string>& head, const Rows& rows);
/// A table whose rows become cards on a phone.
[[nodiscard]] std::string card_table(std::string_view caption, const std::vector<std::string>& head, const Rows& rows);

using Facts = std::vector<std::pair<std::string, std::string>>;
[[nodiscard]] std::string html_facts(const Facts& facts);
[[nodiscard]] std::string paragraph(std::string_view text);
[[nodiscard]] std::string faint_paragraph(std::string_view text);
[[nodiscard]] std::string subheading(std::string_view text);
/// "" without texts.
[[nodiscard]] std::string bullet_list(const std::vector<std::string>& texts);
/// Charts and cards in two columns.
[[nodiscard]] std::string grid(const std::string& html);
[[nodiscard]] std::string card(const std::string& html);
/// A part of the page, in its table of contents; "" without content. @param id for links; "" makes it from the title
[[nodiscard]] std::string section(std::string_view title, const std::string& html, std::string_view id = "");
/// The same, closed until the reader, a link into it or a print opens it. @param note stands beside the title
[[nodiscard]] std::string folded_section(std::string_view title, std::string_view note, const std::string& html, std::string_view id = "");
/// A closed block inside a section; "" without content.
[[nodiscard]] std::string folded(std::string_view summary, const std::string& html);
/// A link inside the page. @param id of the element that it leads to
[[nodiscard]] std::string link_to(std::string_view id, std::string_view text);
/// "Spring law" is "spring-law".
[[nodiscard]] std::string id_of(std::string_view title);

/// "pass", "unjudged", "warning", "error": classes of the style sheet; followed by "-tag" for tags.
[[nodiscard]] const char* css_of(core::Severity severity);
/// A pill that begins with the severity's sign. The verdict of a design that was not fully judged has the sign of a pass.
[[nodiscard]] std::string tag(core::Severity severity, std::string_view text);
[[nodiscard]] std::string verdict_tag(core::Severity severity, std::string_view text);

/// The head of a page.
struct Head {
    std::string kind;      ///< "fusee diagnosis"
    std::string title;     ///< of the page too, if it names nothing else
    std::string verdict;   ///< HTML of verdict_tag
    std::string sentence;  ///< the verdict in words; may be empty
    std::string stamp;     ///< what made it
    Facts tiles;           ///< value, and what it is of
};
/// A whole page that opens offline: head, table of contents of its sections, sections.
/// @param scripts elements behind the page's own scripts
[[nodiscard]] std::string html_page(const std::string& title, const Head& head, const std::string& html, const std::string& scripts = {});

/// The style sheet: light and dark, screen and paper.
[[nodiscard]] std::string style_sheet();

}  // namespace fusee::report
