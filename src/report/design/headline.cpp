#include "fusee/report/headline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "data/figures.h"
#include "fusee/core/lists.h"

namespace fusee::report {

namespace {

std::string built_text(const ExpectedWidth& width) {
    return fmt::format("{} to {} deg at {}", deg(width.built.low, 3), deg(width.built.high, 3), newton_metres(width.tau));
}

std::string headline_width_text(const ExpectedWidth& width) {
    return std::isfinite(width.nominal) ? deg(width.nominal, 3) + " deg" : "not covered by the springs";
}

/// What the dead-band's range is taken of.
std::string built_by(const Headline& o) {
    if (!o.budget) return "joints as built";
    return o.budget->draws > 0 ? fmt::format("{} sampled joints as built", o.budget->draws) : "joints as built, first order";
}

HeadFigure dead_band_figure(const Headline& o) {
    const std::string low = newton_metres(o.least.tau), high = newton_metres(o.overdrive.tau);
    const bool known = std::isfinite(o.least.nominal) && std::isfinite(o.overdrive.nominal);
    HeadFigure figure{known ? fmt::format("{} to {} deg", deg(o.least.nominal, 3), deg(o.overdrive.nominal, 3))
                            : fmt::format("{} at {}, {} at {}", headline_width_text(o.least), low, headline_width_text(o.overdrive), high),
                      fmt::format("exact dead-band at the joint, from {} to {} of co-contraction", low, high)};
    figure.name = fmt::format("Dead-band, {} to {}", number(o.least.tau, 3), high);
    std::string built;
    for (const ExpectedWidth* width : {&o.least, &o.overdrive}) {
        if (!std::isfinite(width->built.width())) continue;
        built += (built.empty() ? "" : ", ") + built_text(*width);
        figure.line +=
            fmt::format("{}{} to {}", figure.line.empty() ? "as built: " : ", ", deg(width->built.low, 3), deg(width->built.high, 3));
    }
    if (built.empty()) return figure;
    figure.line += " deg";
    figure.label += "; 5 to 95 % of " + built_by(o) + ": " + built;
    return figure;
}

std::string files_text(const FileErrors& files) {
    std::string text;
    if (std::isfinite(files.arm)) text += fmt::format("; arm error of the files {} %", number(100.0 * files.arm, 2));
    if (std::isfinite(files.dead_band)) text += fmt::format(", of their dead-band {} %", number(100.0 * files.dead_band, 2));
    return text;
}

/// Stands in for a budget: the contour's tolerance at the least arm.
HeadFigure arms_figure(const Headline& o, const FileErrors& files) {
    const auto worst = std::max_element(o.arms.begin(), o.arms.end(),
                                        [](const auto& a, const auto& b) { return a.worst_relative() < b.worst_relative(); });
    HeadFigure figure{fmt::format("-{0} to +{0} %", number(100.0 * worst->worst_relative(), 2)),
                      "expected arm error of parts by " + o.process + ":", "Lever arms as built", "by " + o.process + ", at the least arm"};
    for (const MadeArm& arm : o.arms)
        figure.label += fmt::format("{} {} mm on {}'s least arm of {} mm", &arm == &o.arms.front() ? "" : ",", number(arm.tolerance_mm, 2),
                                    arm.part, number(arm.least_arm_mm, 3));
    return figure.label += files_text(files), figure;
}

/// The part with the widest band of torque, its place and what contributes most; the sampled band where there is one.
HeadFigure torque_figure(const Headline& o, const FileErrors& files) {
    const auto& parts = o.budget->parts;
    const bool sampled = o.budget->draws > 0;
    const auto range = [&](const design::budget::TorqueError& place) { return sampled ? place.sampled : place.band; };
    const auto worst = [&](const design::budget::PartBudget& part) {
        const auto wider = [&](const auto& a, const auto& b) { return range(a).width() < range(b).width(); };
        return *std::max_element(part.places.begin(), part.places.end(), wider);
    };
    const bool first = range(worst(parts[0])).width() >= range(worst(parts[1])).width();
    const design::budget::PartBudget &widest = parts[first ? 0 : 1], &other = parts[first ? 1 : 0];
    const design::budget::TorqueError place = worst(widest);
    const auto band = [&](const design::budget::TorqueError& at) {
        return fmt::format("{:+.1f} to {:+.1f} %", 100.0 * range(at).low, 100.0 * range(at).high);
    };
    const std::string joints = sampled ? fmt::format("{} sampled joints", o.budget->draws) : "joints, first order";
    std::array<std::size_t, design::budget::kSources> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return place.sigma[a] > place.sigma[b]; });
    HeadFigure figure{band(place),
                      fmt::format("worst-case torque error of either spring as built by {}, 5 to 95 % of {} (of {}; {}: {}), from",
                                  o.process, joints, to_string(widest.kind), to_string(other.kind), band(worst(other))),
                      "Torque as built", fmt::format("worst-case error, of the {} spring", first ? "series" : "parallel")};
    for (std::size_t i = 0; i < 3; ++i)
        figure.label += fmt::format("{} {} {:.1f} %", i == 0 ? "" : ",", to_string(static_cast<design::budget::Source>(order[i])),
                                    100.0 * design::budget::kPercentile * place.sigma[order[i]]);
    return figure.label += files_text(files), figure;
}

