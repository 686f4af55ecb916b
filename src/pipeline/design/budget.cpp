#include "fusee/pipeline/budget.h"

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/error.h"

namespace fusee::pipeline {

namespace {

design::budget::Tolerances tolerances_of(const profile::Profile& profile, const profile::PartSpec& spec) {
    const design::budget::BudgetOptions& o = profile.budget;
    const bool measured = spec.spring.rate_origin == spring::RateOrigin::kMeasured;
    return {.contour = checks::process_limits(profile.process).tolerance,
            .runout = o.runout > 0.0 ? o.runout : 0.5 * spec.solid.hub.bore_clearance,
            .guide = o.guide,
            .direction = o.direction,
            .rate = measured ? o.measured_rate : o.rate,
            .preload = o.preload,
            .cable = o.cable,
            .zero = o.zero,
            .friction = o.friction};
}

/// The largest torque, of whose shares the errors are [Nm].
double largest_torque(const design::budget::PartBudget& part) {
    double largest = 0.0;
    for (const design::budget::TorqueError& place : part.places) largest = std::max(largest, std::abs(place.torque));
    return largest;
}

/// The budget of two cables from those of each (docs/theory/budget.md, eq. 6): their difference is the torque. An error of the angle's zero
/// is the same for both, every other one is drawn for each. @param back its travel counts down
void subtract(design::budget::PartBudget& both, const design::budget::PartBudget& back) {
    constexpr auto kZero = static_cast<std::size_t>(design::budget::Source::kZero);
    const double of_forth = largest_torque(both), of_back = largest_torque(back);
    for (std::size_t i = 0; i < both.places.size(); ++i) both.places[i].torque -= back.places[back.places.size() - 1 - i].torque;
    const double largest = largest_torque(both);
    for (std::size_t i = 0; i < both.places.size(); ++i) {
        design::budget::TorqueError& place = both.places[i];
        const design::budget::TorqueError& other = back.places[back.places.size() - 1 - i];
        for (std::size_t k = 0; k < place.sigma.size(); ++k) {
            const double one = place.sigma[k] * of_forth / largest, two = other.sigma[k] * of_back / largest;
            place.sigma[k] = k == kZero ? one + two : std::hypot(one, two);
        }
        const double half = design::budget::kPercentile * place.whole();
        place.band = {-half, half};
    }
}

}  // namespace

std::optional<design::budget::Subject> budget_subject(const ResolvedDesign& design, const std::array<const cam::Cam*, 2>& cams) {
    design::budget::Subject subject{design.actuator, {}};
    for (std::size_t i = 0; i < cams.size(); ++i) {
        if (cams[i]->has_roller() || cams[i]->working.size() < 4) return std::nullopt;
        const profile::PartSpec& spec = design.spec(cams[i]->kind);
        subject.parts[i] = {cams[i], pulled_spring(spec), spec.allowance, tolerances_of(design.profile, spec)};
    }
    return subject;
}

design::budget::Budget spring_budget(const ResolvedDesign& design, std::span<const cam::Cam* const> cams) {
    std::vector<design::budget::PartSubject> subjects;
    const std::vector<AskedPart> parts = parts_of(design);
    for (std::size_t i = 0; i < cams.size(); ++i) {
        const profile::PartSpec& spec = parts[i].design->spec(parts[i].kind);
        subjects.push_back({cams[i], pulled_spring(spec), spec.allowance, tolerances_of(design.profile, spec)});
    }
    const std::string name = design.profile.table_of(parts.front().kind);
    design::budget::Budget budget = design::budget::budget_of_spring(subjects[0], design.profile.rig.capstan_radius, name);
    if (subjects.size() == 2) subtract(budget.parts[0], design::budget::budget_of_spring(subjects[1], 1.0, name).parts[0]);
    return budget;
}

core::Outcome<design::budget::Budget> find_budget(const profile::Profile& profile, int draws) {
    require_parts(profile);
    const auto design = resolve(profile);
    if (!design) return design.refusal();
    std::vector<cam::Cam> cams;
    for (const AskedPart& part : parts_of(*design)) {
        auto cam = design_cam(part.kind, *part.design);
        if (!cam) return cam.refusal();
        cams.push_back(std::move(cam).value());
    }
    std::vector<const cam::Cam*> all;
    for (const cam::Cam& cam : cams) all.push_back(&cam);
    if (profile.is_spring()) return spring_budget(*design, all);
    const auto subject = budget_subject(*design, {all[0], all[1]});
    if (!subject)
        throw core::InvalidInput("k_pe.family", "\"roller\"", "\"cable\": errors of a joint's cam with a roller are not modelled");
    const profile::Rig& rig = profile.rig;
    return design::budget::budget_of(*subject, std::array{rig.least_torque, rig.peak_torque, rig.overdrive_torque}, {.draws = draws});
}

design::ShopScatter shop_scatter(const profile::Profile& profile) {
    const design::budget::Tolerances se = tolerances_of(profile, profile.k_se), pe = tolerances_of(profile, profile.k_pe);
    return {.rate_se = 0.5 * se.rate, .rate_pe = 0.5 * pe.rate, .contour = 0.5 * se.contour, .friction = 0.5 * se.friction};
}

std::vector<std::string> processes_within(double tolerance) {
    std::vector<checks::ProcessLimits> holding;
    for (const checks::ProcessLimits& p : checks::process_table())
        if (p.tolerance > 0.0 && p.tolerance <= tolerance) holding.push_back(p);
    std::stable_sort(holding.begin(), holding.end(), [](const auto& a, const auto& b) { return a.tolerance > b.tolerance; });
    std::vector<std::string> names;
    for (const checks::ProcessLimits& p : holding) names.emplace_back(checks::to_string(p.kind));
    return names;
}

}  // namespace fusee::pipeline
