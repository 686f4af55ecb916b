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

using diagnosis::Isolability;
using Indices = std::vector<std::size_t>;

constexpr double kCell = 25, kCauseLetter = 6.4, kFoot = 20, kMargin = 4;
constexpr std::size_t kMostCauses = 72;  // a picture of about 250 kB

/// Members of each class next to each other, then the other causes.
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

double similarity(const Isolability& isolability, std::size_t a, std::size_t b) {
    return a < isolability.signature_similarity.size() && b < isolability.signature_similarity[a].size()
               ? isolability.signature_similarity[a][b]
               : diagnosis::kNoFigure;
}

std::string number_at(double x, double y, std::size_t n) {
    return fmt::format("<text class=\"key\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>", coordinate(x), coordinate(y), n);
}

/// The lower triangle; the diagonal holds each cause's number.
std::string similarity_matrix(const Isolability& isolability, const Indices& order) {
    const std::size_t shown = std::min(kMostCauses, order.size());
    std::size_t longest = 0;
    for (std::size_t i = 0; i < shown; ++i) longest = std::max(longest, cause_name(isolability.causes[order[i]]).size());
    const double left = kCauseLetter * static_cast<double>(longest + 4), bottom = kMargin + kCell * static_cast<double>(shown);
    const double width = left + kCell * static_cast<double>(shown) + kMargin;
    std::string out = fmt::format(
        "<figure class=\"plot matrix\" style=\"width:{}px\"><figcaption>Similarity of two signatures, in per cent; outlined: not "
        "distinguished</figcaption>"
        "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Similarity of the signatures of {} causes; the table below names the most "
        "similar one of each\">",
        coordinate(width + 26), coordinate(width), coordinate(bottom + kFoot), shown);
    for (std::size_t row = 0; row < shown; ++row) {
        const double top = kMargin + kCell * static_cast<double>(row), middle = left + kCell * (static_cast<double>(row) + 0.5);
        out += fmt::format("<text class=\"key\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{} {}</text>", coordinate(left - 6),
                           coordinate(top + kCell / 2 + 4), escape(cause_name(isolability.causes[order[row]])), row + 1);
        for (std::size_t column = 0; column < row; ++column) {
            const double value = 100.0 * similarity(isolability, order[row], order[column]);
            out += heat_cell({left + kCell * static_cast<double>(column), top, kCell - 1, kCell - 1}, value, fmt::format("{:.0f}", value),
                             similarity_scale(), same_class(isolability, order[row], order[column]));
        }
        out += number_at(middle, top + kCell / 2 + 4, row + 1) + number_at(middle, bottom + 14, row + 1);
    }
    return out + "</svg></figure>\n";
}

std::string class_list(const Isolability& isolability) {
    if (isolability.classes.empty()) return paragraph("These experiments distinguish all of these causes.");
    std::vector<std::string> classes;
    for (const Indices& members : isolability.classes) {
        std::vector<effects::Cause> causes;
        for (const std::size_t i : members)
            if (i < isolability.causes.size()) causes.push_back(isolability.causes[i]);
        classes.push_back(causes_name(causes, ", "));
    }
    return paragraph("These experiments do not distinguish (outlined in the matrix):") + bullet_list(classes);
}

/// The cause with the signature most similar to that of `i`; `i` itself if there is no other.
std::size_t nearest(const Isolability& isolability, std::size_t i) {
    std::size_t best = i;
    double most = -1.0;
    for (std::size_t j = 0; j < isolability.causes.size(); ++j) {
        if (const double value = similarity(isolability, i, j); j != i && value > most) {
            most = value;
            best = j;
        }
    }
    return best;
}

std::string size_table(const Isolability& isolability, const Indices& order) {
    if (isolability.detectable.empty()) return "";
    Rows rows;
    for (std::size_t n = 0; n < order.size(); ++n) {
        const std::size_t i = order[n], other = nearest(isolability, i);
        const double least = i < isolability.detectable.size() ? isolability.detectable[i] : diagnosis::kNoFigure;
        const diagnosis::Parameter size = for_reading({least, {}, i < isolability.units.size() ? isolability.units[i] : ""});
        rows.push_back({num(std::to_string(n + 1)), plain(cause_name(isolability.causes[i])), num(size.value, 2), plain(size.unit),
                        plain(other == i ? "" : cause_name(isolability.causes[other])),
                        num(other == i ? "" : percent(similarity(isolability, i, other)))});
    }
    return subheading("Detectable size") + paragraph("The least size of each cause that shows at 3 sigma, build tolerances included.") +
           dense_table("Least size of each cause that shows", {"", "cause", "least size", "unit", "most similar cause", "similarity"},
                       rows);
}

}  // namespace

std::string isolability_section(const diagnosis::Diagnosis& diagnosis) {
    const Isolability& isolability = diagnosis.isolability;
    if (isolability.causes.empty()) return "";
    const Indices order = by_class(isolability);
    std::string out =
        paragraph(
            "Similarity is |cosine| of the signatures of two causes in the measurements, in sigma, without what build tolerances can "
            "imitate: 100 cannot be distinguished, 0 has nothing in common.") +
        class_list(isolability) + "<div class=\"stack\">" + heat_legend(similarity_scale()) +
        "<div class=\"scroll\" role=\"group\" aria-label=\"Similarity matrix\" tabindex=\"0\">" + similarity_matrix(isolability, order) +
        "</div></div>";
    if (order.size() > kMostCauses) out += faint_paragraph(fmt::format("The first {} of {} causes.", kMostCauses, order.size()));
    return folded_section("What these experiments can distinguish", counted(order.size(), "cause") + ", similarity of their signatures",
                          out + size_table(isolability, order));
}

}  // namespace fusee::report
