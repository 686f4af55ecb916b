#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "data/csv.h"
#include "data/figures.h"
#include "fusee/report/simulation.h"

namespace fusee::report {

namespace {

using DeadBand = SimulatedDeadBand;

std::string degrees_of(double rad) { return deg(rad, 3) + " deg"; }

/// The level at which |a/b - 1| is greatest, of those where both are known.
const SimulatedLevel* widest(const std::vector<SimulatedLevel>& levels, double DeadBand::*a, double DeadBand::*b) {
    const SimulatedLevel* found = nullptr;
    const auto ratio = [&](const SimulatedLevel& level) { return std::abs(level.dead_band.*a / level.dead_band.*b - 1.0); };
    for (const SimulatedLevel& level : levels)
        if (std::isfinite(ratio(level)) && (found == nullptr || ratio(level) > ratio(*found))) found = &level;
    return found;
}

/// "12 % less (20.1 instead of 22.9 deg at 1 Nm)"
std::string difference(const DeadBand& d, double DeadBand::*a, double DeadBand::*b) {
    const double share = 100.0 * (d.*a / d.*b - 1.0);
    return fmt::format("{} % {} ({} instead of {} deg at {})", number(std::abs(share), 2), share < 0.0 ? "less" : "more", deg(d.*a, 3),
                       deg(d.*b, 3), newton_metres(d.tau));
}

std::optional<std::string> linear_text(const Simulation& s) {
    const SimulatedLevel* level = widest(s.levels, &DeadBand::linear, &DeadBand::exact_width);
    if (level == nullptr) return std::nullopt;
    return fmt::format("The linear dead-band is at most {} than the exact one: the stiffness changes within the dead-band.",
                       difference(level->dead_band, &DeadBand::linear, &DeadBand::exact_width));
}

/// The levels with a property: "at 3 of 15 levels, from 0.3 Nm to 0.5 Nm"; nothing without any.
template <class Is>
std::optional<std::string> levels_text(const Simulation& s, const Is& is) {
    const auto count = std::count_if(s.levels.begin(), s.levels.end(), is);
    if (count == 0) return std::nullopt;
    const auto first = std::find_if(s.levels.begin(), s.levels.end(), is);
    const auto last = std::find_if(s.levels.rbegin(), s.levels.rend(), is);
    if (count == 1) return "at " + newton_metres(first->dead_band.tau);
    return fmt::format("at {} of {} levels, from {} to {}", count, s.levels.size(), newton_metres(first->dead_band.tau),
                       newton_metres(last->dead_band.tau));
}

std::optional<std::string> push_and_release_text(const Simulation& s) {
    std::vector<SimulatedLevel> full;
    std::copy_if(s.levels.begin(), s.levels.end(), std::back_inserter(full),
                 [](const SimulatedLevel& l) { return l.reading.strong_enough(); });
    const SimulatedLevel* level = widest(full, &DeadBand::measured_width, &DeadBand::exact_width);
    if (level == nullptr) return std::nullopt;
    return fmt::format(
        "A push-and-release test with a full push measures up to {} than the exact dead-band: each capstan sticks where the release leaves "
        "it, "
        "and a slack cable does not push.",
        difference(level->dead_band, &DeadBand::measured_width, &DeadBand::exact_width));
}

/// The levels at which the push is too weak.
std::optional<std::string> push_text(const Simulation& s) {
    const auto weak = [](const SimulatedLevel& l) { return l.reading.push_torque < l.reading.full_push; };
    const auto levels = levels_text(s, weak);
    if (!levels) return std::nullopt;
    const auto level = std::find_if(s.levels.rbegin(), s.levels.rend(), weak);
    return fmt::format("The push is too weak to reach the edges {}: at {} it is {}, needed are {}.", *levels,
                       newton_metres(level->dead_band.tau), newton_metres(level->reading.push_torque),
                       newton_metres(level->reading.full_push));
}

/// The levels at which the push takes a spring beyond the end of its law.
std::optional<std::string> beyond_text(const Simulation& s) {
    const auto beyond = [](const SimulatedLevel& l) { return l.reading.push_torque > l.reading.covered_push; };
    const auto levels = levels_text(s, beyond);
    if (!levels) return std::nullopt;
    const auto level = std::find_if(s.levels.rbegin(), s.levels.rend(), beyond);
    return fmt::format(
        "The push takes a spring beyond the end of its law {}; the simulation extends the law linearly. Pushed within the laws, at most "
        "with "
        "{} at {}, the test measures {}.",
        *levels, newton_metres(level->reading.covered_push), newton_metres(level->dead_band.tau), degrees_of(level->within_laws));
}

/// Levels whose figure is unknown.
std::optional<std::string> unknown_levels_text(const Simulation& s, double DeadBand::*figure, const char* what) {
    const auto levels = levels_text(s, [figure](const SimulatedLevel& l) { return std::isnan(l.dead_band.*figure); });
    if (!levels) return std::nullopt;
    return fmt::format("{} {}: outside the laws of the springs.", what, *levels);
}

std::string frame_text(const Simulation& s) {
    if (s.bearing.constant == 0.0 && s.bearing.tension_share == 0.0)
        return "Without gear friction the joint has no dead-band: the profile states no bearing friction.";
    const double first = s.levels.front().frame, last = s.levels.back().frame;
    return fmt::format("With masses in place of motors the dead-band of the bearing is {} at {} and {} at {}.", degrees_of(first),
                       newton_metres(s.levels.front().dead_band.tau), degrees_of(last), newton_metres(s.levels.back().dead_band.tau));
}

double mean_error(const std::vector<MeasuredRow>& rows, double DeadBand::*figure) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const MeasuredRow& row : rows)
        if (std::isfinite(row.computed.*figure)) sum += std::abs(row.computed.*figure - row.measured), ++count;
    return count == 0 ? kUnknown : sum / static_cast<double>(count);
}

std::optional<std::string> measured_remark(const Simulation& s) {
    if (s.measured.empty()) return std::nullopt;
    const auto& rows = s.measured;
    return fmt::format(
        "Measured table, {} rows: mean difference {} for the linear dead-band, {} for the exact one, {} for the simulated test.",
        rows.size(), degrees_of(mean_error(rows, &DeadBand::linear)), degrees_of(mean_error(rows, &DeadBand::exact_width)),
        degrees_of(mean_error(rows, &DeadBand::measured_width)));
}

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

std::vector<std::string> remarks(const Simulation& s) {
    std::vector<std::string> all;
    if (!s.survey.remark.empty()) all.push_back(s.survey.remark);
    if (s.survey.arrangement != actuator::Arrangement::kPnrvsa) return all;
    if (std::isfinite(s.survey.torque))
        all.push_back(fmt::format("The springs stay within their laws up to a joint torque of {}.", newton_metres(s.survey.torque)));
    all.push_back(condition_text(s.condition));
    for (const auto& text : {linear_text(s), push_and_release_text(s), push_text(s), beyond_text(s),
                             unknown_levels_text(s, &DeadBand::exact_width, "The exact dead-band is unknown"),
                             unknown_levels_text(s, &DeadBand::measured_width, "The test measures nothing"), measured_remark(s)})
        if (text) all.push_back(*text);
    all.push_back(frame_text(s));
    if (!s.stretches.empty()) all.push_back(stretch_remark(s));
    if (!s.wraps.empty()) all.push_back(wrap_remark(s));
    return all;
}

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
