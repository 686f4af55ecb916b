#include "curves.h"

#include "fusee/actuator/dead_band.h"
#include "fusee/cam/arm.h"
#include "fusee/pipeline/design.h"

namespace fusee::search::codesign {

namespace {

constexpr std::size_t kSamples = 401, kLevels = 61;

}  // namespace

LawCurves law_curves(const actuator::Actuator& joint, core::Range torques) {
    LawCurves curves;
    curves.samples = spring::sample_by_load(*joint.law, kSamples);
    for (std::size_t i = 0; i < kLevels; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(kLevels - 1);
        curves.dead_band.push_back(actuator::dead_band(joint, torques.low + share * torques.width()));
    }
    return curves;
}

CamCurve cam_curve(cam::PartKind kind, const pipeline::ResolvedDesign& design) {
    CamCurve curve;
    curve.kind = kind;
    const cam::ArmFunction arm = design.arm(kind);
    for (const spring::LawPoint& p : spring::sample_by_load(*design.law(), kSamples)) curve.arms.push_back(arm.at_load(p.tau));
    auto designed = pipeline::design_part(kind, design);
    curve.findings = designed ? designed->findings : designed.refusal();
    if (designed) curve.part = std::move(designed).value().part;
    return curve;
}

void note_search(SearchReport& report, const profile::Profile& profile, const design::EvolutionResult& found) {
    report.population = profile.search.population;
    report.generations = found.generations;
    report.seed = profile.search.seed;
    report.evaluations = found.evaluations;
    report.interrupted = found.interrupted;
    report.cost = found.cost;
    report.history = found.history;
}

}  // namespace fusee::search::codesign
