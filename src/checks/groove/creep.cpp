#include "means.h"

namespace fusee::checks {

namespace {

/// Depth by which a line load q = T/rho sinks into a half-space of modulus E over the width d, below what moves at the depth of 10 d:
/// 2 q/(pi E) (ln 20 + 1/2), Boussinesq's strip under its middle, plane stress. @returns [m]
double sunk(double tension, double rho, double modulus) { return 2.0 * tension / rho / (core::kPi * modulus) * (std::log(20.0) + 0.5); }

core::Findings measure_groove_creep(const Design& design, const Allowed& allowed) {
    const Material material = material_of(design.process);
    const cam::Contact& rest = design.part.cam.working.front();
    if (!(rest.path.rho > 0.0)) return {};  // no floor: cam.convexity
    const double depth = sunk(rest.arm.tension, rest.path.rho, material.creep_modulus);
    core::Finding f = judge(100.0 * depth / rest.arm.arm, {allowed("review")});
    f.what = fmt::format("share of the {:.2f} mm arm at rest that creep takes over years: {:.1f} N sink the cable {:.3f} mm into {}",
                         mm_from_m(rest.arm.arm), rest.arm.tension, mm_from_m(depth), material.name);
    locate(f, design, rest.path, -0.5 * design.cable.diameter);
    f.suggestion = change("material.modulus_MPa", up(material.modulus / kPaPerMPa * f.measured / f.allowed))
                       .or_else("released cables when the joint rests");
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
