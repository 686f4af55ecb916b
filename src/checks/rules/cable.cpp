#include <array>
#include <string_view>

#include "fusee/checks/along.h"
#include "means.h"

namespace fusee::checks {

namespace {

bool has_anchor(const Design& design) { return design.part.options.features.anchor_hole_diameter > 0.0; }

core::Findings measure_cable_anchor_edge(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    core::Finding f = compare(design.part.options.features.anchor_edge_radius / d, {allowed("review")});
    f.what = "radius of the anchor hole's edge, over which the cable bends to its end";
    f.where = at_anchor(design);
    f.suggestion = change(design, "features.anchor_edge_mm", up(mm_from_m(f.allowed * d))).noted(": round it by hand");
    return {f};
}

core::Findings measure_cable_anchor_load(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const Cable& cable = design.cable;
    const double friction = cable_limits(cable.construction).friction, held = termination_limits(cable).strength;
    const auto at_end = [&](const cam::Contact& c) { return c.arm.tension * std::exp(-friction * wound_angle(cam, c)); };
    const cam::Contact& worst = worst_contact(cam, at_end);
    if (worst.arm.tension <= 0.0) return {};
    const BreakingLoad load = breaking_load(cable);
    core::Finding f = compare(held * load.newton / at_end(worst), {allowed("required"), allowed("review")});
    f.what =
        fmt::format("safety of the {}, which holds {:.0f} % of the cable's strength: {:.1f} N reach it through {:.0f} deg of wound cable{}",
                    to_string(cable.termination), 100.0 * held, at_end(worst), deg_from_rad(wound_angle(cam, worst)), load.remark(cable));
    f.where = at_anchor(design);
    f.suggestion = change("cable.breaking_load_N", up(f.allowed * at_end(worst) / held));
    return {f};
}

constexpr double kSafety = 5.0;    // of running cable
constexpr double kExponent = 3.7;  // lg 13/lg 2

core::Findings measure_cable_bend_life(const Design& design, const Allowed& allowed) {
    const Cable& cable = design.cable;
    const CableLimits& table = cable_limits(cable.construction);
    const double d = cable.diameter;
    const BreakingLoad load = breaking_load(cable);
    // Breaking load over tension, times D/d: the reciprocal of the pressure by which tests on different sheaves agree.
    const auto factor = [&](const cam::Contact& c) {
        return load.newton / c.arm.tension * (2.0 * c.path.rho - d) / d / (kSafety * table.recommended);
    };
    const cam::Contact& worst = worst_contact(design.part.cam, [&](const cam::Contact& c) { return -factor(c); });
    if (worst.arm.tension <= 0.0) return {};
    core::Finding f = compare(factor(worst), {allowed("review")});
    f.what = fmt::format("safety x D/d at {:.1f} N, over {:g} x {:g}", worst.arm.tension, kSafety, table.recommended);
    if (!table.is_fibre() && factor(worst) > 0.0)
        f.what += fmt::format(": {:.2g} of the bending life there", std::pow(factor(worst), kExponent));
    f.what += load.remark(cable);
    locate(f, design, worst.path);
    if (factor(worst) > 0.0)
        f.suggestion = change("cable.breaking_load_N", up(load.newton * f.allowed / f.measured));
    else
        f.suggestion = fmt::format("a contour with rho above {} mm", up(mm_from_m(0.5 * d)));
    return {f};
}

core::Findings measure_cable_bend_ratio(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    const cam::Contact& contact = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.path.rho; });
    const cam::PathPoint& worst = contact.path;
    core::Finding f = judge_bend(bend_ratio(contact, d), design, allowed);
    f.what = fmt::format("D/d at the cable's sharpest bend, rho {:.3f} mm at a {:.3g} mm cable", mm_from_m(worst.rho), mm_from_m(d));
    locate(f, design, worst);
    const double needed = 0.5 * d * (1.0 + f.allowed);
    if (worst.rho > 0.0)
        f.suggestion = change("cable.diameter_mm", down(mm_from_m(2.0 * worst.rho / (1.0 + f.allowed))))
                           .or_else(scale_arms(design, needed / worst.rho).begun(fmt::format("rho {} mm there: ", up(mm_from_m(needed)))));
    else
        f.suggestion = fmt::format("a law or spring whose contour has rho {} mm there", up(mm_from_m(needed)));
    return {f};
}

