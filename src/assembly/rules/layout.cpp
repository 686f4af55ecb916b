#include "layout.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "gaps.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

/// Pairs that keep apart at the samples, but are not proven to between them.
std::optional<core::Finding> unproven(const std::vector<Gap>& gaps, double enough_mm) {
    const auto count = std::count_if(gaps.begin(), gaps.end(), [&](const Gap& gap) { return !is_proven(gap, enough_mm); });
    if (count == 0) return std::nullopt;
    const auto worst = std::min_element(gaps.begin(), gaps.end(), [&](const Gap& a, const Gap& b) {
        return std::pair(is_proven(a, enough_mm), a.proven_mm) < std::pair(is_proven(b, enough_mm), b.proven_mm);
    });
    return core::not_judged(
        "joint.body_gap",
        fmt::format("{} pairs of bodies between the sampled poses; least proven distance {:.2f} mm, of {} and {}, sampled "
                    "{:.2f} mm",
                    count, worst->proven_mm, worst->a, worst->b, worst->mm),
        "another place of one of them, with more space");
}

core::Findings measure_joint_body_gap(const Assembly& assembly, const Allowed& allowed) {
    const double enough = allowed("review").value();
    const std::vector<Gap> gaps = body_gaps(assembly, enough);
    if (gaps.empty()) return {};
    const Gap& least = gaps.front();
    core::Finding f = checks::compare(least.mm, {allowed("required"), allowed("review")});
    f.what = fmt::format("distance of {} and {}, proven between all poses: at least {:.2f} mm", least.a, least.b, least.proven_mm);
    f.where = place_text(least.pose);
    f.suggestion = assembly.options.motor_distance > 0.0
                       ? core::change("assembly.motor_distance_mm", "0").noted(", which takes the least that the bodies need")
                       : "another assembly.k_pe_direction_deg, or a farther guide";
    core::Findings all{f};
    if (const auto open = unproven(gaps, enough); open) all.push_back(*open);
    return all;
}

core::Findings measure_joint_cable_gap(const Assembly& assembly, const Allowed& allowed) {
    const std::vector<Gap> gaps = cable_gaps(assembly);
    if (gaps.empty()) return {};
    const Gap& least = gaps.front();
    core::Finding f = checks::compare(least.mm, {allowed("required"), allowed("review")});
    f.what = fmt::format("the {} passes {}, at sampled poses", least.a, least.b);
    f.where = place_text(least.pose);
    f.suggestion =
        least.a.starts_with(to_string(CableKind::kParallel))
            ? "another assembly.k_pe_direction_deg, or a farther guide of k_pe"
            : fmt::format("a larger assembly.motor_distance_mm than {:.0f}, or another k_se.guide", std::ceil(assembly.motor_distance_mm));
    return {f};
}

constexpr double kStraight = core::rad_from_deg(1.5);  // a cable that is bent by less runs straight through a smooth hole
constexpr int kPoses = 33;
constexpr double kRopeBend = 3.0;  // D/d of a fibre rope that is deflected

/// Largest angle by which an agonist's cable bends at its guide, over the working range [rad].
double deflection(const Assembly& a, CableKind kind) {
    double most = 0.0;
    for (int i = 0; i < kPoses; ++i) {
        const double share = i / (kPoses - 1.0);
        const Pose pose{{share * a.greatest_turn, share * a.greatest_payout_mm}, {}};
        const double along = kind == CableKind::kSeries ? 0.5 * core::kPi : a.options.k_pe_direction;
        for (const FreeCable& cable : free_cables(a, pose)) {
            if (cable.kind != kind || cable.side != Side::kAgonist) continue;
            const Eigen::Vector3d from = (cable.to_mm - cable.from_mm).normalized(), to(std::cos(along), std::sin(along), 0.0);
            most = std::max(most, std::acos(std::clamp(from.dot(to), -1.0, 1.0)));
        }
    }
    return most;
}

core::Suggestion softer_bend(const Assembly& a, const std::string& part, double allowed) {
    const double radius = 0.5 * allowed * a.cable_mm;
    if (radius > guide_edge_mm(a.cable_mm, INFINITY))
        return core::change(part + ".guide.kind", core::quoted("idler"))
            .with(part + ".guide.radius_mm", checks::up(radius + 0.5 * a.cable_mm));
    return core::change("assembly.wall_mm", checks::up(2.0 * radius));
}

