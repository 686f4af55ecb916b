#include "fusee/pipeline/budget.h"

#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"

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
    return design::budget::budget_of_spring(subjects, design.profile.rig.capstan_radius, name);
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
    return core::each<std::string>(holding, [&](const checks::ProcessLimits& p) { return checks::to_string(p.kind); });
}

}  // namespace fusee::pipeline
