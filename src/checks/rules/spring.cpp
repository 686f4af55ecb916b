#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_active_coils(const Design& design, const Allowed& allowed) {
    core::Finding f = compare(design.spring.active_coils, {allowed("required"), allowed("review")});
    f.what = "active coils of the base spring";
    f.suggestion = change(design, "spring.active_coils", up(f.allowed));
    return {f};
}

core::Findings measure_spring_body_growth(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const auto space = allowed.stated("required", mm_from_m(s.free_length));
    const double turns = largest_state(design) / (2.0 * core::kPi);
    core::Finding f = compare(mm_from_m(spring::wound_length(s, largest_state(design))), {*space});
    f.what = fmt::format("length of the base spring's body when it is wound by {:.2f} turns", turns);
    f.suggestion = change(design, "spring.free_length_mm", up(f.measured));
    return {f};
}

constexpr double kYoung = 207e9, kShear = 79.3e9;  // spring steel [Pa]
constexpr double kC1 = kYoung / (2.0 * (kYoung - kShear));
constexpr double kC2 = 2.0 * core::kPi * core::kPi * (kYoung - kShear) / (2.0 * kShear + kYoung);

/// alpha: both ends on the pins of a follower's arm, or on flat parallel plates.
double ends(const Design& design) { return is_on_arm(design) ? 1.0 : 0.5; }

/// Free length below which the spring is stable at every compression: lambda^2 = C2, that is 5.25 D between plates.
double stable_length(const Design& design) { return std::sqrt(kC2) * design.spring.coil_diameter / ends(design); }

/// y_cr = L0 C1 (1 - sqrt(1 - C2/lambda^2)), lambda = alpha L0/D. @pre longer than stable_length
double critical_compression(const Design& design) {
    const spring::BaseSpring& s = design.spring;
    const double slenderness = ends(design) * s.free_length / s.coil_diameter;
    return s.free_length * kC1 * (1.0 - std::sqrt(1.0 - kC2 / (slenderness * slenderness)));
}

/// A shorter spring where its travel still fits in; a guide in any case. The cable runs through the coils, so that a rod is a tube.
core::Suggestion change_of(const Design& design) {
    const spring::BaseSpring& s = design.spring;
    const double stable = mm_from_m(stable_length(design)), outside = mm_from_m(s.coil_diameter + s.wire_diameter);
    const auto travel = spring::travel_to_solid(s);
    const double solid = travel ? mm_from_m(s.free_length - *travel) : 0.0, least = solid + mm_from_m(largest_state(design));
    const std::string guide =
        s.rod_diameter > 0.0
            ? fmt::format("the stated rod of {:g} mm as a tube around the cable, over the whole spring", mm_from_m(s.rod_diameter))
            : std::string("a guide tube inside, around the cable, over the whole spring");
    const std::string guides = fmt::format("{}, or a sleeve of more than {:.3g} mm around the coils", guide, outside);
    if (least > stable)
        return fmt::format("{}; no shorter spring: stable below {:.1f} mm, but its turns and travel need {:.1f} mm", guides, stable, least);
    return change(design, "spring.free_length_mm", down(stable)).or_else(guides);
}

core::Findings measure_spring_buckling(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    core::Finding f;
    if (s.free_length <= stable_length(design)) {
        f = compare(mm_from_m(s.free_length), {allowed("length_review", mm_from_m(stable_length(design)))});
        f.what = "free length of the base spring: stable at every compression";
        return {f};
    }
    f = compare(mm_from_m(largest_state(design)), {allowed("review", mm_from_m(critical_compression(design)))});
    f.what = fmt::format("largest compression of the slender base spring, against its buckling compression {}",
                         is_on_arm(design) ? "on two pins" : "between flat plates");
    f.suggestion = change_of(design);
    return {f};
}

core::Findings measure_spring_coil_gap(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const auto solid = spring::travel_to_solid(s);
    core::Finding f = compare(mm_from_m(*solid - largest_state(design)), {allowed("review", mm_from_m(spring::least_gaps(s)))});
    f.what = fmt::format("remaining travel between the coils of the base spring at its largest compression, under a {} load",
                         spring::is_dynamic(s) ? "changing" : "rarely changing");
    f.suggestion = change(design, "spring.free_length_mm", up(mm_from_m(s.free_length) + f.allowed - f.measured))
                       .or_else(limit_state(design, *solid - m_from_mm(f.allowed)));
    return {f};
}

core::Findings measure_spring_hand(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const bool left = s.hand == spring::Hand::kLeft;
    core::Finding f = compare((left ? 1 : -1) * design.part.cam.rotation_sign, {allowed("required")});
    f.what =
        fmt::format("a {}-hand spring over the top face, {} by the part", left ? "left" : "right", f.measured > 0.0 ? "wound" : "unwound");
    f.suggestion = change(design, "spring.hand", quoted(left ? "right" : "left"))
                       .or_else(change(design, "torque_sign", number(-design.part.cam.options.torque_sign)));
    return {f};
}

