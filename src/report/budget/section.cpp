#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "fusee/report/budget.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

using budget::Budget, budget::PartBudget, budget::Source, budget::TorqueError;

std::string band_plot(const PartBudget& part, bool sampled) {
    const bool series = part.kind == cam::PartKind::kSeries;
    std::vector<double> x, low, high, sampled_low, sampled_high;
    for (const TorqueError& place : part.places) {
        x.push_back(deg_from_rad(place.travel));
        low.push_back(100.0 * place.band.low), high.push_back(100.0 * place.band.high);
        sampled_low.push_back(100.0 * place.sampled.low), sampled_high.push_back(100.0 * place.sampled.high);
    }
    Plot plot(series ? "K_SE: torque of joints as built" : "K_PE: torque of joints as built", "capstan travel [deg]", "error [%]");
    const auto both = [](std::vector<double> first, const std::vector<double>& second) {  // one curve with a gap, named once
        first.push_back(core::kNan);
        first.insert(first.end(), second.begin(), second.end());
        return first;
    };
    plot.band("5 to 95 %", x, low, high, series ? "se" : "pe");
    plot.curve("first order, 5 and 95 %", both(x, x), both(low, high), series ? "se" : "pe");
    if (sampled) plot.curve("sampled joints", both(x, x), both(sampled_low, sampled_high), "t", true);
    return plot.svg();
}

Rows source_rows(const Budget& budget) {
    Rows rows;
    for (std::size_t i = 0; i < budget::kSources; ++i) {
        const auto source = static_cast<Source>(i);
        std::vector<Cell> row{plain(to_string(source))};
        for (const PartBudget& part : budget.parts) {
            const bool of_torque = source != Source::kFriction;
            row.push_back(of_torque || part.kind == cam::PartKind::kParallel ? num(limit_text(part, source, part.limits[i])) : faint("-"));
            row.push_back(of_torque ? num(fmt::format("{:.2f} %", 100.0 * budget::kPercentile * part.worst().sigma[i])) : faint("-"));
        }
        for (const budget::WidthBudget& width : budget.widths)
            row.push_back(std::isfinite(width.whole) ? num(fmt::format("{:.2f} deg", deg_from_rad(budget::kPercentile * width.sigma[i])))
                                                     : faint("-"));
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

std::string budget_section(const Budget& budget) {
    std::vector<std::string> head{"source", "limit, K_SE", "+- torque, K_SE", "limit, K_PE", "+- torque, K_PE"};
    for (const budget::WidthBudget& width : budget.widths) head.push_back("+- dead-band, " + newton_metres(width.tau));
    const bool sampled = budget.draws > 0;
    const std::string text = fmt::format(
        "Errors of 5 to 95 % of joints as a shop builds them, at the place where the torque is least certain. Limits are two standard "
        "deviations: "
        "the contour by the process, the others by [budget] of the profile.{}",
        sampled ? fmt::format(" Dashed: {} sampled joints with shifted, grown cams and moved guides.", budget.draws) : "");
    return section("As the shop builds it", grid(band_plot(budget.parts[0], sampled) + band_plot(budget.parts[1], sampled)) +
                                                paragraph(text) +
                                                folded("Errors by source", html_table("Errors by source", head, source_rows(budget))));
}

}  // namespace fusee::report
