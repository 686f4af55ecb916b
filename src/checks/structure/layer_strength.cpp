#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kLayerShare = 0.5;  // strength across layers over the material's

bool has_printed_boss(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return works(design) && design.process.kind == ProcessKind::kFdm && hub.boss_height > 0.0 && 0.5 * hub.boss_diameter > hub_radius(hub);
}

/// Stresses at the edge of the boss's root, a ring from the farthest point of bore and keyway to the boss's outside [Pa]. The shaft inside
/// is not counted.
struct RootStress {
    double bending = 0.0, torsion = 0.0;
    /// Largest shear stress in any plane, doubled: Tresca's equivalent.
    [[nodiscard]] double equivalent() const { return std::hypot(bending, 2.0 * torsion); }
};

RootStress root_stress(const solid::Part& part, const cam::Contact& contact) {
    const solid::HubOptions& hub = part.options.hub;
    const double outside = 0.5 * hub.boss_diameter, inside = hub_radius(hub);
    const double second_moment = 0.25 * core::kPi * (std::pow(outside, 4) - std::pow(inside, 4));
    const double lever = hub.kind == solid::HubKind::kOverhung ? contact.path.z - part.z_low : 0.0;  // a shaft that passes carries bending
    const double force = contact.arm.tension;
    return {force * lever * outside / second_moment, force * contact.arm.arm * outside / (2.0 * second_moment)};
}

core::Findings measure_structure_layer_strength(const Design& design, const Allowed& allowed) {
    const solid::Part& part = design.part;
    const cam::Contact& worst = worst_contact(part.cam, [&](const cam::Contact& c) { return root_stress(part, c).equivalent(); });
    const RootStress stress = root_stress(part, worst);
    const Material material = material_of(design.process);
    core::Finding f = compare(kLayerShare * material.strength / stress.equivalent(), {allowed("required"), allowed("review")});
    f.what = fmt::format("safety of the layers at the boss's root at {:.1f} N: {:.2g} MPa of bending and {:.2g} MPa of torsion in {}",
                         worst.arm.tension, stress.bending / kPaPerMPa, stress.torsion / kPaPerMPa, material.name);
    locate(f, design, worst.path);
    f.suggestion = change(design, "hub.boss_mm", up(mm_from_m(part.options.hub.boss_diameter) * std::cbrt(f.allowed / f.measured)));
    return {f};
}

}  // namespace

Rule structure_layer_strength() {
    return {
        "structure.layer_strength",
        "a boss that parts from its cam between two layers",
        "FDM: half the material's strength over the equivalent stress at the boss's root, of the cable's force at its height and torque",
        "strength of PLA across layers 47.8 % below the filament's: doi 10.1089/3dp.2020.0109; Tresca; safety 2 against scatter (practice)",
        {required(kAtLeast, "", 1.0), review(kAtLeast, "", 2.0)},
        measure_structure_layer_strength,
        has_printed_boss};
}

}  // namespace fusee::checks
