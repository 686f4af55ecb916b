#include "draft.h"

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"

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

}  // namespace fusee::search::one_spring