constexpr double kStrengthStep = 0.99, kThinnest = 0.01;  // step and end of the search for a thinner cable, of d

core::Findings measure_cable_bend_strength(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    const cam::PathPoint& sharpest = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.path.rho; }).path;
    core::Finding f = compare(100.0 * strength_left(design.cable.construction, (2.0 * sharpest.rho - d) / d), {allowed("review")});
    f.what = fmt::format("strength left in the cable at its sharpest bend, rho {:.3f} mm", mm_from_m(sharpest.rho));
    locate(f, design, sharpest);
    double thinner = d;
    while (100.0 * strength_left(design.cable.construction, (2.0 * sharpest.rho - thinner) / thinner) < f.allowed &&
           thinner > kThinnest * d)
        thinner *= kStrengthStep;
    f.suggestion = change("cable.diameter_mm", down(mm_from_m(thinner)));
    return {f};
}

core::Findings measure_cable_breaking_load(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const double d = design.cable.diameter;
    const auto left = [&](const cam::Contact& c) { return strength_left(design.cable.construction, (2.0 * c.path.rho - d) / d); };
    const cam::Contact& worst = worst_contact(cam, [&](const cam::Contact& c) { return c.arm.tension / left(c); });
    if (worst.arm.tension <= 0.0) return {};
    const BreakingLoad load = breaking_load(design.cable);
    core::Finding f = compare(load.newton * left(worst) / worst.arm.tension, {allowed("required"), allowed("review")});
    f.what = fmt::format("safety against breaking at {:.1f} N, with {:.0f} % of the strength left at this bend{}", worst.arm.tension,
                         100.0 * left(worst), load.remark(design.cable));
    locate(f, design, worst.path);
    f.suggestion = change("cable.breaking_load_N", up(f.allowed * worst.arm.tension / left(worst)));
    return {f};
}

core::Findings measure_cable_knot(const Design& design, const Allowed& allowed) {
    const double hole = design.part.options.features.anchor_hole_diameter, d = design.cable.diameter;
    if (hole <= 0.0) return {};
    const double tolerance = process_limits(design.process).tolerance, width = termination_limits(design.cable).width;
    core::Finding f = compare((hole + tolerance) / d, {allowed("review", width)});
    f.what = fmt::format("width of the anchor hole with its tolerance, {:g} mm, which the cable's {} has to bridge", mm_from_m(tolerance),
                         to_string(design.cable.termination));
    f.where = at_anchor(design);
    f.suggestion = change(design, "features.anchor_hole_mm", down(mm_from_m(f.allowed * d - tolerance)));
    return {f};
}

constexpr double kConfined = 1.5;  // a material that cannot move aside yields at 1.67 times its strength

/// Pressure under which a wire rope does not wear the groove of a steel sheave [MPa].
struct Sheave {
    std::string_view construction;
    double on_steel;
};
// Of 6x7, 6x19 and 6x37: 550, 900 and 1075 psi.
constexpr std::array kSheaves{Sheave{"7x7", 3.8}, Sheave{"7x19", 6.2}, Sheave{"7x49", 7.4}};
constexpr double kCastIron = 480.0 / 900.0;  // of that under 6x19; the tables have no aluminium

/// [MPa]; infinity where no table that was read has the pair: any fibre, and wire on plastic.
double wear_limit(const Cable& cable, std::string_view material) {
    for (const Sheave& sheave : kSheaves) {
        if (sheave.construction != cable.construction) continue;
        if (material == "steel") return sheave.on_steel;
        if (material == "aluminium") return kCastIron * sheave.on_steel;
    }
    return INFINITY;
}