core::Findings measure_joint_guide_edge(const Assembly& a, const Allowed& allowed) {
    const checks::CableLimits& cable = checks::cable_limits(a.drive.cable.construction);
    const double edge = guide_edge_mm(a.cable_mm, core::mm_from_m(a.options.wall));
    core::Findings all;
    for (const auto& [kind, part, body] : {std::tuple(CableKind::kSeries, a.drive.k_se.get(), "carriage"),
                                           std::tuple(CableKind::kParallel, a.drive.k_pe.get(), "k_pe_seat")}) {
        const double bend = deflection(a, kind);
        if (part->cam.options.guide.kind == cam::GuideKind::kIdler || bend <= kStraight) continue;
        core::Finding f = checks::compare(2.0 * edge / a.cable_mm,
                                          {allowed("required"), allowed("review", cable.is_fibre() ? kRopeBend : cable.critical)});
        f.what =
            fmt::format("D/d of the {} cable, which bends by {:.1f} deg over the edge of its guide's hole, rounded by hand to {:.3g} mm",
                        to_string(kind), core::deg_from_rad(bend), edge);
        f.where = body;
        f.suggestion = softer_bend(a, to_string(part->cam.kind), f.allowed);
        all.push_back(std::move(f));
    }
    return all;
}

core::Findings measure_joint_leg_phase(const Assembly& assembly, const Allowed& allowed) {
    const auto leg = leg_angle(assembly.drive, assembly.find("k_se_agonist")->rest);
    if (!leg) return {};  // joint.spring_leg says what is not stated, or that there is no slot
    const double aside = core::deg_from_rad(std::remainder(assembly.leg_post_angle - *leg, 2.0 * core::kPi));
    const spring::BaseSpring& s = assembly.drive.k_se_spring;
    core::Finding f = checks::compare(std::abs(aside), {allowed("required"), allowed("review")});
    f.what = fmt::format(
        "angle by which the preload of {:.1f} deg changes when the radial leg is put into its post, at {:.0f} deg: {:g} coils "
        "and the preload leave it at {:.0f} deg",
        core::deg_from_rad(s.preload), core::deg_from_rad(assembly.leg_post_angle), s.active_coils,
        core::deg_from_rad(std::remainder(*leg, 2.0 * core::kPi)));
    f.where = "carriage";
    const double slot = core::deg_from_rad(assembly.drive.k_se->options.features.leg_slot_angle) + aside;
    f.suggestion = core::change("k_se.features.leg_slot_angle_deg", core::number(std::round(std::remainder(slot, 360.0))))
                       .noted(", which turns the post beside the cable");
    return {f};
}

using core::mm_from_m;

constexpr double kRounding_mm = 1e-9;
constexpr double kSlotPlay_mm = 0.1, kSlotStep_mm = 0.1;  // rule assembly.leg_width allows 0 to 0.5 mm
constexpr double kSlotLength = 1.8, kSlotDepth = 2.3;     // in wire diameters (practice)

/// What is judged of one leg: the length that the walls of its slot hold, and why there is none.
struct Held {
    double mm = 0.0;
    std::string why;  ///< "" where some of it is held
};

/// How the leg along the axis is held, at the coils' mean radius, in the spool.
Held in_spool(const Assembly& a) {
    const spring::BaseSpring& s = a.drive.k_se_spring;
    const solid::FeatureOptions& slot = a.drive.k_se->options.features;
    if (slot.leg_slot_width <= 0.0) return {0.0, "k_se has no slot"};
    if (s.wire_diameter > slot.leg_slot_width + core::m_from_mm(kRounding_mm)) return {0.0, "the slot of k_se is narrower than the wire"};
    const double aside = std::abs(slot.leg_slot_radius - 0.5 * s.coil_diameter) + 0.5 * (s.wire_diameter - slot.leg_slot_length);
    if (aside > core::m_from_mm(kRounding_mm))
        return {0.0, fmt::format("the slot of k_se misses it by {:.2f} mm along the radius", mm_from_m(aside))};
    return {mm_from_m(slot.leg_slot_depth), ""};
}

