#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

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

}  // namespace

Rule joint_spring_leg() {
    return {
        {"joint.spring_leg",
         "a leg of a torsion spring that nothing holds",
         "length of each leg between the walls of its slot, in every state: the axial one in K_SE, the radial one in the carriage's post, "
         "where it rises by a wire diameter per turn of winding",
         "body length d (N + 1 + theta): newcombspring.com; one wire diameter (practice)",
         {review(kAtLeast, "mm", "the wire's diameter")}},
        measure_joint_spring_leg};
}

}  // namespace fusee::assembly
