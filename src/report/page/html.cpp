#include "page/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "page/bundle.h"

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

namespace {

std::string head_row(const std::vector<std::string>& head) {
    std::string out;
    for (const std::string& name : head) out += name.empty() ? "<td></td>" : "<th scope=\"col\">" + escape(name) + "</th>";
    return out;
}

std::string table_cell(const Cell& cell, const std::string& head) {
    const std::string css = cell.css.empty() ? "" : fmt::format(" class=\"{}\"", cell.css),
                      id = cell.id.empty() ? "" : fmt::format(" id=\"{}\"", escape(cell.id)),
                      label = head.empty() ? "" : fmt::format(" data-label=\"{}\"", escape(head));
    return fmt::format("<td{}{}{}>{}</td>", css, id, label, cell.html);
}

/// @param labelled cells repeat the heading of their column, for rows as cards
std::string table(std::string_view caption, const char* css, bool labelled, const std::vector<std::string>& head, const Rows& rows) {
    std::string out = fmt::format(
        "<div class=\"scroll{0}\" role=\"group\" aria-label=\"{1}\" tabindex=\"0\"><table><caption>{1}</caption><thead><tr>{2}</tr></thead>"
        "<tbody>\n",
        css, escape(caption), head_row(head));
    for (const std::vector<Cell>& row : rows) {
        out += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) out += table_cell(row[i], labelled && i < head.size() ? head[i] : "");
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

}  // namespace

std::string html_table(std::string_view caption, const std::vector<std::string>& head, const Rows& rows) {
    return table(caption, "", false, head, rows);
}
std::string dense_table(std::string_view caption, const std::vector<std::string>& head, const Rows& rows) {
    return table(caption, " dense", false, head, rows);
}
std::string card_table(std::string_view caption, const std::vector<std::string>& head, const Rows& rows) {
    return table(caption, " cards", true, head, rows);
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

std::string id_of(std::string_view title) {
    std::string id;
    for (const char c : title) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!id.empty() && id.back() != '-')
            id += '-';
    }
    if (id.ends_with('-')) id.pop_back();
    return id;
}

std::string link_to(std::string_view id, std::string_view text) { return fmt::format("<a href=\"#{}\">{}</a>", escape(id), escape(text)); }

std::string section(std::string_view title, const std::string& html, std::string_view id) {
    if (html.empty()) return "";
    return fmt::format("<section id=\"{}\">{}{}</section>\n", id.empty() ? id_of(title) : escape(id), element("h2", title), html);
}

std::string folded_section(std::string_view title, std::string_view note, const std::string& html, std::string_view id) {
    if (html.empty()) return "";
    return fmt::format("<section id=\"{}\"><details><summary>{}{}</summary>{}</details></section>\n",
                       id.empty() ? id_of(title) : escape(id), element("h2", title), note.empty() ? "" : element("span", note), html);
}

std::string folded(std::string_view summary, const std::string& html) {
    return html.empty() ? "" : "<details class=\"block\">" + element("summary", summary) + html + "</details>\n";
}

const char* css_of(core::Severity severity) { return look_of(severity).css; }

std::string tag(core::Severity severity, std::string_view text) { return pill("tag", severity, severity, text); }
std::string verdict_tag(core::Severity severity, std::string_view text) {
    return pill("verdict", severity, severity == core::Severity::kNotJudged ? core::Severity::kPass : severity, text);
}

namespace {

/// A link to every section of the page, by its id and heading as `section` writes them.
std::string contents(const std::string& html) {
    constexpr std::string_view kSection = "<section id=\"", kHeading = "<h2>";
    std::string links;
    for (std::size_t at = html.find(kSection); at != std::string::npos; at = html.find(kSection, at)) {
        at += kSection.size();
        const std::string id = html.substr(at, html.find('"', at) - at);
        const std::size_t name = html.find(kHeading, at) + kHeading.size();
        links += fmt::format("<li><a href=\"#{}\">{}</a></li>", id, html.substr(name, html.find("</h2>", name) - name));
    }
    return links.empty() ? "" : "<nav aria-label=\"Contents\"><ol>" + links + "</ol></nav>\n";
}

std::string page_header(const Head& head) {
    std::string out = "<header><p class=\"eyebrow\">" + escape(head.kind) + "</p>" + element("h1", head.title) + head.verdict +
                      (head.sentence.empty() ? "" : "<p class=\"lead\">" + escape(head.sentence) + "</p>") + "<p class=\"stamp\">" +
                      escape(head.stamp) + "</p>";
    if (head.tiles.empty()) return out + "</header>\n";
    out += "<div class=\"tiles\">";
    for (const auto& [value, name] : head.tiles) out += "<div class=\"tile\">" + element("b", value) + element("span", name) + "</div>";
    return out + "</div></header>\n";
}

}  // namespace

std::string html_page(const std::string& title, const Head& head, const std::string& html, const std::string& scripts) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">" +
           element("title", title + " \u2013 fusee") + "<style>" + style_sheet() +
           "</style></head><body><a class=\"skip\" href=\"#main\">To the content</a>\n" + page_header(head) + "<div class=\"columns\">" +
           contents(html) + "<main id=\"main\" tabindex=\"-1\">\n" + html + "</main></div>" + plot_bundle() + scripts + "</body></html>\n";
}

}  // namespace fusee::report