core::Findings measure_spring_index(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    core::Finding f = compare(spring::spring_index(s), {allowed("low_required"), allowed("high_required"), allowed("review")});
    f.what = "index of the base spring: mean coil diameter over wire";
    f.suggestion = change(design, "spring.coil_mm", number(mm_from_m(f.allowed * s.wire_diameter), 4));
    return {f};
}

core::Findings measure_spring_rate(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double coils = spring::rate_of_coils(s);
    const char* unit = is_torsion(design) ? "Nm/rad" : "N/m";
    const double off = 100.0 * std::abs(coils / s.rate - 1.0);
    // A measured rate is true; only its coils may be stated wrongly.
    const bool measured = s.rate_origin == spring::RateOrigin::kMeasured;
    core::Finding f = measured ? compare(off, {allowed("measured_review")}) : compare(off, {allowed("required"), allowed("review")});
    f.what = fmt::format("{} rate {:.4g} {} against {:.4g} {} of {:g} mm wire, {:.4g} mm coils and {:.4g} turns",
                         measured ? "measured" : "stated", s.rate, unit, coils, unit, mm_from_m(s.wire_diameter),
                         mm_from_m(s.coil_diameter), s.active_coils);
    f.suggestion = form_for_rate(design);
    return {f};
}

constexpr double kScatter = 0.1;

core::Findings measure_spring_rate_scatter(const Design& design, const Allowed& allowed) {
    const bool torsion = design.spring.kind == spring::BaseKind::kTorsion;
    const double unit = torsion ? 1.0 : mm_from_m(1.0), state = unit * largest_state(design);
    const auto most = allowed.stated(torsion ? "angle_review" : "travel_review", unit * design.spring.max_state);
    if (state > most->value()) return {};  // already beyond its range: spring.torsion_angle and spring.travel report it
    core::Finding f = compare(state / (1.0 - kScatter), {*most});
    f.what = fmt::format("largest {} of a base spring whose rate is {:.0f} % low, preload trimmed", torsion ? "winding" : "compression",
                         100.0 * kScatter);
    f.suggestion = limit_state(design, (1.0 - kScatter) * f.allowed / unit).or_else("the measured rate in the profile");
    return {f};
}

/// "the axle's, 6 mm": a torsion spring stands on the axle of its spool, on a sleeve around it, or where the axle is turned down.
std::string what_stands_inside(const Design& design) {
    const double axle = through_axle(design), inside = inner_rod(design);
    const char* what = axle <= 0.0      ? (is_torsion(design) ? "arbor" : "rod")
                       : inside == axle ? "axle"
                       : inside > axle  ? "sleeve on the axle"
                                        : "axle, turned down there";
    return fmt::format("that of the {}, {:g} mm", what, mm_from_m(inside));
}

core::Findings measure_spring_rod(const Design& design, const Allowed& allowed) {
    const double inside = spring::inside_diameter(design.spring, largest_state(design));
    core::Finding f = compare(inside / inner_rod(design), {allowed("required"), allowed("review")});
    f.what = fmt::format("inside diameter of the loaded coils, {:.2f} mm, over {}", mm_from_m(inside), what_stands_inside(design));
    f.suggestion = change(design, "spring.rod_mm", down(mm_from_m(inside / f.allowed)));
    return {f};
}

core::Findings measure_spring_surge(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double surge = spring::surge_frequency(s);
    core::Finding f = compare(surge / s.motion, {allowed("required"), allowed("review")});
    f.what = fmt::format("natural frequency of the coils, {:.1f} Hz, over that of the fastest motion, {:g} Hz", surge, s.motion);
    f.suggestion = change(design, "spring.motion_Hz", down(surge / f.allowed)).or_else("a spring of fewer turns on thicker wire");
    return {f};
}

core::Findings measure_spring_unwinding(const Design& design, const Allowed& allowed) {
    if (design.spring.kind != spring::BaseKind::kTorsion || design.part.cam.working.empty()) return {};
    const cam::Contact& least = worst_contact(design.part.cam, [](const cam::Contact& c) { return -c.arm.state; });
    core::Finding f = compare(least.arm.state, {allowed("review")});
    f.what = "least winding of the base spring, preload included: a jerk may unwind it";
    f.where = where(design, least.path.psi);
    f.suggestion = change(design, "spring.preload_rad", up(design.spring.preload + f.allowed - f.measured));
    return {f};
}

}  // namespace

