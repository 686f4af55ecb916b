#include "figures.h"

#include <algorithm>
#include <cmath>

#include "fusee/pipeline/budget.h"
#include "fusee/solid/mesh.h"
#include "fusee/spring/coil.h"

namespace fusee::search::one_spring {

namespace {

using pipeline::Depth;

constexpr double kUnseen = 100.0;                   // cost of a step that was not reached
constexpr double kReview = 0.1, kMostReview = 2.0;  // a warning is worth this share of the room, and more as it is beyond its limit
// Energy over the room of a wound spring's coils, of those of profiles/single [J/m^3].
constexpr double kTorsionDensity = 0.3e6, kCompressionDensity = 0.14e6;

constexpr double kPlainBearing = 0.15;  // coefficient of friction, dry

constexpr double kFarthest = 9.0;

/// How far a figure is beyond its limit, in e-folds, at most 9.
double e_folds_beyond(const core::Finding& f) {
    const double ratio = f.bound == core::Bound::kAtMost ? f.measured / f.allowed : f.allowed / f.measured;
    return ratio > 1.0 ? std::min(kFarthest, std::log(ratio)) : kFarthest;
}

/// The same of a limit that its figure does not come nearer to step by step (a curvature below 0): how far the base radius is from the one
/// that the finding asks for.
double e_folds_beyond(const core::Finding& f, const profile::PartSpec& spec) {
    for (const core::Changes& changes : f.suggestion.changes())
        if (changes.front().key == "cam.roller.base_radius_mm")
            return std::min(kFarthest, std::abs(std::log(core::m_from_mm(std::stod(changes.front().value)) / spec.cam.roller.base_radius)));
    return e_folds_beyond(f);
}

/// Diameter and height of the cylinder about the axis around a part [m].
DraftFigures cylinder(const solid::Part& body) {
    double radius = 0.0;
    const cam::Cam& cam = body.cam;
    const double step = cam.groove_psi.width() / 360.0;
    for (int i = 0; i <= 360; ++i) {
        const cam::PathPoint p = cam.path(cam.groove_psi.low + i * step);
        radius = std::max(radius, std::hypot(p.h, p.slope));
    }
    double lips = 0.0;
    for (const solid::SectionPoint& p : body.section) lips = std::max(lips, core::m_from_mm(p.offset_mm));
    DraftFigures figures;
    figures.diameter = 2.0 * (radius + lips + body.options.flange_height);
    figures.height = body.z_high - body.z_low + body.options.hub.boss_height;
    return figures;
}

/// That the coils of a spring fill, unloaded [m^3].
double coils(const spring::BaseSpring& s) {
    const double outside = s.coil_diameter + s.wire_diameter;
    const double length = s.kind == spring::BaseKind::kTorsion ? (s.active_coils + 1.0) * s.wire_diameter : s.free_length;
    return 0.25 * core::kPi * outside * outside * length;
}

/// The cylinder of one part, and the room of its spring.
DraftFigures part_size(const pipeline::EvaluatedPart& part, const profile::Profile& draft) {
    DraftFigures figures = cylinder(*part.body);
    spring::BaseSpring s = draft.part(part.kind).spring;
    double state = 0.0;
    for (const cam::Contact& c : part.cam->working) state = std::max(state, c.arm.state);
    spring::derive_length_and_rating(s, state);
    if (spring::coil_known(s)) return figures.spring_volume = coils(s), figures;
    const bool torsion = part.kind == cam::PartKind::kSeries;
    figures.spring_volume = 0.5 * s.rate * state * state / (torsion ? kTorsionDensity : kCompressionDensity);
    return figures;
}

/// The greatest torque that slide or pivot of a roller takes as a plain bearing [Nm]; NaN: no roller.
double guide_friction(const cam::Cam& cam) {
    if (!cam.has_roller()) return core::kNan;
    double most = 0.0;
    for (const cam::Contact& c : cam.working) most = std::max(most, cam::guide_friction(c.arm, cam.options, kPlainBearing));
    return most;
}

/// Of all parts, one on the other. @param torque largest of the law, without sign [Nm]
DraftFigures draft_figures(const pipeline::Evaluation& seen, const profile::Profile& draft, double torque) {
    DraftFigures all;
    std::vector<const cam::Cam*> cams;
    for (const pipeline::EvaluatedPart& part : seen.parts) {
        const DraftFigures one = part_size(part, draft);
        all.diameter = std::max(all.diameter, one.diameter);
        all.height += one.height;
        all.spring_volume += one.spring_volume;
        cams.push_back(&*part.cam);
    }
    all.built_error = pipeline::spring_budget(*seen.design, cams).parts.front().worst().band.high;
    all.guide_friction = guide_friction(*cams.front()) / torque;
    return all;
}

/// Figure over limit, of several parts the worst; NaN: not judged.
double share_used(const core::Findings& findings, const char* rule) {
    double worst = core::kNan;
    for (const core::Finding& f : findings) {
        if (f.rule != rule || f.severity == core::Severity::kNotJudged) continue;
        const double share = f.measured / f.allowed;
        worst = f.bound == core::Bound::kAtMost ? std::fmax(worst, share) : std::fmin(worst, share);
    }
    return worst;
}

}  // namespace

core::Findings broken_in(const core::Findings& all, core::Severity severity) {
    core::Findings broken;
    std::copy_if(all.begin(), all.end(), std::back_inserter(broken), [=](const core::Finding& f) { return f.severity == severity; });
    return broken;
}

double DraftFigures::room() const { return 0.25 * core::kPi * diameter * diameter * height + spring_volume; }

double cost_of(const pipeline::Evaluation& seen, const profile::Profile& draft) {
    const core::Findings all = seen.all(), errors = broken_in(all, core::Severity::kError);
    const auto has = [&](const auto& what) { return !seen.parts.empty() && std::all_of(seen.parts.begin(), seen.parts.end(), what); };
    const bool whole = has([](const pipeline::EvaluatedPart& part) { return part.reached == Depth::kOutline; });
    if (!whole || !errors.empty()) {
        double cost = kRefused;
        if (!seen.design) cost += 2.0 * kUnseen;
        if (!whole) cost += has([](const pipeline::EvaluatedPart& part) { return part.cam.has_value(); }) ? kUnseen : 2.0 * kUnseen;
        for (const core::Finding& f : errors) cost += 1.0 + e_folds_beyond(f, draft.part(draft.part_kinds().front()));
        return cost;
    }
    double reviews = 1.0, needed = 0.0;
    for (const pipeline::EvaluatedPart& part : seen.parts) needed += part_size(part, draft).room();
    for (const core::Finding& f : broken_in(all, core::Severity::kWarning)) reviews += kReview + std::min(kMostReview, e_folds_beyond(f));
    const double size = 1e6 * needed * reviews;  // [cm^3]
    return size / (1e3 + size);                  // below 1, whatever the size
}

Family::Candidate candidate_of(const pipeline::Evaluation& seen, const profile::Profile& draft, double torque) {
    const spring::BaseSpring& s = draft.part(draft.part_kinds().front()).spring;
    return {draft_figures(seen, draft, torque), s.rate, s.preload};
}

Figures figures_of(const pipeline::Evaluation& seen, const profile::Profile& profile, double torque) {
    Figures all{draft_figures(seen, profile, torque)};
    for (const pipeline::EvaluatedPart& part : seen.parts) all.volume += 1e-9 * solid::volume_mm3(part.body->mesh);
    const core::Findings findings = seen.all();
    all.stress_share = share_used(findings, "spring.stress");
    all.fatigue_safety = share_used(findings, "spring.fatigue");
    return all;
}

}  // namespace fusee::search::one_spring
