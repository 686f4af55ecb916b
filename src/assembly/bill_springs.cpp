#include <fmt/format.h>

#include <cmath>

#include "layout.h"

namespace fusee::assembly {

namespace {

using core::mm_from_m;

std::string stated(double value, const char* unit) { return value > 0.0 ? fmt::format("{:g}{}", value, unit) : "not stated"; }

/// ", EN 10270-1 SH"; "" where the class is not stated.
std::string wire_of(const spring::BaseSpring& s) {
    constexpr std::array kNames{"", ", EN 10270-1 SL", ", EN 10270-1 SM", ", EN 10270-1 SH", ", EN 10270-1 DM", ", EN 10270-1 DH"};
    static_assert(kNames.size() == spring::kWireClassNames.size());
    return kNames.at(static_cast<std::size_t>(s.wire_class));
}

std::string torsion_size(const spring::BaseSpring& s) {
    return fmt::format("{:g} Nm/rad, wire {}{}, mean coil {}, coils {}", s.rate, stated(mm_from_m(s.wire_diameter), " mm"), wire_of(s),
                       stated(mm_from_m(s.coil_diameter), " mm"), stated(s.active_coils, ""));
}
/// "270 deg beyond 25 turns": the angle of the unloaded legs, as a spring maker sets it.
std::string free_legs(const spring::BaseSpring& s) {
    const double whole = std::floor(s.active_coils);
    return fmt::format("unloaded, the radial leg is {:.0f} deg beyond {:g} turns from the axial one, in the sense in which the coils rise",
                       360.0 * (s.active_coils - whole), whole);
}

/// The legs from the coil on: along the axis into the slot of K_SE, and through the post of the carriage.
std::string legs_of(const Assembly& a) {
    const spring::BaseSpring& s = a.drive.k_se_spring;
    const solid::FeatureOptions& slot = a.drive.k_se->options.features;
    if (s.wire_diameter <= 0.0 || s.coil_diameter <= 0.0 || s.active_coils <= 0.0) return "ends: straight legs, their lengths not stated";
    const double coil = mm_from_m(0.5 * s.coil_diameter), in_slot = mm_from_m(slot.leg_slot_depth) + 0.5 * mm_from_m(a.options.gap);
    const double beyond = leg_end_mm(a.leg_post_mm, s);
    const std::string axial =
        slot.leg_slot_width > 0.0
            ? fmt::format("a leg along the axis, {:.1f} mm long, {:g} mm from the axis, for the slot of k_se", in_slot, coil)
            : std::string("k_se has no slot for a leg along the axis: how its end is held is not stated");
    return fmt::format(
        "ends: {}; a radial leg that ends {:.1f} mm from the axis, {:.1f} mm from the coil, for the slotted post of the "
        "carriage; {}",
        axial, beyond, beyond - coil, free_legs(s));
}

/// Hands of the torsion springs, one a side.
std::string hands_of(const spring::BaseSpring& agonist) {
    if (agonist.hand == spring::Hand::kUnknown) return "one of each hand";
    const bool left = agonist.hand == spring::Hand::kLeft;
    return fmt::format("{} hand on the agonist's side, {} hand on the antagonist's", left ? "left" : "right", left ? "right" : "left");
}

std::string compression_size(const spring::BaseSpring& s) {
    return fmt::format("{:g} N/m, wire {}{}, mean coil {}, active coils {}, free length {}", s.rate,
                       stated(mm_from_m(s.wire_diameter), " mm"), wire_of(s), stated(mm_from_m(s.coil_diameter), " mm"),
                       stated(s.active_coils, ""), stated(mm_from_m(s.free_length), " mm"));
}

}  // namespace

std::array<BillRow, 2> spring_rows(const Assembly& a) {
    return {BillRow{"torsion spring", 2, torsion_size(a.drive.k_se_spring), hands_of(a.drive.k_se_spring) + "; " + legs_of(a)},
            BillRow{"compression spring", 2, compression_size(a.drive.k_pe_spring), "ends closed and ground"}};
}

}  // namespace fusee::assembly