HeadFigure spring_figure(const pipeline::SpringFigures& spring) {
    const std::string over = fmt::format("from {} to {} deg", deg(spring.angles.low, 4), deg(spring.angles.high, 4));
    const std::string low = number(spring.torques.low, 3), high = number(spring.torques.high, 3);
    return {low == high ? newton_metres(spring.torques.high) : fmt::format("{} to {}", low, newton_metres(spring.torques.high)),
            "torque of the spring, " + over, "Torque", over};
}

std::string short_condition(const actuator::ConditionSummary& c) {
    return fmt::format("{} ({} to {})", to_string(condition_verdict(c)), number(c.values.low, 2), number(c.values.high, 2));
}

}  // namespace

std::vector<HeadFigure> head_figures(const Headline& o, const FileErrors& files) {
    std::vector<HeadFigure> all;
    if (o.process.empty()) return all;
    all.push_back(o.spring ? spring_figure(*o.spring) : dead_band_figure(o));
    if (o.budget)
        all.push_back(torque_figure(o, files));
    else if (!o.arms.empty())
        all.push_back(arms_figure(o, files));
    else if (std::isfinite(files.arm))
        all.push_back({number(100.0 * files.arm, 2) + " %",
                       "arm error of the files; of arms that cross 0 relative to a tenth of the largest", "Arm error of the files",
                       "as read back"});
    if (std::isfinite(o.joint_torque))
        all.push_back({newton_metres(o.joint_torque), "greatest joint torque within the laws of the springs", "Largest torque outside",
                       "at the joint, within the springs' laws"});
    if (!o.spring && std::isfinite(o.condition.values.high))
        all.push_back({short_condition(o.condition),
                       "condition (6), stiction at the joint falls with co-contraction: d(T tau_f)/dtau < 0; in brackets its range",
                       "Condition (6)", "d(T tau_f)/dtau < 0: least and greatest value"});
    return all;
}

std::string condition_text(const actuator::ConditionSummary& c) {
    const auto range = [](const core::Range& r) { return fmt::format("from {} to {}", newton_metres(r.low), newton_metres(r.high)); };
    const std::string low = number(c.values.low, 2), high = number(c.values.high, 2);
    switch (condition_verdict(c)) {
        case ConditionVerdict::kHolds:
            return fmt::format(
                "Condition (6) holds {}: d(T tau_f)/dtau is {} to {}, so stiction at the joint decreases with "
                "co-contraction.",
                range(c.torques), low, high);
        case ConditionVerdict::kFails:
            return fmt::format(
                "Condition (6) fails {}: d(T tau_f)/dtau is {} to {}, so stiction at the joint increases with "
                "co-contraction.",
                range(c.torques), low, high);
        case ConditionVerdict::kWithinRounding:
            return fmt::format(
                "Condition (6) holds only within rounding {}: d(T tau_f)/dtau is {} to {}, so stiction at the "
                "joint stays the same{}.",
                range(c.torques), low, high, c.values.low < -pipeline::kSlightestSlope ? " at its weakest place" : "");
        case ConditionVerdict::kNotKnown:
            return "Condition (6) is unknown: the law covers no co-contraction in use.";
        case ConditionVerdict::kMixed:
            break;
    }
    return fmt::format("Condition (6) holds {} of the co-contractions {}: d(T tau_f)/dtau is {} to {}.", core::listed(c.holds, range),
                       range(c.torques), low, high);
}

}  // namespace fusee::report
