#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "page/heat.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using gap::Isolability;
using Indices = std::vector<std::size_t>;

constexpr double kCell = 25, kLetter = 6.4, kFoot = 20, kMargin = 4;
constexpr std::size_t kMostCauses = 72;  // a picture of about 250 kB

/// Members of a class side by side, then the causes that stand alone.
Indices by_class(const Isolability& isolability) {
    Indices order;
    const auto add = [&](std::size_t i) {
        if (i < isolability.causes.size() && std::find(order.begin(), order.end(), i) == order.end()) order.push_back(i);
    };
    for (const Indices& members : isolability.classes)
        for (const std::size_t i : members) add(i);
    for (std::size_t i = 0; i < isolability.causes.size(); ++i) add(i);
    return order;
}

bool same_class(const Isolability& isolability, std::size_t a, std::size_t b) {
    return std::any_of(isolability.classes.begin(), isolability.classes.end(), [=](const Indices& members) {
        const auto holds = [&](std::size_t i) { return std::find(members.begin(), members.end(), i) != members.end(); };
        return holds(a) && holds(b);
    });
}

double alike(const Isolability& isolability, std::size_t a, std::size_t b) {
    return a < isolability.alike.size() && b < isolability.alike[a].size() ? isolability.alike[a][b] : gap::kNoFigure;
}

std::string number_at(double x, double y, std::size_t n) {
    return fmt::format("<text class=\"key\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>", coordinate(x), coordinate(y), n);
}

/// The lower triangle; the diagonal holds each cause's number.
std::string matrix(const Isolability& isolability, const Indices& order) {
    const std::size_t shown = std::min(kMostCauses, order.size());
    std::size_t longest = 0;
    for (std::size_t i = 0; i < shown; ++i) longest = std::max(longest, cause_name(isolability.causes[order[i]]).size());
    const double left = kLetter * static_cast<double>(longest + 4), bottom = kMargin + kCell * static_cast<double>(shown);
    const double width = left + kCell * static_cast<double>(shown) + kMargin;
    std::string out = fmt::format(
        "<figure class=\"plot\" style=\"max-width:{}px\"><figcaption>How alike two causes look, in per cent</figcaption>"
        "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"isolability\">",
        coordinate(width + 26), coordinate(width), coordinate(bottom + kFoot));
    for (std::size_t row = 0; row < shown; ++row) {
        const double top = kMargin + kCell * static_cast<double>(row), middle = left + kCell * (static_cast<double>(row) + 0.5);
        out += fmt::format("<text class=\"key\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{} {}</text>", coordinate(left - 6),
                           coordinate(top + kCell / 2 + 4), escape(cause_name(isolability.causes[order[row]])), row + 1);
        for (std::size_t column = 0; column < row; ++column) {
            const double value = 100.0 * alike(isolability, order[row], order[column]);
            out += heat_cell({left + kCell * static_cast<double>(column), top, kCell - 1, kCell - 1}, value, fmt::format("{:.0f}", value),
                             alike_scale(), same_class(isolability, order[row], order[column]));
        }
        out += number_at(middle, top + kCell / 2 + 4, row + 1) + number_at(middle, bottom + 14, row + 1);
    }
    return out + "</svg></figure>\n";
}

std::string class_list(const Isolability& isolability) {
    if (isolability.classes.empty()) return "<p>These experiments can tell all of these causes apart.</p>";
    std::string out = "<p>These experiments cannot tell apart (outlined in the matrix):</p><ul>";
    for (const Indices& members : isolability.classes) {
        std::vector<gap::Cause> causes;
        for (const std::size_t i : members)
            if (i < isolability.causes.size()) causes.push_back(isolability.causes[i]);
        out += "<li>" + escape(causes_name(causes, ", ")) + "</li>";
    }
    return out + "</ul>";
}

/// The cause that is most alike to `i`; `i` itself if there is no other.
std::size_t nearest(const Isolability& isolability, std::size_t i) {
    std::size_t best = i;
    double most = -1.0;
    for (std::size_t j = 0; j < isolability.causes.size(); ++j) {
        if (const double value = alike(isolability, i, j); j != i && value > most) {
            most = value;
            best = j;
        }
    }
    return best;
}

std::string size_table(const Isolability& isolability, const Indices& order) {
    if (isolability.detectable.empty()) return "";
    std::vector<std::vector<Cell>> rows;
    for (std::size_t n = 0; n < order.size(); ++n) {
        const std::size_t i = order[n], other = nearest(isolability, i);
        const double least = i < isolability.detectable.size() ? isolability.detectable[i] : gap::kNoFigure;
        const gap::Parameter size = for_reading({least, {}, i < isolability.units.size() ? isolability.units[i] : ""});
        rows.push_back({{std::to_string(n + 1), "num"},
                        {escape(cause_name(isolability.causes[i])), ""},
                        {known(size.value, 2), "num"},
                        {escape(size.unit), ""},
                        {other == i ? "" : escape(cause_name(isolability.causes[other])), ""},
                        {other == i ? "" : percent(alike(isolability, i, other)), "num"}});
    }
    return "<h3 class=\"held\">Least size that can be seen</h3><p>What would stand out by 3 sigma once build tolerances are allowed for."
           "</p><div class=\"dense\">" +
           html_table({"", "cause", "least size", "unit", "most alike to", "alike"}, rows) + "</div>";
}

}  // namespace

std::string isolability_section(const gap::Diagnosis& diagnosis) {
    const Isolability& isolability = diagnosis.isolability;
    if (isolability.causes.empty()) return "";
    const Indices order = by_class(isolability);
    std::string out =
        "<p>Likeness is the |cosine| between the marks that two causes leave on the measurements, in sigma, with whatever the "
        "build tolerances could imitate taken out: 100 cannot be told apart, 0 shares nothing.</p>" +
        class_list(isolability) + "<div class=\"stack\">" + matrix(isolability, order) + heat_legend(alike_scale()) + "</div>";
    if (order.size() > kMostCauses) out += fmt::format("<p class=\"faint\">The first {} of {} causes.</p>", kMostCauses, order.size());
    return section("What these experiments can tell apart", out + size_table(isolability, order));
}

}  // namespace fusee::report