Rules spring_rules() {
    return {
        {"spring.active_coils",
         "a spring whose end coils dominate its rate",
         "active coils",
         "EN 15800, EN 13906-3: at least 2; 3 (practice)",
         {required(kAtLeast, "", 2.0), review(kAtLeast, "", 3.0)},
         measure_spring_active_coils,
         nullptr,
         {need::kActiveCoils}},
        {"spring.body_growth",
         "a torsion spring that grows longer than its space",
         "length of the wound body, w (N + 1 + turns)",
         "Newcomb: the body grows by a wire each turn",
         {required(kAtMost, "mm", "spring.free_length_mm, the space along the axis; not judged without it")},
         measure_spring_body_growth,
         is_torsion,
         {need::kActiveCoils, need::kWire, need::kAxialSpace}},
        {"spring.buckling",
         "the compression spring buckling",
         "free length, or largest compression if longer than 5.25 D",
         "roymech, machinecalcs: stable below 5.25 D on flat plates",
         {review(kAtMost, "mm", "5.25 D", "length_review"), review(kAtMost, "mm", "L0 C1 (1 - sqrt(1 - C2/lambda^2)), lambda = L0/(2 D)")},
         measure_spring_buckling,
         is_compression,
         {need::kFreeLength, need::kCoil}},
        {"spring.coil_gap",
         "coils that clash before the spring is solid",
         "remaining travel to solid length at the largest compression",
         "EN 13906-1: n (0.0015 D^2/w + 0.1 w), half as much more for a changing load of a cold formed spring (febrotec)",
         {review(kAtLeast, "mm", "n (0.0015 D^2/w + 0.1 w), lengths in mm; 1.5 times that from spring.cycles = 10 000 on")},
         measure_spring_coil_gap,
         is_compression,
         {need::kWire, need::kCoil, need::kActiveCoils, need::kFreeLength}},
        {"spring.hand",
         "a torsion spring of the wrong hand",
         "sense in which the part turns the spring over its top face: 1 winds, -1 unwinds it",
         "geometry: a left-hand coil winds where its lower end turns counter-clockwise",
         {required(kAtLeast, "", 0.0)},
         measure_spring_hand,
         has_torsion_leg_slot,
         {need::kHand}},
        {"spring.index",
         "a coil too tight or too loose to wind",
         "spring index D/w",
         "EN 15800, EN 13906-3: 4 to 20; 16 (practice)",
         {required(kAtLeast, "", 4.0, "low_required"), required(kAtMost, "", 20.0, "high_required"), review(kAtMost, "", 16.0)},
         measure_spring_index,
         nullptr,
         {need::kWire, need::kCoil}},
        {"spring.rate",
         "a rate that the stated wire, coils and turns do not have",
         "difference between the stated rate and G d^4/(8 D^3 n) (compression), E d^4/(64 D n) (torsion)",
         "EN 13906-1, EN 13906-3; error: Lee Spring's tolerance of rate and torque, 10 %; warning: half of it (practice); a measured "
         "rate is only reviewed",
         {required(kAtMost, "%", 10.0), review(kAtMost, "%", 5.0), review(kAtMost, "%", 10.0, "measured_review")},
         measure_spring_rate,
         nullptr,
         {need::kWire, need::kCoil, need::kActiveCoils}},
        {"spring.rate_scatter",
         "a spring softer than specified, beyond what a preload trim corrects",
         "largest state of a spring whose rate is 10 % low, trimmed to the same load",
         "Lee Spring, springs3d: rate and torque of stock springs to 10 %; EN 15800 tolerates loads and dimensions, not the rate",
         {review(kAtMost, "rad", "spring.max_angle_rad; not judged without it", "angle_review"),
          review(kAtMost, "mm", "spring.max_travel_mm; not judged without it", "travel_review")},
         measure_spring_rate_scatter,
         nullptr,
         {need::kScatterAngle, need::kScatterTravel}},
        {"spring.rod",
         "a coil that seizes on the rod inside it",
         "inside diameter of the coils, wound to the largest state, over that of what stands inside: the guide rod; of K_SE the axle of "
         "its "
         "spool, or rod_mm, a sleeve on the axle or the axle turned down",
         "arbor clearance about 10 % (Newcomb)",
         {required(kAtLeast, "", 1.0), review(kAtLeast, "", 1.1)},
         measure_spring_rod,
         nullptr,
         {need::kWire, need::kCoil, need::kRod, need::kWoundCoils}},
        {"spring.surge",
         "coils that resonate with the motion, so that force and stress depend on time",
         "lowest natural frequency of the coils, 0.5 sqrt(k/m), over spring.motion_Hz",
         "engineersedge: 15 to 20 times; amesweb: at least 13",
         {required(kAtLeast, "", 13.0), review(kAtLeast, "", 20.0)},
         measure_spring_surge,
         nullptr,
         {need::kWire, need::kCoil, need::kActiveCoils}},
        {"spring.unwinding",
         "a torsion spring loaded against its winding",
         "least winding, preload included",
         "loaded only in the winding direction: katyspring; 0.1 rad (practice)",
         {review(kAtLeast, "rad", 0.1)},
         measure_spring_unwinding},
    };
}

}  // namespace fusee::checks
