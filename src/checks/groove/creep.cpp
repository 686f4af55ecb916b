#include "means.h"

namespace fusee::checks {

namespace {

/// Depth by which a line load q = T/rho sinks into a half-space of modulus E over the width d, below what moves at the depth of 10 d:
/// 2 q/(pi E) (ln 20 + 1/2), Boussinesq's strip under its middle, plane stress. @returns [m]
double sunk(double tension, double rho, double modulus) { return 2.0 * tension / rho / (core::kPi * modulus) * (std::log(20.0) + 0.5); }

/// The softest material of table 5 that creeps less than the allowed share where a cutter makes the part; a printer keeps to its own.
const Material* stiffer(const Design& design, double modulus) {
    const Material* best = nullptr;
    if (is_printed(design.process) || design.process.material.modulus > 0.0) return best;
    for (const Material& m : material_table())
        if (m.creep_modulus >= modulus && (best == nullptr || m.creep_modulus < best->creep_modulus)) best = &m;
    return best;
}

core::Findings measure_groove_creep(const Design& design, const Allowed& allowed) {
    const Material material = material_of(design.process);
    const cam::Contact& rest = design.part.cam.working.front();
    if (!(rest.path.rho > 0.0)) return {};  // no floor: cam.convexity
    const double depth = sunk(rest.arm.tension, rest.path.rho, material.creep_modulus);
    core::Finding f = compare(100.0 * depth / rest.arm.arm, {allowed("review")});
    f.what = fmt::format("share of the {:.2f} mm arm at rest that creep takes over years: {:.1f} N sink the cable {:.3f} mm into {}",
                         mm_from_m(rest.arm.arm), rest.arm.tension, mm_from_m(depth), material.name);
    locate(f, design, rest.path, -0.5 * design.cable.diameter);
    // Longer arms carry the same torque with less tension on a wider floor: T, 1/rho and 1/arm are each as 1/factor.
    f.suggestion = scale_arms(design, 1.01 * std::cbrt(f.measured / f.allowed));
    if (const Material* other = stiffer(design, material.creep_modulus * f.measured / f.allowed))
        f.suggestion.or_else(change("material.kind", quoted(other->name)));
    f.suggestion.or_else("released cables when the joint rests");
    return {f};
}

}  // namespace

Rule groove_creep() {
    return {
        "groove.creep",
        "a groove that creeps under the standing preload, so that its arm shrinks",
        "2 T/(pi rho E_creep) (ln 20 + 1/2) over the arm, at the law's lowest load",
        "Boussinesq's strip; Fischbach, Weinberg, arXiv 2302.11240: printed PLA creeps for years; a third of the modulus, 2 % of an arm "
        "(practice)",
        {review(kAtMost, "%", 2.0)},
        measure_groove_creep,
        works};
}

}  // namespace fusee::checks