/// Height of the radial leg's middle in a state: the last coil of the body.
double leg_height_mm(const Assembly& a, double state) {
    return a.spring_low_mm + wound_length_mm(a.drive.k_se_spring, state) - 0.5 * mm_from_m(a.drive.k_se_spring.wire_diameter);
}

/// How the radial leg is held in the carriage's post: in every state it must lie between the slot's floor and the post's top.
Held in_carriage(const Assembly& a) {
    const spring::BaseSpring& s = a.drive.k_se_spring;
    const LegSlot& slot = a.leg_slot;
    const double half = 0.5 * mm_from_m(s.wire_diameter);
    if (2.0 * half > slot.width_mm + kRounding_mm) return {0.0, "the slot of the carriage's post is narrower than the wire"};
    const double below = slot.floor_mm - (leg_height_mm(a, s.preload) - half),
                 above = leg_height_mm(a, most_wound(s, *a.drive.k_se)) + half - slot.top_mm;
    if (below > kRounding_mm) return {0.0, fmt::format("least wound it would lie {:.2f} mm below the slot's floor", below)};
    if (above > kRounding_mm) return {0.0, fmt::format("wound most it rises {:.2f} mm out of the slot", above)};
    return {std::min(slot.far_mm, leg_end_mm(a.leg_post_mm, s)) - std::max(slot.near_mm, mm_from_m(0.5 * s.coil_diameter) + half), ""};
}

core::Finding judged(const Held& held, const char* leg, const char* where, const Allowed& allowed, double wire_mm) {
    core::Finding f = checks::compare(std::max(held.mm, 0.0), {allowed("review", wire_mm)});
    f.what = fmt::format("length of the torsion spring's {} leg that the slot holds{}{}", leg, held.why.empty() ? "" : ": ", held.why);
    f.where = where;
    return f;
}

/// Depth of a slot for the leg [mm]: that of the upper plate of a stack, and never through the part.
double slot_depth_mm(const Drive& drive) {
    const solid::Part& part = *drive.k_se;
    const double wanted = kSlotDepth * mm_from_m(drive.k_se_spring.wire_diameter), rib = mm_from_m(part.options.groove.rib);
    if (checks::is_stacked(drive.process)) return rib;
    return std::min(wanted, mm_from_m(part.z_high - part.z_low - checks::process_limits(drive.process).loaded_wall));
}

/// A slot that fits the leg.
core::Suggestion slot_for(const Drive& drive) {
    const spring::BaseSpring& s = drive.k_se_spring;
    const double wire = mm_from_m(s.wire_diameter), width = kSlotStep_mm * std::ceil((wire + kSlotPlay_mm) / kSlotStep_mm - kRounding_mm);
    return core::change("k_se.features.leg_slot_width_mm", core::number(width))
        .with("k_se.features.leg_slot_length_mm", core::number(std::max(kSlotLength * wire, 1.2 * width), 3))
        .with("k_se.features.leg_slot_depth_mm", core::number(slot_depth_mm(drive), 3))
        .with("k_se.features.leg_slot_radius_mm", core::number(0.5 * mm_from_m(s.coil_diameter), 4));
}

core::Findings measure_joint_spring_leg(const Assembly& assembly, const Allowed& allowed) {
    const spring::BaseSpring& s = assembly.drive.k_se_spring;
    if (assembly.leg_slot.width_mm <= 0.0) {
        core::Finding f = core::not_judged("joint.spring_leg", "a leg of a torsion spring that nothing holds",
                                           "k_se.spring.wire_mm, k_se.spring.coil_mm and k_se.spring.active_coils");
        f.where = "k_se";
        return {f};
    }
    const double wire = mm_from_m(s.wire_diameter);
    core::Finding spool = judged(in_spool(assembly), "axial", "k_se", allowed, wire);
    spool.suggestion = slot_for(assembly.drive);
    core::Finding carriage = judged(in_carriage(assembly), "radial", "carriage", allowed, wire);
    carriage.suggestion = "the layout's own post, which fits the spring that the profile states";
    return {spool, carriage};
}

