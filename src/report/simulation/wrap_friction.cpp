#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "data/csv.h"
#include "data/figures.h"

namespace fusee::report {

namespace {

using cam::WrapRow;

/// Width of a loop at a load; NaN beyond its rows.
double width_at(const cam::WrapLoop& loop, double tau) {
    const auto after = std::lower_bound(loop.rows.begin(), loop.rows.end(), tau, [](const WrapRow& row, double t) { return row.tau < t; });
    if (after == loop.rows.end() || (after == loop.rows.begin() && after->tau != tau)) return kUnknown;
    if (after->tau == tau) return after->width();
    const WrapRow &a = *std::prev(after), &b = *after;
    return a.width() + (b.width() - a.width()) * (tau - a.tau) / (b.tau - a.tau);
}

}  // namespace

double wrap_width(const Simulation& s, double tau) {
    double sum = 0.0;
    for (const WrapSide& side : s.wraps) sum += width_at(side.loop, tau);
    return sum;
}

std::string wrap_hysteresis_csv(const std::vector<WrapSide>& wraps) {
    std::string csv =
        "part,angle_rad,tau_Nm,tension_N,stretch_loading_m,stretch_unloading_m,give_loading_rad,give_unloading_rad,width_rad\n";
    for (const WrapSide& side : wraps)
        for (const WrapRow& row : side.loop.rows)
            add_csv_row(csv, cam::to_string(side.part), row.angle, row.tau, row.tension, row.elongation_loading, row.elongation_unloading,
                        row.deflection_loading, row.deflection_unloading, row.width());
    return csv;
}

std::string wrap_remark(const Simulation& s) {
    std::string text;
    for (const WrapSide& side : s.wraps)
        text += fmt::format("{}{} dissipates {:.3g} mJ per cycle of its working range", text.empty() ? "" : ", ", cam::to_string(side.part),
                            1e3 * side.loop.dissipated);
    const SimulatedLevel* widest = nullptr;
    for (const SimulatedLevel& level : s.levels) {
        const double width = wrap_width(s, level.dead_band.tau);
        if (std::isfinite(width) && std::isfinite(level.dead_band.linear) && (!widest || width > wrap_width(s, widest->dead_band.tau)))
            widest = &level;
    }
    if (!widest) return text + ".";
    const double width = wrap_width(s, widest->dead_band.tau);
    return fmt::format("{}; at {:.3g} Nm the hysteresis of both is {:.3g} deg wide at the capstan, {:.2g} % of the linear dead-band.", text,
                       widest->dead_band.tau, deg_from_rad(width), 100.0 * width / widest->dead_band.linear);
}

}  // namespace fusee::report