core::Findings measure_cable_pressure(const Design& design, const Allowed& allowed) {
    const double d = design.cable.diameter;
    const auto pressure = [d](const cam::Contact& c) { return floor_pressure(c, d); };
    const cam::Contact& worst = worst_contact(design.part.cam, pressure);
    const double bears = bearing_strength(design) / kPaPerMPa;
    const bool own = design.cable.max_pressure > 0.0;
    const double wear = own ? INFINITY : wear_limit(design.cable, material_of(design.process).name);
    core::Finding f =
        own ? compare(pressure(worst) / kPaPerMPa, {allowed("required", bears)})
            : compare(pressure(worst) / kPaPerMPa, {allowed("required", kConfined * bears), allowed("review", std::min(bears, wear))});
    f.what = fmt::format("bearing pressure 2T/(D d) at {:.1f} N on a floor of {:.2f} mm diameter; strength {}", worst.arm.tension,
                         mm_from_m(2.0 * worst.path.rho - d), bearing_origin(design));
    if (wear < bears) f.what += fmt::format("; {} wears its groove from {:.2g} MPa on", design.cable.construction, wear);
    locate(f, design, worst.path, -0.5 * d);
    f.suggestion = fmt::format("a material that allows {} MPa", up(f.measured));
    // D d = (2 rho - d) d = 2T/p: the smaller root; the contour's rho does not depend on d.
    const double rho = worst.path.rho, root = rho * rho - 2.0 * worst.arm.tension / (kPaPerMPa * f.allowed);
    if (root > 0.0) f.suggestion.or_else(change("cable.diameter_mm", up(mm_from_m(rho - std::sqrt(root)))));
    return {f};
}

bool states_load(const Design& design) { return design.cable.breaking_load > 0.0; }

core::Findings measure_cable_stated_load(const Design& design, const Allowed& allowed) {
    const Cable& cable = design.cable;
    const double strongest = strongest_cable(cable.construction, cable.diameter);
    core::Finding f = compare(cable.breaking_load, {allowed("required", strongest)});
    f.what = fmt::format("stated breaking load against that of the strongest {:.3g} mm {} cable on sale", mm_from_m(cable.diameter),
                         cable.construction);
    f.where = at_anchor(design);
    f.suggestion = change("cable.breaking_load_N", down(f.allowed));
    f.source = cable_sizes(cable.construction).source;
    return {f};
}

core::Findings measure_cable_termination(const Design& design, const Allowed& allowed) {
    const TerminationLimits& end = termination_limits(design.cable);
    core::Finding f = compare(100.0 * end.strength, {allowed("review")});
    f.what = fmt::format("share of its breaking load that a {} of {} holds with a {}", end.fibre ? "cord" : "wire rope",
                         design.cable.construction, to_string(end.kind));
    f.where = at_anchor(design);
    Cable crimped = design.cable;
    crimped.termination = Termination::kCrimp;
    f.suggestion = change("cable.termination", quoted("crimp"))
                       .noted(fmt::format(": a sleeve holds {:.0f} %", 100.0 * termination_limits(crimped).strength));
    f.source = end.source;
    return {f};
}

}  // namespace

