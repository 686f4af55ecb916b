#include "fusee/pipeline/headline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/design/robust.h"
#include "fusee/pipeline/budget.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/simulation.h"

namespace fusee::pipeline {

namespace {

ExpectedWidth width_at(const design::DrawnJoint& drawn, double tau, const design::ShopScatter& scatter) {
    ExpectedWidth width;
    width.tau = tau;
    width.nominal = actuator::dead_band(drawn.actuator, tau).exact_width;
    width.built = design::robust_dead_band(drawn, tau, scatter).band;
    return width;
}

MadeArm made_arm(const PartReport& report, const profile::Profile& profile, double tolerance_mm) {
    const std::vector<cam::Contact>& working = report.part->cam.working;
    const auto least = std::min_element(working.begin(), working.end(), [](const auto& a, const auto& b) { return a.arm.arm < b.arm.arm; });
    return {report.name.empty() ? profile.table_of(report.part->cam.kind) : report.name, tolerance_mm, core::mm_from_m(least->arm.arm)};
}

std::optional<design::budget::Budget> budget_of(const ResolvedDesign& design, const std::vector<PartReport>& parts, int draws) {
    if (parts.size() != 2) return std::nullopt;
    const auto subject = budget_subject(design, {&parts[0].part->cam, &parts[1].part->cam});
    if (!subject) return std::nullopt;
    const profile::Rig& rig = design.profile.rig;
    return design::budget::budget_of(*subject, std::array{rig.least_torque, rig.overdrive_torque}, {.draws = draws});
}

SpringFigures spring_figures(const ResolvedDesign& design, const std::vector<PartReport>& parts) {
    constexpr std::size_t kSamples = 801;
    const double first = std::get<profile::OneSpring>(design.profile.law.curves).first_angle();
    const std::vector<spring::LawPoint> samples = spring::sample_by_load(*design.law(), kSamples);
    SpringFigures figures{{first, first + samples.back().theta}, {samples.front().tau, samples.front().tau}};
    for (const spring::LawPoint& p : samples)
        figures.torques = {std::min(figures.torques.low, p.tau), std::max(figures.torques.high, p.tau)};
    std::vector<const cam::Cam*> cams;
    for (const PartReport& part : parts) cams.push_back(&part.part->cam);
    if (!parts.empty()) figures.built_error = spring_budget(design, cams).parts.front().worst().band.high;
    return figures;
}

}  // namespace

Headline headline_of(const ResolvedDesign& design, const std::optional<Simulation>& simulation, const std::vector<PartReport>& parts,
                     int draws) {
    const profile::Profile& profile = design.profile;
    Headline headline;
    headline.process = checks::to_string(profile.process.kind);
    for (const PartReport& part : parts)
        headline.arms.push_back(made_arm(part, profile, core::mm_from_m(checks::process_limits(profile.process).tolerance)));
    std::erase_if(headline.arms, [](const MadeArm& arm) { return !(arm.least_arm_mm > arm.tolerance_mm); });
    if (!simulation) {
        headline.spring = spring_figures(design, parts);
        return headline;
    }
    const fusee::design::DrawnJoint drawn = design.drawn_joint();
    headline.least = width_at(drawn, profile.rig.least_torque, shop_scatter(profile));
    headline.overdrive = width_at(drawn, profile.rig.overdrive_torque, shop_scatter(profile));
    headline.budget = budget_of(design, parts, draws);
    if (headline.budget) {
        const auto built = [&](std::size_t i) {
            const design::budget::WidthBudget& width = headline.budget->widths[i];
            return headline.budget->draws > 0 ? width.sampled : width.band;
        };
        headline.least.built = built(0), headline.overdrive.built = built(1);
    }
    headline.joint_torque = simulation->survey.torque;
    headline.condition = simulation->condition;
    return headline;
}

ConditionVerdict condition_verdict(const actuator::ConditionSummary& c) {
    if (std::isnan(c.values.high)) return ConditionVerdict::kNotKnown;
    if (c.everywhere()) return c.values.high <= -kSlightestSlope ? ConditionVerdict::kHolds : ConditionVerdict::kWithinRounding;
    if (std::max(std::abs(c.values.low), std::abs(c.values.high)) < kSlightestSlope) return ConditionVerdict::kWithinRounding;
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

}  // namespace fusee::pipeline
