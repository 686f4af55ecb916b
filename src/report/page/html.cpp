#include "page/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fusee::report {

namespace {

std::string element(const char* name, std::string_view text) { return fmt::format("<{0}>{1}</{0}>", name, escape(text)); }

struct Look {
    const char *css, *sign;
};
/// In the order of core::Severity.
constexpr std::array<Look, 4> kLooks{{{"pass", "\u2713 "}, {"unjudged", "? "}, {"warning", "! "}, {"error", "\u2715 "}}};
const Look& look_of(core::Severity severity) { return kLooks.at(static_cast<std::size_t>(severity)); }

std::string pill(const char* css, core::Severity severity, core::Severity sign, std::string_view text) {
    return fmt::format("<span class=\"{} {}-tag\">{}{}</span>", css, css_of(severity), look_of(sign).sign, escape(text));
}

}  // namespace

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "\u2013";
    const double size = std::abs(value);
    if (size >= std::pow(10.0, digits) && size < 1e9) return fmt::format("{:.0f}", value);  // 40760, not 4.076e+04
    return fmt::format("{:.{}g}", value, digits);
}

std::string deg(double rad, int digits) { return number(deg_from_rad(rad), digits); }
std::string newton_metres(double torque, int digits) { return number(torque, digits) + " Nm"; }

std::string span(const core::Range& range, int digits) {
    if (!std::isfinite(range.low) || !std::isfinite(range.high)) return number(NAN);
    return number(range.low, digits) + " to " + number(range.high, digits);
}

std::string change(double before, double after) { return number(before, 3) + " \u2192 " + number(after, 3); }

std::string percent(double share) { return std::isfinite(share) ? fmt::format("{:.0f} %", 100.0 * share) : number(share); }

Cell plain(std::string_view text) { return {escape(text), ""}; }
Cell faint(std::string_view text) { return {escape(text), "faint"}; }
Cell code(std::string_view text) { return {escape(text), "code"}; }
Cell num(std::string_view text) { return {escape(text), "num"}; }
Cell num(double value, int digits) { return {number(value, digits), "num"}; }

Cell compared(double computed_rad, double measured_rad) {
    const double difference = deg_from_rad(computed_rad - measured_rad);
    return num(deg(computed_rad) + (std::isnan(difference) ? "" : fmt::format(" ({:+.1f})", difference)));
}

Cell share_cell(double share, std::string_view text) {
    constexpr double kWidth = 90, kHeight = 12;
    if (!std::isfinite(share)) return num(text);
    return {fmt::format("<span style=\"display:flex;align-items:center;gap:10px\"><svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
                        "{1}\"><rect width=\"{0}\" height=\"{1}\" style=\"fill:var(--body)\"/>"
                        "<rect width=\"{2}\" height=\"{1}\" style=\"fill:var(--se)\"/></svg>{3}</span>",
                        kWidth, kHeight, coordinate(kWidth * std::clamp(share, 0.0, 1.0)), escape(text)),
            "num"};
}

std::string html_table(const std::vector<std::string>& head, const Rows& rows) {
    std::string out = "<div class=\"scroll\"><table><thead><tr>";
    for (const std::string& name : head) out += element("th", name);
    out += "</tr></thead><tbody>\n";
    for (const std::vector<Cell>& row : rows) {
        out += "<tr>";
        for (const Cell& cell : row) out += (cell.css.empty() ? "<td>" : "<td class=\"" + cell.css + "\">") + cell.html + "</td>";
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string dense_table(const std::vector<std::string>& head, const Rows& rows) {
    return "<div class=\"dense\">" + html_table(head, rows) + "</div>";
}

std::string html_facts(const Facts& facts) {
    std::string out = "<dl>";
    for (const auto& [name, value] : facts) out += element("dt", name) + element("dd", value);
    return out + "</dl>\n";
}

std::string paragraph(std::string_view text) { return element("p", text); }
std::string faint_paragraph(std::string_view text) { return "<p class=\"faint\">" + escape(text) + "</p>"; }
std::string subheading(std::string_view text) { return "<h3 class=\"held\">" + escape(text) + "</h3>"; }

std::string bullet_list(const std::vector<std::string>& texts) {
    std::string items;
    for (const std::string& text : texts) items += element("li", text);
    return items.empty() ? "" : "<ul>" + items + "</ul>";
}

std::string grid(const std::string& html) { return "<div class=\"grid\">" + html + "</div>"; }
std::string card(const std::string& html) { return "<div class=\"card\">" + html + "</div>"; }

std::string section(std::string_view title, const std::string& html) {
    return html.empty() ? "" : "<section>" + element("h2", title) + html + "</section>\n";
}

const char* css_of(core::Severity severity) { return look_of(severity).css; }

std::string tag(core::Severity severity, std::string_view text) { return pill("tag", severity, severity, text); }
std::string verdict_tag(core::Severity severity, std::string_view text) {
    return pill("verdict", severity, severity == core::Severity::kNotJudged ? core::Severity::kPass : severity, text);
}

std::string html_page(const std::string& title, const Head& head, const std::string& html) {
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">" +
        element("title", title + " \u2013 fusee") + "<style>" + style_sheet() +
        "</style></head><body><main>\n<header><p class=\"eyebrow\">" + escape(head.kind) + "</p>" + element("h1", head.title) +
        head.verdict + (head.sentence.empty() ? "" : paragraph(head.sentence)) + "<p class=\"stamp\">" + escape(head.stamp) +
        "</p><div class=\"tiles\">";
    for (const auto& [value, name] : head.tiles) out += "<div class=\"tile\">" + element("b", value) + element("span", name) + "</div>";
    return out + "</div></header>\n" + html + "</main></body></html>\n";
}

}  // namespace fusee::report
