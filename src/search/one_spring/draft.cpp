#include "draft.h"

#include <algorithm>
#include <cmath>

#include "fix/judge.h"
#include "fusee/checks/limits.h"
#include "fusee/pipeline/budget.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"
#include "fusee/solid/mesh.h"
#include "fusee/spring/coil.h"

namespace fusee::search::one_spring {

namespace {

using PartFamily = profile::OneSpring::Family;

constexpr double kReserve = 1.1;  // of the energy taken out: a spring without load gives no torque
constexpr int kDigits = 4;

bool rolls(const std::string& name) { return name == "roller" || name == "arm"; }
PartFamily family_of(const std::string& name) {
    if (name == "two_cables") return PartFamily::kTwoCables;
    return name == "spool" ? PartFamily::kSpool : rolls(name) ? PartFamily::kRoller : PartFamily::kCable;
}

/// A spring of which nothing is chosen yet but wire and duty.
spring::BaseSpring unwound(const spring::BaseSpring& like, bool torsion) {
    spring::BaseSpring s;
    s.kind = torsion ? spring::BaseKind::kTorsion : spring::BaseKind::kCompression;
    s.wire_class = like.wire_class;
    s.cycles = like.cycles;
    s.motion = like.motion;
    s.rate = s.preload = 1.0;
    return s;
}

/// A cable's guide and anchor, where the profile's own part has a roller.
void add_cable(profile::PartSpec& spec) {
    constexpr double kGuide = 0.15, kEdge = 0.4e-3;  // [m]: a hole above the axis; an edge rounded by hand, as of the shipped parts
    spec.cam.guide.kind = cam::GuideKind::kPoint;
    spec.cam.guide.distance = kGuide;
    spec.solid.features = {};
    spec.solid.features.anchor_edge_radius = kEdge;
}

/// A ball bearing 688 of steel on the rim, where the profile's own part has a cable.
void add_roller(profile::PartSpec& spec, const checks::Process& process) {
    constexpr double kPoisson = 0.36, kYield = 1.5;  // a line contact yields below its surface at 1.67 (docs/theory/roller.md)
    const checks::Material material = checks::material_of(process);
    spec.cam.roller.radius = 8e-3;
    spec.cam.roller.width = 5e-3;
    spec.cam.roller.contact_modulus = material.modulus / (1.0 - kPoisson * kPoisson);
    spec.cam.roller.max_pressure = kYield * material.strength;
}

/// An arm at a right angle to the rim's radius at the first angle, on the side where its swing eases the pressure angle. The coils of a
/// spring on sale find room between its pins.
void place_arm(profile::PartSpec& spec, const Draft& draft, double state) {
    constexpr double kLength = 1.5, kSpring = 4.0,
                     kRoom = 1.01;  // over the roller's distance from the axis, the greatest compression, the coils
    const double rim = spec.cam.roller.base_radius + spec.cam.roller.radius, length = kLength * rim;
    const double pins = std::max(kSpring * state, kRoom * (spec.spring.free_length - spec.spring.preload));
    spec.cam.roller.arm = {length, std::hypot(length, rim), spec.cam.torque_sign, draft.lever * length, pins};
}

/// Of a helix whose turns leave a rib between them [m].
double groove_pitch(const profile::PartSpec& spec, double cable) {
    const solid::SectionPoint lip = solid::groove_section(spec.solid.groove, cable, spec.solid.chordal_error).back();
    return 2.0 * core::m_from_mm(lip.z_mm) + spec.solid.groove.rib;
}

/// One of two cables: its greatest torque [Nm] and its work [J].
struct OneWay {
    double torque = 0.0, work = 0.0;
};
/// @param sign 1: the cable that pulls forth
OneWay one_way(const Task& task, double sign, const profile::OneSpring::TwoCables& two) {
    OneWay way;
    for (const double whole : task.torques) {
        const double torque = two.pull(sign * whole);
        way.torque = std::max(way.torque, torque);
        way.work += torque * task.travel / static_cast<double>(task.torques.size());
    }
    return way;
}

/// Two equal springs: their rate by the cable with the larger torque, a preload for each.
void draw_two_cables(profile::Profile& p, const Draft& draft, const Task& task) {
    auto& two = std::get<profile::OneSpring>(p.law.curves).two_cables;
    spring::BaseSpring& s = p.k_pe.spring;
    two.least_torque = draft.least * task.torque;
    const OneWay forth = one_way(task, 1.0, two), back = one_way(task, -1.0, two);
    const bool more = forth.torque >= back.torque;
    const double load = (more ? forth : back).torque / draft.arm;
    const double full = more ? (1.0 + draft.reserve) * forth.work : (1.0 + draft.back) * back.work;
    s.rate = load * load / (2.0 * full);
    s.preload = std::sqrt(2.0 * draft.reserve * forth.work / s.rate);
    two.back_preload = std::sqrt(2.0 * draft.back * back.work / s.rate);
}

/// The preloads of both cables with the energies that they had in another spring.
void keep_energies(profile::Profile& p, const spring::BaseSpring& in) {
    const double share = std::sqrt(in.rate / p.k_pe.spring.rate);
    p.k_pe.spring.preload = share * in.preload;
    std::get<profile::OneSpring>(p.law.curves).two_cables.back_preload *= share;
}

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

bool Task::has_both_signs() const {
    return std::any_of(torques.begin(), torques.end(), [](double t) { return t < 0.0; }) &&
           std::any_of(torques.begin(), torques.end(), [](double t) { return t > 0.0; });
}

core::Outcome<Task> task_of(const profile::Profile& profile) {
    constexpr std::size_t kSamples = 801;
    const auto law = pipeline::spring_law(profile);
    if (!law) return law.refusal();
    Task task;
    for (const spring::LawPoint& p : spring::sample_by_load(**law, kSamples)) {
        task.of_first = {std::min(task.of_first.low, p.u_pe), std::max(task.of_first.high, p.u_pe)};
        task.torque = std::max(task.torque, std::abs(p.tau));
        task.torques.push_back(p.tau);
    }
    task.travel = (*law)->angles().width();
    return task;
}

profile::Profile in_family(const profile::Profile& from, const std::string& family) {
    profile::Profile p = from;
    const cam::PartKind was = from.part_kinds().front();
    auto& law = std::get<profile::OneSpring>(p.law.curves);
    const bool rolled = law.family == PartFamily::kRoller, same = law.family == family_of(family);
    law.family = family_of(family);
    const cam::PartKind kind = p.part_kinds().front();
    p.part(kind) = from.part(was);
    profile::PartSpec& spec = p.part(kind);
    spec.spring = unwound(from.part(was).spring, law.family == PartFamily::kSpool);
    if (law.family == PartFamily::kRoller && !same) add_roller(spec, p.process);
    spec.cam.roller.follower = family == "arm" ? cam::FollowerKind::kArm : cam::FollowerKind::kSlide;
    if (law.family != PartFamily::kRoller && rolled) add_cable(spec);
    if (law.family == PartFamily::kTwoCables && !same) law.two_cables.least_torque = 1.0;  // until it is searched
    if (law.family == PartFamily::kSpool && !same) p.rig.capstan_radius = 0.03;            // until it is searched
    if (law.family != PartFamily::kSpool) spec.solid.features.leg_slot_width = 0.0;
    spec.cam.path.kind = family == "helix" ? cam::PathKind::kHelix : cam::PathKind::kPlanar;
    spec.cam.path.lead = cam::Lead::kConstantPitch;
    spec.cam.path.pitch = family == "helix" ? groove_pitch(spec, p.cable.diameter) : 0.0;
    p.k_se.solid.groove = spec.solid.groove;
    p.k_se.solid.chordal_error = spec.solid.chordal_error;
    p.limits = from.limits;
    if (law.family == PartFamily::kRoller) std::erase_if(p.places, [](const auto& place) { return place.first.starts_with("cable."); });
    p.name = profile::derived_name(from.name, "-" + family);
    return profile::parse_profile(profile::to_commented_toml(p), from.file);
}

std::vector<Variable<Draft>> variables_of(const std::string& family, const profile::Profile& profile, const Task& task, bool keeps_pulley,
                                          Freedom freedom) {
    constexpr double kMostBed = 5.0;
    // Of arms that cross 0 a file keeps a ten-thousandth of a tenth of the largest: fewer millimetres are beyond its digits.
    const double least_arm = task.taken() > 0.0 ? 8e-3 : 2e-3;
    const double bed = std::min(profile.process.build_x, profile.process.build_y) * (freedom == Freedom::kBed ? kMostBed : 1.0);
    std::vector<Variable<Draft>> all;
    const auto add = [&](const char* name, const char* unit, core::Range within, double Draft::*at) {
        all.push_back({name,
                       unit,
                       {std::log(within.low), std::log(within.high)},
                       [at](Draft& d, double x) { d.*at = std::exp(x); },
                       [](double x) { return std::exp(x); }});
    };
    add("reserve", "", {0.02, 12.0}, &Draft::reserve);
    if (family == "two_cables") add("back", "", {0.02, 12.0}, &Draft::back), add("least", "", {0.02, 2.0}, &Draft::least);
    if (!(family == "spool" && keeps_pulley)) add("arm", "m", {least_arm, 0.3 * bed}, &Draft::arm);
    if (family == "spool") add("turn", "rad", {0.5, 5.6}, &Draft::turn);
    if (family == "arm") add("lever", "", {0.3, 1.5}, &Draft::lever);
    if (rolls(family)) add("base", "m", {5e-3, 0.45 * bed}, &Draft::base);
    add("rib", "m", {0.8e-3, 15e-3}, &Draft::rib);
    if (freedom == Freedom::kLaw) add("width", "", {1e-3, 0.3}, &Draft::width);
    if (freedom == Freedom::kLaw || freedom == Freedom::kTorque) add("share", "", {0.02, 1.0}, &Draft::share);
    if (freedom == Freedom::kRange) add("kept", "", {0.05, 1.0}, &Draft::kept);
    if (freedom == Freedom::kBed) add("bed", "", {1.0, kMostBed}, &Draft::bed);
    return all;
}

const spring::CatalogueSpring& nearest_sold(const std::vector<spring::CatalogueSpring>& sold, double rate) {
    return *std::min_element(sold.begin(), sold.end(), [rate](const spring::CatalogueSpring& a, const spring::CatalogueSpring& b) {
        return std::abs(std::log(a.spring.rate / rate)) < std::abs(std::log(b.spring.rate / rate));
    });
}

profile::Profile drawn(profile::Profile p, const Draft& draft, const Task& task, bool keeps_pulley,
                       const std::vector<spring::CatalogueSpring>& sold) {
    const cam::PartKind kind = p.part_kinds().front();
    profile::PartSpec& spec = p.part(kind);
    const double held = kReserve * task.taken() + draft.reserve * task.work(), full = held + task.of_first.high;
    if (p.has_two_cables()) {
        draw_two_cables(p, draft, task);
    } else if (kind == cam::PartKind::kSeries) {
        // A law that ends at the energy of its beginning turns the spool nowhere: the arm's rule says why.
        const double risen = std::max(task.of_first.high, 1e-3 * task.work()) / held;
        if (!keeps_pulley) p.rig.capstan_radius = draft.arm;
        spec.spring.preload = draft.turn / (std::sqrt(1.0 + risen) - 1.0);
        spec.spring.rate = 2.0 * held / (spec.spring.preload * spec.spring.preload);
    } else {
        const double load = task.torque / draft.arm;  // at the greatest energy, about
        spec.spring.rate = load * load / (2.0 * full);
        spec.spring.preload = std::sqrt(2.0 * held / spec.spring.rate);
    }
    if (!sold.empty()) {
        const double cycles = spec.spring.cycles;
        const spring::BaseSpring made = spec.spring;
        spec.spring = nearest_sold(sold, spec.spring.rate).spring;
        spec.spring.preload = std::sqrt(2.0 * held / spec.spring.rate);
        if (p.has_two_cables()) keep_energies(p, made);
        spec.spring.cycles = cycles;
    }
    spec.cam.roller.base_radius = draft.base;
    if (spec.cam.roller.follower == cam::FollowerKind::kArm) place_arm(spec, draft, std::sqrt(2.0 * full / spec.spring.rate));
    for (profile::PartSpec* part : {&p.k_se, &p.k_pe}) part->solid.groove.rib = draft.rib;
    spec.solid.rim_width = spec.cam.roller.width + 2.0 * draft.rib + 0.2e-3;
    if (spec.cam.path.kind == cam::PathKind::kHelix) spec.cam.path.pitch = groove_pitch(spec, p.cable.diameter);
    return profile::rounded(std::move(p), kDigits);
}

double DraftFigures::room() const { return 0.25 * core::kPi * diameter * diameter * height + spring_volume; }

double cost_of(const pipeline::Evaluation& seen, const profile::Profile& draft) {
    const core::Findings all = seen.all(), errors = fix::broken_in(all, core::Severity::kError);
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
    for (const core::Finding& f : fix::broken_in(all, core::Severity::kWarning))
        reviews += kReview + std::min(kMostReview, e_folds_beyond(f));
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
