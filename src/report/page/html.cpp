#include "page/html.h"

#include <fmt/format.h>

#include <cmath>

#include "design/page.h"

namespace fusee::report {

std::string number(double value, int digits) {
    if (std::isnan(value)) return "\u2013";
    const double size = std::abs(value);
    if (size >= std::pow(10.0, digits) && size < 1e9) return fmt::format("{:.0f}", value);  // 40760, not 4.076e+04
    return fmt::format("{:.{}g}", value, digits);
}

std::string bytes_text(double bytes) {
    if (bytes < 1e3) return fmt::format("{:.0f} B", bytes);
    return bytes < 1e6 ? fmt::format("{:.1f} kB", bytes / 1e3) : fmt::format("{:.2f} MB", bytes / 1e6);
}

std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<Cell>>& rows) {
    std::string out = "<div class=\"scroll\"><table><thead><tr>";
    for (const std::string& name : head) out += "<th>" + escape(name) + "</th>";
    out += "</tr></thead><tbody>\n";
    for (const std::vector<Cell>& row : rows) {
        out += "<tr>";
        for (const Cell& cell : row) out += (cell.css.empty() ? "<td>" : "<td class=\"" + cell.css + "\">") + cell.html + "</td>";
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string html_facts(const std::vector<std::pair<std::string, std::string>>& facts) {
    std::string out = "<dl>";
    for (const auto& [name, value] : facts) out += "<dt>" + escape(name) + "</dt><dd>" + escape(value) + "</dd>";
    return out + "</dl>\n";
}

std::string html_tile(const std::string& value, const std::string& name) {
    return "<div class=\"tile\"><b>" + escape(value) + "</b><span>" + escape(name) + "</span></div>";
}

std::string html_page(const std::string& title, const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>" +
           escape(title) + " \u2013 fusee</title><style>" + style_sheet() + "</style></head><body><main>\n" + body +
           "</main></body></html>\n";
}

}  // namespace fusee::report
