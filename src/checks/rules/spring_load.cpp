#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kFewest = 1e4;
constexpr double kUltimateShear = 0.67;  // of the tensile strength

/// Share of the wire's strength that lasts the stated cycles from zero; it falls with their logarithm, constant outside 1e5 to 1e7.
double lasting_share(const spring::BaseSpring& s) {
    const double decades = std::clamp(std::log10(s.cycles) - 5.0, 0.0, 2.0);
    return (s.kind == spring::BaseKind::kTorsion ? 0.53 : 0.36) - 0.03 * decades;
}

/// Goodman's line through the range from zero: the amplitude that lasts at no mean stress [Pa]. With half the share s as amplitude and
/// mean, Sa = (s/2)/(1 - (s/2)/u), u = ultimate share.
double lasting_amplitude(const spring::BaseSpring& s, double ultimate) {
    const double half = 0.5 * lasting_share(s) * spring::tensile_strength(s);
    return half / (1.0 - half / ultimate);
}

/// Unstated cycles count as many.
bool may_tire(const Design& design) { return design.spring.cycles <= 0.0 || design.spring.cycles >= kFewest; }

core::Findings measure_spring_fatigue(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    const double ultimate = (torsion ? 1.0 : kUltimateShear) * spring::tensile_strength(s), lasting = lasting_amplitude(s, ultimate);
    const double low = s.rate * least_state(design), high = s.rate * largest_state(design);
    const double a = 0.5 * spring::wire_stress(s, high - low), m = 0.5 * spring::wire_stress(s, high + low);
    core::Finding f = compare(1.0 / (a / lasting + m / ultimate), {allowed("required")});
    f.what =
        fmt::format("safety of the wire for {:.3g} cycles from {:.4g} to {:.4g} {}: amplitude {:.0f} of {:.0f} MPa, mean {:.0f} of {:.0f}",
                    s.cycles, low, high, torsion ? "Nm" : "N", a / kPaPerMPa, lasting / kPaPerMPa, m / kPaPerMPa, ultimate / kPaPerMPa);
    f.suggestion = stronger_wire(design, spring::tensile_strength(s) * f.allowed / f.measured).or_else("a thicker wire with more turns");
    return {f};
}

core::Findings measure_spring_leg_bending(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double radius = leg_bend_radius(s), force = leg_force(design);
    const double moment = force * (radius + 0.5 * s.wire_diameter + 0.5 * design.part.options.features.leg_slot_depth);
    const double share = spring::allowed_share(s);
    core::Finding f =
        compare(spring::bend_stress(s, moment, radius) / kPaPerMPa, {allowed("required", share * spring::tensile_strength(s) / kPaPerMPa)});
    f.what = fmt::format("bending stress where the leg leaves the coil, {:.1f} N in the middle of its slot, bent to {:.3g} mm inside",
                         force, mm_from_m(radius));
    f.suggestion = limit_load(design, design.spring.rate * largest_state(design) * f.allowed / f.measured);
    // The moment's lever, less the part that the slot's depth does not change.
    const double depth = 2.0 * (moment / force * f.allowed / f.measured - radius - 0.5 * s.wire_diameter);
    if (depth > 0.0) f.suggestion.or_else(change(design, "features.leg_slot_depth_mm", down(mm_from_m(depth))));
    return {f};
}

core::Findings measure_spring_load(const Design& design, const Allowed& allowed) {
    const bool torsion = design.spring.kind == spring::BaseKind::kTorsion;
    const auto most = allowed.stated(torsion ? "torque_required" : "force_required", design.spring.max_load);
    core::Finding f = compare(design.spring.rate * largest_state(design), {*most});
    f.what = torsion ? "largest torque of the base spring" : "largest force of the base spring";
    f.suggestion = limit_load(design, f.allowed);
    return {f};
}

core::Findings measure_spring_stress(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    const double load = s.rate * largest_state(design);
    const double share = spring::allowed_share(s);
    core::Finding f =
        compare(spring::wire_stress(s, load) / kPaPerMPa, {allowed("required", share * spring::tensile_strength(s) / kPaPerMPa)});
    f.what = fmt::format("{} stress of the wire at {:.4g} {}, allowed {:.0f} % of its strength", torsion ? "bending" : "shear", load,
                         torsion ? "Nm" : "N", 100.0 * share);
    f.suggestion = limit_load(design, load * f.allowed / f.measured).or_else(stronger_wire(design, f.measured / share * kPaPerMPa));
    return {f};
}

