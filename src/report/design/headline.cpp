#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/report/outlook.h"
#include "page/html.h"

namespace fusee::report {

namespace {

constexpr double kSlightest = 1e-5;  // Nm of stiction for each Nm of co-contraction: a hundredth of what a file's arms may be off

std::string deg(double rad) { return number(core::deg_from_rad(rad), 3); }
std::string nm(double torque) { return number(torque, 3) + " Nm"; }

std::string built_text(const ExpectedWidth& width) {
    return fmt::format("{} to {} deg at {}", deg(width.built.low), deg(width.built.high), nm(width.tau));
}

std::string width_text(const ExpectedWidth& width) {
    return std::isfinite(width.nominal) ? deg(width.nominal) + " deg" : "not covered by the springs";
}

HeadFigure dead_band_figure(const Outlook& o) {
    const bool known = std::isfinite(o.least.nominal) && std::isfinite(o.overdrive.nominal);
    const std::string value =
        known ? fmt::format("{} to {} deg", deg(o.least.nominal), deg(o.overdrive.nominal))
              : fmt::format("{} at {}, {} at {}", width_text(o.least), nm(o.least.tau), width_text(o.overdrive), nm(o.overdrive.tau));
    HeadFigure figure{value,
                      fmt::format("dead-band at the joint, exact, from {} to {} of co-contraction", nm(o.least.tau), nm(o.overdrive.tau))};
    std::string built;
    for (const ExpectedWidth* width : {&o.least, &o.overdrive})
        if (std::isfinite(width->built.width())) built += (built.empty() ? "" : ", ") + built_text(*width);
    if (!built.empty()) figure.label += "; 5 to 95 % of joints as built: " + built;
    return figure;
}

HeadFigure arms_figure(const Outlook& o, const FileErrors& files) {
    const auto worst = std::max_element(o.arms.begin(), o.arms.end(),
                                        [](const auto& a, const auto& b) { return a.worst_relative() < b.worst_relative(); });
    const std::string percent = number(100.0 * worst->worst_relative(), 2);
    HeadFigure figure{fmt::format("-{0} to +{0} %", percent), "arm error expected of the parts by " + o.process + ":"};
    for (const MadeArm& arm : o.arms)
        figure.label += fmt::format("{} {} mm at the least arm of {}, {} mm", &arm == &o.arms.front() ? "" : ",",
                                    number(arm.tolerance_mm, 2), arm.part, number(arm.least_arm_mm, 3));
    if (std::isfinite(files.arm)) figure.label += fmt::format("; of the files {} %", number(100.0 * files.arm, 2));
    if (std::isfinite(files.dead_band)) figure.label += fmt::format(", their dead-band within {} %", number(100.0 * files.dead_band, 2));
    return figure;
}

std::string short_condition(const actuator::ConditionSummary& c) {
    return fmt::format("{} ({} to {})", to_string(condition_verdict(c)), number(c.values.low, 2), number(c.values.high, 2));
}

}  // namespace

std::vector<HeadFigure> head_figures(const Outlook& o, const FileErrors& files) {
    std::vector<HeadFigure> all;
    if (o.process.empty()) return all;
    all.push_back(dead_band_figure(o));
    if (!o.arms.empty()) all.push_back(arms_figure(o, files));
    if (std::isfinite(o.joint_torque)) all.push_back({nm(o.joint_torque), "greatest joint torque that no spring leaves its law for"});
    if (std::isfinite(o.condition.values.high))
        all.push_back({short_condition(o.condition), "condition (6), d(T tau_f)/dtau below 0, with its least and greatest value"});
    return all;
}

ConditionVerdict condition_verdict(const actuator::ConditionSummary& c) {
    if (std::isnan(c.values.high)) return ConditionVerdict::kNotKnown;
    if (c.everywhere()) return c.values.high <= -kSlightest ? ConditionVerdict::kHolds : ConditionVerdict::kWithinRounding;
    if (std::max(std::abs(c.values.low), std::abs(c.values.high)) < kSlightest) return ConditionVerdict::kWithinRounding;
    return c.nowhere() ? ConditionVerdict::kFails : ConditionVerdict::kMixed;
}

const char* to_string(ConditionVerdict verdict) {
    switch (verdict) {
        case ConditionVerdict::kHolds:
            return "holds";
        case ConditionVerdict::kFails:
            return "fails";
        case ConditionVerdict::kMixed:
            return "holds in part";
        case ConditionVerdict::kWithinRounding:
            return "within rounding";
        case ConditionVerdict::kNotKnown:
            return "not known";
    }
    return "";
}

std::string condition_text(const actuator::ConditionSummary& c) {
    const auto range = [](const core::Range& r) { return fmt::format("from {} to {}", nm(r.low), nm(r.high)); };
    const std::string low = number(c.values.low, 2), high = number(c.values.high, 2);
    switch (condition_verdict(c)) {
        case ConditionVerdict::kHolds:
            return fmt::format(
                "Condition (6) holds {}: d(T tau_f)/dtau is {} to {}, so the stiction that reaches the joint falls with "
                "co-contraction.",
                range(c.torques), low, high);
        case ConditionVerdict::kFails:
            return fmt::format(
                "Condition (6) fails {}: d(T tau_f)/dtau is {} to {}, so the stiction that reaches the joint grows with "
                "co-contraction.",
                range(c.torques), low, high);
        case ConditionVerdict::kWithinRounding:
            return fmt::format(
                "Condition (6) is met within rounding only {}: d(T tau_f)/dtau is {} to {}, so the stiction that reaches the "
                "joint stays the same{}.",
                range(c.torques), low, high, c.values.low < -kSlightest ? " at its weakest place" : "");
        case ConditionVerdict::kNotKnown:
            return "Condition (6) is not known: the law covers no co-contraction in use.";
        case ConditionVerdict::kMixed:
            break;
    }
    std::string where;
    for (const core::Range& part : c.holds) where += (where.empty() ? "" : ", ") + range(part);
    return fmt::format("Condition (6) holds {}, of the co-contractions {}: d(T tau_f)/dtau is {} to {}.", where, range(c.torques), low,
                       high);
}

}  // namespace fusee::report
