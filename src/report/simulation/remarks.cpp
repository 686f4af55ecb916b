#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "fusee/core/units.h"
#include "fusee/report/simulation.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using actuator::DeadBand;

std::string deg(double rad) { return number(core::deg_from_rad(rad), 3) + " deg"; }
std::string nm(double torque) { return number(torque, 3) + " Nm"; }

/// The level at which |a/b - 1| is greatest, of those where both are known.
const SimulatedLevel* widest(const std::vector<SimulatedLevel>& levels, double DeadBand::*a, double DeadBand::*b) {
    const SimulatedLevel* found = nullptr;
    const auto part = [&](const SimulatedLevel& level) { return std::abs(level.dead_band.*a / level.dead_band.*b - 1.0); };
    for (const SimulatedLevel& level : levels)
        if (std::isfinite(part(level)) && (found == nullptr || part(level) > part(*found))) found = &level;
    return found;
}

/// "12 % less (20.1 against 22.9 deg at 1 Nm)"
std::string difference(const DeadBand& d, double DeadBand::*a, double DeadBand::*b) {
    const double share = 100.0 * (d.*a / d.*b - 1.0);
    return fmt::format("{} % {} ({} against {} deg at {})", number(std::abs(share), 2), share < 0.0 ? "less" : "more",
                       number(core::deg_from_rad(d.*a), 3), number(core::deg_from_rad(d.*b), 3), nm(d.tau));
}

std::optional<std::string> linear_text(const Simulation& s) {
    const SimulatedLevel* level = widest(s.levels, &DeadBand::linear, &DeadBand::exact_width);
    if (level == nullptr) return std::nullopt;
    return fmt::format("The linear dead-band is at most {} than the exact extremes: stiffness changes within the dead-band.",
                       difference(level->dead_band, &DeadBand::linear, &DeadBand::exact_width));
}

/// Levels of which something is true, in words: "at 3 of 15 levels, from 0.3 Nm to 0.5 Nm"; none: nothing.
template <class Is>
std::optional<std::string> levels_text(const Simulation& s, const Is& is) {
    const auto count = std::count_if(s.levels.begin(), s.levels.end(), is);
    if (count == 0) return std::nullopt;
    const auto first = std::find_if(s.levels.begin(), s.levels.end(), is);
    const auto last = std::find_if(s.levels.rbegin(), s.levels.rend(), is);
    if (count == 1) return "at " + nm(first->dead_band.tau);
    return fmt::format("at {} of {} levels, from {} to {}", count, s.levels.size(), nm(first->dead_band.tau), nm(last->dead_band.tau));
}

std::optional<std::string> protocol_text(const Simulation& s) {
    std::vector<SimulatedLevel> full;
    std::copy_if(s.levels.begin(), s.levels.end(), std::back_inserter(full),
                 [](const SimulatedLevel& l) { return l.reading.strong_enough(); });
    const SimulatedLevel* level = widest(full, &DeadBand::measured_width, &DeadBand::exact_width);
    if (level == nullptr) return std::nullopt;
    return fmt::format(
        "A push strong enough that a stronger one reads the same still reads up to {} than the exact extremes: each capstan "
        "sticks where the release leaves it, and a slack cable pushes no farther.",
        difference(level->dead_band, &DeadBand::measured_width, &DeadBand::exact_width));
}

/// The first level at which a push falls short, in words.
std::optional<std::string> push_text(const Simulation& s) {
    const auto weak = [](const SimulatedLevel& l) { return l.reading.push_torque < l.reading.full_push; };
    const auto levels = levels_text(s, weak);
    if (!levels) return std::nullopt;
    const auto level = std::find_if(s.levels.rbegin(), s.levels.rend(), weak);
    return fmt::format("The push is too weak to reach the edges {}: at {} it is {} and would have to be {}.", *levels,
                       nm(level->dead_band.tau), nm(level->reading.push_torque), nm(level->reading.full_push));
}

/// Where the push leads a spring beyond the end of its law.
std::optional<std::string> beyond_text(const Simulation& s) {
    const auto beyond = [](const SimulatedLevel& l) { return l.reading.push_torque > l.reading.covered_push; };
    const auto levels = levels_text(s, beyond);
    if (!levels) return std::nullopt;
    const auto level = std::find_if(s.levels.rbegin(), s.levels.rend(), beyond);
    return fmt::format(
        "On the way a spring goes beyond the end of its law {}, and is taken to go on straight; pushed within the laws, at most "
        "with {} at {}, the test reads {}.",
        *levels, nm(level->reading.covered_push), nm(level->dead_band.tau), deg(level->within_laws));
}

/// Levels whose figure is not a number, in words.
std::optional<std::string> missing_text(const Simulation& s, double DeadBand::*figure, const char* what) {
    const auto levels = levels_text(s, [figure](const SimulatedLevel& l) { return std::isnan(l.dead_band.*figure); });
    if (!levels) return std::nullopt;
    return fmt::format("{} {}: the springs end before.", what, *levels);
}

std::string frame_text(const Simulation& s) {
    if (s.bearing.constant == 0.0 && s.bearing.tension_share == 0.0)
        return "Without the gears' friction nothing holds the joint off its place: the profile gives the bearing no friction.";
    const double first = s.levels.front().frame, last = s.levels.back().frame;
    return fmt::format("With masses for motors the bearing alone leaves {} at {} and {} at {}.", deg(first),
                       nm(s.levels.front().dead_band.tau), deg(last), nm(s.levels.back().dead_band.tau));
}

double mean_error(const std::vector<MeasuredRow>& rows, double DeadBand::*figure) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const MeasuredRow& row : rows)
        if (std::isfinite(row.computed.*figure)) sum += std::abs(row.computed.*figure - row.measured), ++count;
    return count == 0 ? kUnknown : sum / static_cast<double>(count);
}

std::optional<std::string> measured_text(const Simulation& s) {
    if (s.measured.empty()) return std::nullopt;
    const auto& rows = s.measured;
    return fmt::format("Measured, {} rows: the mean difference is {} for the linear figure, {} for the exact extremes, {} for the test.",
                       rows.size(), deg(mean_error(rows, &DeadBand::linear)), deg(mean_error(rows, &DeadBand::exact_width)),
                       deg(mean_error(rows, &DeadBand::measured_width)));
}

}  // namespace

ConditionVerdict condition_verdict(const Simulation& simulation) { return condition_verdict(simulation.condition); }

std::vector<std::string> remarks(const Simulation& s) {
    std::vector<std::string> all;
    if (!s.survey.remark.empty()) all.push_back(s.survey.remark);
    if (s.survey.arrangement != actuator::Arrangement::kPnrvsa) return all;
    if (std::isfinite(s.survey.torque))
        all.push_back(fmt::format("The joint takes at most {} of torque before a spring leaves its law.", nm(s.survey.torque)));
    all.push_back(condition_text(s.condition));
    for (const auto& text : {linear_text(s), protocol_text(s), push_text(s), beyond_text(s),
                             missing_text(s, &DeadBand::exact_width, "The exact extremes are not covered"),
                             missing_text(s, &DeadBand::measured_width, "Nothing is read"), measured_text(s)})
        if (text) all.push_back(*text);
    all.push_back(frame_text(s));
    if (!s.stretches.empty()) all.push_back(stretch_remark(s));
    if (!s.wraps.empty()) all.push_back(wrap_remark(s));
    return all;
}

}  // namespace fusee::report
