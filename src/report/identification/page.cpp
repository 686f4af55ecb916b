#include "identification/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "fusee/core/provenance.h"
#include "fusee/report/identification.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

using identification::FrictionLine;
using identification::FrictionReport;
using Repeat = FrictionReport::Repeat;

constexpr std::array<const char*, 4> kPlotColours{"se", "pe", "t", "linear"};
constexpr std::size_t kMostDots = 2000;  // some hundred kilobytes
constexpr int kLinePoints = 60;          // the band is a hyperbola
constexpr double kBeyond = 1.04;         // the line extends past the last dot

/// Dots of each motor and direction; for many motors of each direction only.
std::map<std::string, std::vector<Repeat>> series_of(const FrictionReport& friction) {
    const std::size_t step = friction.repeats.size() / kMostDots + 1;
    std::map<std::string, std::vector<Repeat>> both, directions;
    for (std::size_t i = 0; i < friction.repeats.size(); i += step) {
        const Repeat& r = friction.repeats[i];
        const std::string direction = r.backdrive ? "backdrive" : "drive";
        both[r.side + " " + direction].push_back(r);
        directions[direction].push_back(r);
    }
    return both.size() <= kPlotColours.size() ? both : directions;
}

/// Adds the dots of each series, `of` over the load.
template <class Of>
void add_repeats(Plot& plot, const FrictionReport& friction, const Of& of) {
    std::size_t colour = 0;
    for (const auto& [name, dots] : series_of(friction))
        plot.points(name, column(dots, &Repeat::mean_load), column(dots, of), kPlotColours[colour++ % kPlotColours.size()],
                    column(dots, &Repeat::deviation));
}

/// Residuals over the load: they show a curvature or a step first.
std::string residual_chart(const FrictionReport& friction) {
    const FrictionLine& line = friction.trusted();
    Plot plot("Residuals of the line", "load [Nm]", "friction - line [Nm]");
    add_repeats(plot, friction, [&](const Repeat& r) { return r.mean_friction - line.constant - line.mu * r.mean_load; });
    return plot.svg();
}

std::string line_table(const FrictionReport& friction) {
    Rows rows;
    for (const FrictionLine& line : friction.lines)
        rows.push_back({plain(line.group), num(std::to_string(line.rows)), num(line.mu), num(span(line.mu_95, 4)), num(line.constant),
                        num(span(line.constant_95, 4)), num(line.through_zero_mu), num(line.robust_mu), num(line.scatter, 3),
                        num(line.r_squared), num(std::to_string(line.outliers.size()))});
    return html_table(
        "Lines through the rows",
        {"rows of", "rows", "mu", "95 %", "constant [Nm]", "95 %", "mu through zero", "robust mu", "scatter [Nm]", "R\u00b2", "outliers"},
        rows);
}

Head identification_head(const Identification& identification) {
    const FrictionReport& friction = identification.friction;
    const FrictionLine& line = friction.trusted();
    const bool constant = friction.law && friction.law->constant > 0.0;
    const core::Range mu_95 = constant ? line.mu_95 : line.through_zero_mu_95;
    return {"fusee identification",
            identification.name,
            "",
            "",
            fmt::format("fusee {}, {}, file {}", core::version(), identification.name, identification.file_sha256.substr(0, 12)),
            {{friction.law ? number(friction.law->mu) : "none", friction.law ? "mu, 95 %: " + span(mu_95, 4) : "no law of a gear"},
             {newton_metres(constant ? friction.law->constant : 0.0, 4), "constant friction, 95 %: " + span(line.constant_95, 4) + " Nm"},
             {newton_metres(line.scatter), "scatter of the rows about the line"},
             {std::to_string(line.rows), "rows in the fit"}}};
}

std::string findings_of_data(const FrictionReport& friction) {
    std::vector<std::string> texts;
    for (const identification::FrictionRemark& remark : friction.remarks)
        texts.push_back(remark.text + (std::isnan(remark.p) ? "" : fmt::format(" (p = {:.2g})", remark.p)));
    std::string out = section("Remarks on the data", bullet_list(texts));
    if (friction.law) out += section("For a profile", card("<pre class=\"code\">" + escape(friction.profile_lines()) + "</pre>"));
    return out;
}

}  // namespace

std::string figure_8_chart(const FrictionReport& friction) {
    const FrictionLine& line = friction.trusted();
    double most = 0.0;
    for (const Repeat& r : friction.repeats) most = std::max(most, r.mean_load);
    std::vector<double> load, fitted, zero, low, high;
    for (int i = 0; i <= kLinePoints; ++i) {
        load.push_back(kBeyond * most * i / kLinePoints);
        const core::Range band = line.friction_95(load.back());
        const double on_line = line.constant + line.mu * load.back();
        fitted.push_back(on_line < 0.0 ? std::numeric_limits<double>::quiet_NaN() : on_line);
        zero.push_back(line.through_zero_mu * load.back());
        low.push_back(std::max(0.0, band.low));  // friction is not negative
        high.push_back(std::max(0.0, band.high));
    }
    Plot plot("Friction over the load at break-away (paper, figure 8)", "load [Nm]", "friction [Nm]");
    plot.band("95 % of the line", load, low, high, "sum").curve("line", load, fitted, "sum").curve("through zero", load, zero, "sum", true);
    add_repeats(plot, friction, &Repeat::mean_friction);
    return plot.from_zero().svg();
}

std::string identification_html(const Identification& identification) {
    const FrictionReport& friction = identification.friction;
    const std::size_t step = friction.repeats.size() / kMostDots + 1;
    std::string words = "Each dot is the mean of the repeats at one motor torque, with their standard deviation.";
    if (step > 1) words += fmt::format(" Of {} dots one in {} is drawn.", friction.repeats.size(), step);
    return html_page(identification.name, identification_head(identification),
                     findings_of_data(friction) +
                         section("Figure 8", paragraph(words) + grid(figure_8_chart(friction) + residual_chart(friction))) +
                         section("Lines", line_table(friction)));
}

}  // namespace fusee::report