core::Findings measure_spring_torsion_angle(const Design& design, const Allowed& allowed) {
    const auto most = allowed.stated("required", design.spring.max_state);
    core::Finding f = compare(largest_state(design), {*most});
    f.what = "largest winding of the base spring, preload included";
    f.suggestion = limit_state(design, f.allowed);
    return {f};
}

constexpr double kReview = 0.80, kMost = 0.85;  // of the travel to solid; beyond, coils touch and the rate rises

core::Finding against(const Design& design, std::initializer_list<EffectiveLimit> limits, const std::string& what) {
    core::Finding f = compare(mm_from_m(largest_state(design)), limits);
    f.what = what;
    f.suggestion = limit_state(design, m_from_mm(f.allowed));
    return f;
}

core::Findings measure_spring_travel(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    core::Findings findings;
    if (const auto most = allowed.stated("rated_required", mm_from_m(s.max_state))) {
        findings.push_back(against(design, {*most}, "largest compression of the base spring, preload included"));
        findings.back().source = "spring.max_travel_mm";
    }
    if (const auto travel = spring::travel_to_solid(s)) {
        const double solid = mm_from_m(*travel);
        findings.push_back(against(design, {allowed("required", kMost * solid), allowed("review", kReview * solid)},
                                   fmt::format("largest compression of the base spring, of {:.2f} mm to solid length", solid)));
    }
    return findings;
}

}  // namespace

Rules spring_load_rules() {
    return {
        {"spring.fatigue",
         "the base spring's wire breaking after many cycles",
         "1/(amplitude/Sa + mean/Su) of the stress between least and largest state; Su the strength, 0.67 of it in shear; Sa on Goodman's "
         "line through the range from zero; from 10,000 cycles on",
         "Shigley: Goodman, Su = 0.67 UTS in shear; range from zero by Associated Spring, music wire, not peened: bending 53 % of UTS at "
         "1e5 cycles, 50 % at 1e6; shear 36, 33 and 30 % at 1e7 (practice)",
         {required(kAtLeast, "", 1.0)},
         measure_spring_fatigue,
         may_tire,
         {need::kWire, need::kCoil, need::kStrength, need::kCycles}},
        {"spring.leg_bending",
         "a torsion spring's leg breaking at its bend",
         "bending stress of the axial leg at its bend: force M/(slot radius) in the middle of the slot's depth, factor q of the bend",
         "EN 13906-3: 0.7 of the strength, q of w = 2 r/d + 1; bend of at least d: Autodesk Inventor, torsion spring calculation",
         {required(kAtMost, "MPa", "stress_share of the wire's strength, 0.7 by default")},
         measure_spring_leg_bending,
         has_torsion_leg_slot,
         {need::kWire, need::kStrength}},
        {"spring.load",
         "the base spring loaded beyond its rating",
         "rate x largest state",
         "spring.max_torque_Nm, spring.max_force_N",
         {required(kAtMost, "Nm", "spring.max_torque_Nm; not judged without it", "torque_required"),
          required(kAtMost, "N", "spring.max_force_N; not judged without it", "force_required")},
         measure_spring_load,
         nullptr,
         {need::kMaxTorque, need::kMaxForce}},
        {"spring.stress",
         "the base spring's wire yielding",
         "torsion: 32 M q/(pi d^3), q = (w + 0.07)/(w - 0.75); compression: 8 F D K_W/(pi d^3)",
         "EN 13906-3: 0.7 of the strength, q; Wahl, in shear 0.8/sqrt 3; strength: stated, or EN 10270-1 by class",
         {required(kAtMost, "MPa", "stress_share of the wire's strength, 0.7 by default; shear: that share over sqrt 3, 0.46 by default")},
         measure_spring_stress,
         nullptr,
         {need::kWire, need::kCoil, need::kStrength}},
        {"spring.torsion_angle",
         "the torsion spring wound too far",
         "largest winding, preload included",
         "spring.max_angle_rad",
         {required(kAtMost, "rad", "spring.max_angle_rad; not judged without it")},
         measure_spring_torsion_angle,
         is_torsion,
         {need::kMaxAngle}},
        {"spring.travel",
         "the compression spring compressed to its solid length",
         "largest compression, preload included",
         "80-85 % of the travel to solid length (practice)",
         {required(kAtMost, "mm", "spring.max_travel_mm; not judged without it", "rated_required"),
          required(kAtMost, "mm", "85 % of free length - (active coils + 2) wire"), review(kAtMost, "mm", "80 % of it")},
         measure_spring_travel,
         is_compression,
         {need::kTravel}},
    };
}

}  // namespace fusee::checks