Rules cable_rules() {
    return {
        {"cable.anchor_edge",
         "an edge that cuts the cable where it enters its hole",
         "radius of the anchor hole's edge; the part is made with a sharp one, features.anchor_edge_mm is rounded by hand",
         "Sava: half the strength is left at D/d 1, the end of its table; Samson: D/d 3 where a rope is deflected",
         {review(kAtLeast, "d", 0.5)},
         measure_cable_anchor_edge,
         has_anchor},
        {"cable.anchor_load",
         "the cable breaking at its end",
         "least of breaking load x strength of the termination (table 6) / (tension x e^(-friction x angle wound between anchor and "
         "contact))",
         "friction: UHMWPE 0.05, wire 0.1, the least; safety 3, at least 1.5 (practice)",
         {required(kAtLeast, "", 1.5), review(kAtLeast, "", 3.0)},
         measure_cable_anchor_load,
         works},
        {"cable.bend_life",
         "a cable that wears out by bending under its tension",
         "least of breaking load/tension x D/d, over 5 x recommended D/d (table 1)",
         "OIPEEC, F. Sloan: load share over D/d unites bending tests; wire: Sava, up to 13 times the life for twice the pulley; safety 5 "
         "(practice)",
         {review(kAtLeast, "", 1.0)},
         measure_cable_bend_life,
         works},
        {"cable.bend_ratio",
         "the cable bent so sharply that it wears out",
         "D/d = (2 rho - d)/d at the sharpest working bend",
         "by construction: Sava, Strandcore, The Complete Rigger's Apprentice",
         {required(kAtLeast, "", "the construction's critical figure (table 1), or cable.min_bend_ratio"),
          review(kAtLeast, "", "the construction's recommended figure (table 1); none beside cable.min_bend_ratio")},
         measure_cable_bend_ratio,
         works},
        {"cable.bend_strength",
         "a cable that loses too much strength where it bends",
         "strength left at the sharpest working bend (table 2)",
         "Sava; fibre and 70 % (practice)",
         {review(kAtLeast, "%", 70.0)},
         measure_cable_bend_strength,
         works},
        {"cable.breaking_load",
         "the cable breaking under its largest tension",
         "least of breaking load x strength left at D/d (table 2) / tension",
         "safety 5, at least 3 (practice) for running cable; strength left at D/d: Sava",
         {required(kAtLeast, "", 3.0), review(kAtLeast, "", 5.0)},
         measure_cable_breaking_load,
         works},
        {"cable.knot",
         "a knot or sleeve pulled through its hole",
         "diameter of the anchor hole and the process's tolerance",
         "width of the termination (table 6)",
         {review(kAtMost, "d", "width of the termination (table 6)")},
         measure_cable_knot},
        {"cable.pressure",
         "the cable cutting into the groove's floor",
         "largest 2T/(D d)",
         "2T/(D d) against the strength of the part's material in compression (oceanmax: sheaves of plastic yield above it); in a groove "
         "the floor yields at 1.5 times that (Johnson: a line contact at 1.67), so the review limit has a safety of 1.5 (Pugsley: 1.45 "
         "for good material and analysis, loads that springs bound). Wire wears metal long before: cast steel of 160 HB bears 3.8, 6.2 "
         "and 7.4 MPa under 6x7, 6x19 and 6x37 (Wire Rope Users Manual, at eng-tips), cast iron 0.53 of that under 6x19 (Handbook of "
         "Rigging, by K3NA), which is taken for aluminium",
         {required(kAtMost, "MPa", "cable.max_pressure_MPa, or 1.5 times the material's bearing strength (table 5)"),
          review(kAtMost, "MPa",
                 "the material's bearing strength; under 7x7, 7x19, 7x49 on steel 3.8, 6.2, 7.4 MPa, on aluminium 2, 3.3, 3.9 MPa; none "
                 "beside cable.max_pressure_MPa")},
         measure_cable_pressure,
         works},
        {"cable.stated_load",
         "a breaking load that no cable of this diameter has",
         "cable.breaking_load_N",
         "fibre 2070 N/mm^2 of d^2: oceanbluefishing, UHMWPE braid, 138 lb at 0.545 mm; wire 900: MIL-DTL-83420",
         {required(kAtMost, "N", "strongest cable on sale of this construction and diameter")},
         measure_cable_stated_load,
         states_load},
        {"cable.termination",
         "an end that the construction does not bear",
         "share of its breaking load that the cable holds at its end",
         "table 6; half of it (practice)",
         {review(kAtLeast, "%", 50.0)},
         measure_cable_termination},
    };
}

}  // namespace fusee::checks
