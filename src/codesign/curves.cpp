#include "curves.h"

#include "fusee/actuator/dead_band.h"
#include "fusee/cam/arm.h"
#include "fusee/pipeline/design.h"

namespace fusee::codesign {

namespace {

constexpr std::size_t kSamples = 401, kLevels = 61;

}  // namespace

report::LawCurves law_curves(const profile::Profile& profile, const spring::SpringLawPtr& law, core::Range torques) {
    report::LawCurves curves;
    curves.samples = spring::sample_by_load(*law, kSamples);
    const actuator::Actuator joint = pipeline::actuator_of(profile, law);
    for (std::size_t i = 0; i < kLevels; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(kLevels - 1);
        curves.dead_band.push_back(actuator::dead_band(joint, torques.low + share * torques.width()));
    }
    return curves;
}

report::CamCurve cam_curve(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law) {
    report::CamCurve curve;
    curve.kind = kind;
    const profile::PartSpec& spec = kind == cam::PartKind::kSeries ? profile.k_se : profile.k_pe;
    const cam::ArmFunction arm(kind, law, spec.spring, profile.rig.capstan_radius, spec.allowance);
    for (const spring::LawPoint& p : spring::sample_by_load(*law, kSamples)) curve.arms.push_back(arm.at_load(p.tau));
    auto designed = pipeline::design_part(kind, profile, law);
    curve.findings = designed ? designed->findings : designed.refusal();
    if (designed) curve.part = std::move(designed).value().part;
    return curve;
}

void note_search(report::SearchReport& report, const profile::Profile& profile, const design::EvolutionResult& found) {
    report.population = profile.search.population;
    report.generations = found.generations;
    report.seed = profile.search.seed;
    report.evaluations = found.evaluations;
    report.interrupted = found.interrupted;
    report.cost = found.cost;
    report.history = found.history;
}

}  // namespace fusee::codesign