constexpr double kDead_deg = 30.0;  // always wound

/// Turns side by side: a helical groove. Or a law that ends earlier.
std::string capstan_change(const Assembly& assembly, double measured_deg, double allowed_deg) {
    constexpr double kPitch = 1.25;  // in cables (practice)
    const double turns = (measured_deg + 360.0 - allowed_deg) / 360.0, pitch = kPitch * assembly.cable_mm;
    return fmt::format(
        "a capstan with a helical groove of {:.2f} turns, {:.2g} mm apart, which is not modelled; or a law that ends at {} deg "
        "of the capstan",
        turns, pitch, checks::down(allowed_deg - kDead_deg));
}

core::Findings measure_joint_winding(const Assembly& assembly, const Allowed& allowed) {
    const double turn = core::deg_from_rad(assembly.greatest_turn), joint = core::deg_from_rad(assembly.joint_range);
    const bool on_joint = joint > turn;
    core::Finding f = checks::compare(kDead_deg + std::max(turn, joint), {allowed("review")});
    f.what = fmt::format("cable wound on the {} in its last pose", on_joint ? "joint's pulley" : "capstan");
    f.where = on_joint ? "joint_pulley" : "capstan";
    f.suggestion = on_joint ? core::change("assembly.joint_range_deg", checks::down(f.allowed - kDead_deg)).noted(", with stops there")
                            : core::Suggestion(capstan_change(assembly, f.measured, f.allowed));
    return {f};
}

}  // namespace

Rules layout_rules() {
    return {
        {{"joint.body_gap",
          "two bodies of the joint that meet",
          "least distance of two bodies that do not touch by design, over the working range of both sides",
          "no contact; 0.3 mm for printed parts that move (3dservicesusa, +-0.3 mm)",
          {required(kAtLeast, "mm", 0.3), review(kAtLeast, "mm", 0.9)}},
         measure_joint_body_gap},
        {{"joint.cable_gap",
          "a cable that rubs on a body",
          "least distance of a free cable's surface from the bodies that it does not touch, over the working range",
          "no contact; a slack cable sags by about its diameter (practice)",
          {required(kAtLeast, "mm", 0.1), review(kAtLeast, "mm", 0.8)}},
         measure_joint_cable_gap},
        {{"joint.guide_edge",
          "a cable that frays on the edge of its guide's hole",
          "D/d over the edge of the hole in carriage and seat, which is rounded to 1.5 cables or half of their wall; where the cable bends "
          "by more than 1.5 deg",
          "Samson: D/d 3 where a rope is deflected; wire: the critical D/d of table 1; Sava: half the strength is left at D/d 1, the end "
          "of "
          "its table; 1.5 deg: a smooth drum's fleet (wirerope.net)",
          {required(kAtLeast, "", 1.0), review(kAtLeast, "", "3 for fibre, the critical D/d for wire (table 1)")}},
         measure_joint_guide_edge},
        {{"joint.leg_phase",
          "a torsion spring that cannot have its preload",
          "angle between the radial leg, as slot, coils and preload leave it at the law's lowest load, and its post: the layout places the "
          "post there, unless the series cable passes",
          "geometry: the legs are 2 pi n + preload apart; 2 deg (practice), 10 deg are 5 % of a preload of 200 deg",
          {required(kAtMost, "deg", 10.0), review(kAtMost, "deg", 2.0)}},
         measure_joint_leg_phase},
        {{"joint.spring_leg",
          "a leg of a torsion spring that nothing holds",
          "length of each leg between the walls of its slot, in every state: the axial one in K_SE, the radial one in the carriage's post, "
          "where it rises by a wire diameter per turn of winding",
          "body length d (N + 1 + theta): newcombspring.com; one wire diameter (practice)",
          {review(kAtLeast, "mm", "the wire's diameter")}},
         measure_joint_spring_leg},
        {{"joint.winding",
          "a cable that winds onto itself or onto its anchor",
          "angle of the cable on capstan and joint pulley when it is wound most, with 30 deg that never unwind",
          "one turn less the anchor's 15 deg (practice)",
          {review(kAtMost, "deg", 345.0)}},
         measure_joint_winding},
    };
}

}  // namespace fusee::assembly
