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

using gap::FrictionLine;
using gap::FrictionReport;
using Repeat = FrictionReport::Repeat;

constexpr std::array<const char*, 4> kColours{"se", "pe", "t", "linear"};
constexpr std::size_t kMostDots = 2000;  // a page of some hundred kilobytes
constexpr int kLinePoints = 60;          // the band is a hyperbola
constexpr double kBeyond = 1.04;         // the line goes on behind the last dot

/// Dots of each motor and direction; of many motors, of each direction only.
std::map<std::string, std::vector<Repeat>> series_of(const FrictionReport& friction) {
    const std::size_t step = friction.repeats.size() / kMostDots + 1;
    std::map<std::string, std::vector<Repeat>> both, directions;
    for (std::size_t i = 0; i < friction.repeats.size(); i += step) {
        const Repeat& r = friction.repeats[i];
        const std::string direction = r.backdrive ? "backdrive" : "drive";
        both[r.side + " " + direction].push_back(r);
        directions[direction].push_back(r);
    }
    return both.size() <= kColours.size() ? both : directions;
}

/// What the line does not explain, by the load: a bend or a step shows here first.
std::string residual_picture(const FrictionReport& friction) {
    const FrictionLine& line = friction.trusted();
    Plot plot("What the line leaves", "load [Nm]", "friction - line [Nm]");
    std::size_t colour = 0;
    for (const auto& [name, dots] : series_of(friction))
        plot.points(name, column(dots, [](const Repeat& r) { return r.mean_load; }),
                    column(dots, [&](const Repeat& r) { return r.mean_friction - line.constant - line.mu * r.mean_load; }),
                    kColours[colour++ % kColours.size()], column(dots, [](const Repeat& r) { return r.deviation; }));
    return plot.svg();
}

std::string span(const core::Range& range) { return number(range.low) + " to " + number(range.high); }

std::string line_table(const FrictionReport& friction) {
    std::vector<std::vector<Cell>> rows;
    for (const FrictionLine& line : friction.lines)
        rows.push_back({{escape(line.group), ""},
                        {std::to_string(line.rows), "num"},
                        {number(line.mu), "num"},
                        {span(line.mu_95), "num"},
                        {number(line.constant), "num"},
                        {span(line.constant_95), "num"},
                        {number(line.through_zero_mu), "num"},
                        {number(line.robust_mu), "num"},
                        {number(line.scatter, 3), "num"},
                        {number(line.r_squared), "num"},
                        {std::to_string(line.outliers.size()), "num"}});
    return html_table(
        {"rows of", "rows", "mu", "95 %", "constant [Nm]", "95 %", "mu through zero", "robust mu", "scatter [Nm]", "R\u00b2", "outliers"},
        rows);
}

std::string head(const Identification& identification) {
    const FrictionReport& friction = identification.friction;
    const FrictionLine& line = friction.trusted();
    const bool constant = friction.law && friction.law->constant > 0.0;
    const core::Range mu_95 = constant ? line.mu_95 : line.through_zero_mu_95;
    std::string out =
        "<header><p class=\"eyebrow\">fusee identification</p><h1>" + escape(identification.name) + "</h1><p class=\"stamp\">" +
        escape(fmt::format("fusee {}, {}, file {}", core::version(), identification.name, identification.file_sha256.substr(0, 12))) +
        "</p><div class=\"tiles\">";
    out += html_tile(friction.law ? number(friction.law->mu) : "none", friction.law ? "mu, 95 %: " + span(mu_95) : "no law of a gear");
    out +=
        html_tile(constant ? number(friction.law->constant) + " Nm" : "0 Nm", "constant friction, 95 %: " + span(line.constant_95) + " Nm");
    out += html_tile(number(line.scatter, 3) + " Nm", "scatter of the rows about the line");
    return out + html_tile(std::to_string(line.rows), "rows in the fit") + "</div></header>\n";
}

std::string words(const FrictionReport& friction) {
    std::string out = "<section><h2>What the data say</h2><ul>";
    for (const gap::FrictionRemark& remark : friction.remarks)
        out += "<li>" + escape(remark.text) + (std::isnan(remark.p) ? "" : escape(fmt::format(" (p = {:.2g})", remark.p))) + "</li>";
    out += "</ul></section>\n";
    if (friction.law)
        out += "<section><h2>For a profile</h2><div class=\"card\"><pre class=\"code\">" + escape(friction.profile_lines()) +
               "</pre></div></section>\n";
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
        low.push_back(std::max(0.0, band.low));  // friction below 0 is none, and the axis begins there
        high.push_back(std::max(0.0, band.high));
    }
    Plot plot("Friction over the load at break-away (paper, figure 8)", "load [Nm]", "friction [Nm]");
    plot.band("95 % of the line", load, low, high, "sum").curve("line", load, fitted, "sum").curve("through zero", load, zero, "sum", true);
    std::size_t colour = 0;
    for (const auto& [name, dots] : series_of(friction))
        plot.points(name, column(dots, [](const Repeat& r) { return r.mean_load; }),
                    column(dots, [](const Repeat& r) { return r.mean_friction; }), kColours[colour++ % kColours.size()],
                    column(dots, [](const Repeat& r) { return r.deviation; }));
    return plot.from_zero().svg();
}

std::string identification_html(const Identification& identification) {
    const FrictionReport& friction = identification.friction;
    const std::size_t step = friction.repeats.size() / kMostDots + 1;
    std::string charts = "<p>Each dot is the mean of the repeats at one motor torque, with their standard deviation.";
    if (step > 1) charts += fmt::format(" Of {} only one in {} is drawn.", friction.repeats.size(), step);
    charts += "</p><div class=\"grid\">" + figure_8_chart(friction) + residual_picture(friction) + "</div>";
    return html_page(identification.name, head(identification) + words(friction) + "<section><h2>Figure 8</h2>" + charts +
                                              "</section>\n<section><h2>Lines</h2>" + line_table(friction) + "</section>\n");
}

}  // namespace fusee::report
