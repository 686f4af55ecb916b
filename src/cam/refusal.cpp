#include "refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "fusee/cam/contact.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "idle_arc.h"
#include "scan.h"

namespace fusee::cam {

namespace {

constexpr core::Range kArms{1e-4, 1.0};  // [m] arms and distances of contacts from the axis; other values are an error in the profile
constexpr double kLongestHelix = 20.0 * 2.0 * core::kPi;  // [rad] more turns than any cable drum of this kind has
constexpr double kWorthwhile = 1.2;                       // least ratio of a law's highest to its lowest load in a suggestion
constexpr double kPitch = 6.0;                            // of a helix, in cable diameters: groove and land
constexpr double kInside = 1e-3;                          // distance of a suggested value from its limit, relative

using Test = std::function<bool(const Contact&)>;

/// Conditions of a contact, in the order of the refusals: the first broken one hides the others.
/// A roller pushes its spring at any arm: at 0 there is no torque, beyond it the torque has the other sign.
bool possible_arm(const Contact& c, const CamOptions& options) {
    const bool roller = options.family == Family::kRoller;
    const bool size = roller ? std::abs(c.arm.arm) <= kArms.high : kArms.holds(c.arm.arm);
    return size && !(std::hypot(c.path.h, c.path.slope) > kArms.high);
}
bool convex(const Contact& c) { return c.path.rho > 0.0; }
Test guide_far_enough(const ArmFunction& arm, const CamOptions& options) {
    return [&](const Contact& c) { return guide_margin(arm.kind(), c.arm, options) > 0.0; };
}

core::Finding broken(const ArmFunction& arm, const char* rule, const char* what, const Contact& at, double measured_mm, double allowed_mm) {
    core::Finding f = core::error_finding(rule, what, measured_mm, core::Bound::kAtLeast, allowed_mm, "mm");
    f.where = fmt::format("{} at {:.4g} Nm, cam angle {:.1f} deg", to_string(arm.kind()), arm.law().at_load(at.arm.tau).tau,
                          core::deg_from_rad(at.arm.angle));
    f.source = "cable kinematics: the envelope of the cable's lines exists and is convex";
    return f;
}

std::string key_of(const ArmFunction& arm, const char* key) { return fmt::format("{}.{}", to_string(arm.kind()), key); }

core::Suggestion preload_of(const ArmFunction& arm) {
    const bool torsion = arm.kind() == PartKind::kSeries;
    const double preload = arm.base().preload;
    return core::change(key_of(arm, torsion ? "spring.preload_rad" : "spring.preload_mm"),
                        core::number(torsion ? preload : core::mm_from_m(preload), 4));
}

core::Suggestion rate_of(const ArmFunction& arm) {
    const char* key = arm.kind() == PartKind::kSeries ? "spring.rate_Nm_per_rad" : "spring.rate_N_per_m";
    return core::change(key_of(arm, key), core::number(arm.base().rate, 4));
}

/// Is every contact possible?
bool sound(const ArmFunction& arm, const CamOptions& options) {
    constexpr int kContacts = 200;
    const core::Range loads = arm.law().loads();
    const Test reached = guide_far_enough(arm, options);
    for (int i = 0; i <= kContacts; ++i) {
        const Contact c = touch(arm.kind(), arm.at_load(loads.low + loads.width() * i / kContacts), options);
        if (!possible_arm(c, options) || !reached(c) || !convex(c)) return false;
    }
    return true;
}

/// The preload, or otherwise the rate, nearest to the given one as a ratio, with which all contacts are sound.
core::Suggestion other_spring(const ArmFunction& arm, const CamOptions& options) {
    constexpr double kPreloadStep = 1.1, kRateStep = 1.25, kFromNothing = 0.01;  // no preload: first 1 % of the final state
    constexpr int kPreloadSteps = 60, kRateSteps = 160;                          // a factor of 300, of 3e15
    spring::BaseSpring base = arm.base();
    const double preload = base.preload > 0.0 ? base.preload : kFromNothing * arm.at_load(arm.law().loads().high).state;
    for (int i = 1; i <= kPreloadSteps; ++i)
        for (const int direction : {1, -1}) {
            base.preload = preload * std::pow(kPreloadStep, direction * i);
            if (const ArmFunction other = arm.on(base); sound(other, options)) return preload_of(other);
        }
    base = arm.base();
    for (int i = 1; i <= kRateSteps; ++i)
        for (const int direction : {1, -1}) {
            base.rate = arm.base().rate * std::pow(kRateStep, direction * i);
            if (const ArmFunction other = arm.on(base); sound(other, options)) return rate_of(other);
        }
    return {};
}

/// The end of the law up to which `good` holds: between the last good contact and the first bad one after the start.
core::Suggestion earlier_end(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts, const Test& good) {
    const auto bad = std::find_if_not(contacts.begin(), contacts.end(), good);
    if (bad == contacts.begin() || bad == contacts.end()) return {};
    double inside = (bad - 1)->arm.tau, outside = bad->arm.tau;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (inside + outside);
        (good(touch(arm.kind(), arm.at_load(middle), options)) ? inside : outside) = middle;
    }
    if (inside < kWorthwhile * contacts.front().arm.tau) return {};
    return core::change("law.end_torque_Nm", core::number((1.0 - kInside) * inside, 4));
}

core::Suggestion either(core::Suggestion a, const core::Suggestion& b) {
    if (a.empty() && b.empty()) return "another base spring or law: neither preload nor rate alone makes every contact possible";
    return a.or_else(b);
}

/// Without cable tension the arm is infinite. The finding then states the tension.
void state_tension(core::Finding& f, const ArmFunction& arm, const Contact& at) {
    const bool spool = arm.kind() == PartKind::kSeries;
    const double torque = spool ? arm.base().rate * at.arm.state : arm.law().at_load(at.arm.tau).f_pe;  // that the cam has to transmit
    f.what = "no cam has such a lever arm: the cable has no tension there, and the arm would be infinite";
    f.measured = std::isfinite(at.arm.tension) ? at.arm.tension : 0.0;
    f.bound = core::Bound::kAtLeast;
    f.allowed = torque / kArms.high;
    f.unit = "N";
}

/// The arm of a roller does not get there. The change is the least lever of its spring with which it does.
core::Finding arm_stuck(const ArmFunction& arm, const CamOptions& options, const Contact& at) {
    constexpr double kGrowth = 1.05;
    constexpr int kSteps = 100;  // a factor of 130
    core::Finding f = broken(
        arm, "cam.guide",
        "the follower's arm cannot turn so far: the line of its spring would meet the pivot, or the roller the line from axis to pivot", at,
        core::mm_from_m(guide_margin(arm.kind(), at.arm, options)), 0.0);
    f.source = "docs/theory/roller.md, eq. 6: the triangle of pivot and the spring's pins";
    CamOptions longer = options;
    for (int i = 1; i <= kSteps && f.suggestion.empty(); ++i) {
        longer.roller.arm.lever = options.roller.arm.lever * std::pow(kGrowth, i);
        if (sound(arm, longer))
            f.suggestion = core::change(key_of(arm, "roller.lever_mm"), core::number(core::mm_from_m(longer.roller.arm.lever), 4));
    }
    if (f.suggestion.empty()) f.suggestion = "a longer " + key_of(arm, "roller.spring_mm") + ", or a stiffer spring, which travels less";
    return f;
}

core::Finding arm_beyond(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts, const Contact& at) {
    const bool shorter = at.arm.arm < kArms.low, far_out = kArms.holds(at.arm.arm);
    const Test possible = [&](const Contact& c) { return possible_arm(c, options); };
    const char* what =
        far_out ? "the contact of the cable would be farther from the axis than any cam extends" : "no cam has such a lever arm";
    const double measured = far_out ? std::hypot(at.path.h, at.path.slope) : at.arm.arm;
    core::Finding f = broken(arm, "cam.arm", what, at, core::mm_from_m(measured), core::mm_from_m(shorter ? kArms.low : kArms.high));
    f.bound = shorter ? core::Bound::kAtLeast : core::Bound::kAtMost;
    if (!std::isfinite(f.measured)) state_tension(f, arm, at);
    f.source = "docs/theory/cams.md, table 1: springs and law of matching size";
    const spring::LawPoint law = arm.law().at_load(at.arm.tau);
    constexpr double kNone = 1e-9;  // of the largest load: a formula's 0 is seldom exact
    if ((arm.kind() == PartKind::kSeries ? law.f_se : law.f_pe) <= kNone * arm.law().loads().high) {
        f.what = "a cable cannot push: where the torque is 0 or has the other sign its arm would be 0 or negative";
        f.suggestion = earlier_end(arm, options, contacts, possible);
        f.suggestion.or_else(key_of(arm, "family") +
                             " = \"roller\", on a slide or an arm, whose lever arm crosses 0, with a compression spring and [" +
                             key_of(arm, "roller") + "]");
        return f;
    }
    f.suggestion = either(earlier_end(arm, options, contacts, possible), other_spring(arm, options));
    return f;
}

using core::mm_from_m;

/// Convex everywhere, and an idle arc of the least radius closes the rim.
bool closes(const ArmFunction& arm, const CamOptions& options) {
    constexpr std::size_t kContacts = 200;
    const std::vector<Contact> contacts = scan_contacts(arm, options, kContacts);
    if (!std::all_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.path.rho > 0.0; })) return false;
    const bool rising = options.torque_sign > 0;
    const PathPoint &low = (rising ? contacts.front() : contacts.back()).path, &high = (rising ? contacts.back() : contacts.front()).path;
    const double idle = core::kTurn - (high.psi - low.psi);
    return idle > kLeastIdleArc &&
           IdleArc::close({high.h, high.slope, high.rho}, {low.h, low.slope, low.rho}, idle, {options.path.min_idle_curvature_radius, 0.0});
}

void validate_arm(const Roller& r, const spring::BaseSpring& spring) {
    const FollowerArm& arm = r.arm;
    core::require_positive("k_pe.roller.arm_mm", mm_from_m(arm.length), "mm");
    core::require_positive("k_pe.roller.pivot_mm", mm_from_m(arm.pivot), "mm");
    core::require_positive("k_pe.roller.lever_mm", mm_from_m(arm.lever), "mm");
    core::require_positive("k_pe.roller.spring_mm", mm_from_m(arm.spring), "mm");
    const double centre = r.base_radius + r.radius, least = std::abs(centre - arm.length), most = centre + arm.length;
    if (!(least < arm.pivot && arm.pivot < most))
        throw core::InvalidInput("k_pe.roller.pivot_mm", fmt::format("{:.6g}", mm_from_m(arm.pivot)),
                                 fmt::format("between {:.4g} and {:.4g} mm, where an arm of {:.4g} mm holds the roller {:.4g} mm from the "
                                             "axis: its base and its own radius",
                                             mm_from_m(least), mm_from_m(most), mm_from_m(arm.length), mm_from_m(centre)));
    const double coils = spring.free_length - spring.preload;  // both shorten by the same travel
    if (arm.spring < coils)
        throw core::InvalidInput("k_pe.roller.spring_mm", fmt::format("{:.6g}", mm_from_m(arm.spring)),
                                 fmt::format("at least {:.4g} mm, the length of the coils under their preload", mm_from_m(coils)));
}

}  // namespace

core::Findings check_contacts(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts) {
    // Ratio to the range of possible arms; infinite arms are the worst.
    const auto misfit = [&](const Contact& c) {
        if (possible_arm(c, options)) return 0.0;
        if (!std::isfinite(c.arm.arm) || c.arm.arm <= 0.0) return std::numeric_limits<double>::infinity();
        return std::max({c.arm.arm / kArms.high, std::hypot(c.path.h, c.path.slope) / kArms.high, kArms.low / c.arm.arm});
    };
    const Contact *oddest = &contacts.front(), *nearest = oddest, *sharpest = oddest;
    for (const Contact& c : contacts) {
        if (misfit(c) > misfit(*oddest)) oddest = &c;
        if (!(guide_margin(arm.kind(), c.arm, options) >= guide_margin(arm.kind(), nearest->arm, options))) nearest = &c;
        if (!(c.path.rho >= sharpest->path.rho)) sharpest = &c;
    }
    if (!possible_arm(*oddest, options)) return {arm_beyond(arm, options, contacts, *oddest)};
    const double reach_mm = core::mm_from_m(guide_margin(arm.kind(), nearest->arm, options));
    if (!(reach_mm > 0.0)) {
        if (options.family == Family::kRoller) return {arm_stuck(arm, options, *nearest)};
        core::Finding f = broken(arm, "cam.guide", "the guide is too near: no straight cable from cam to guide has the required arm",
                                 *nearest, reach_mm, 0.0);
        f.suggestion = core::change(key_of(arm, "guide.distance_mm"),
                                    fmt::format("{:.1f}", core::mm_from_m(options.guide.distance) + 1.1 * std::abs(reach_mm) + 0.1));
        return {f};
    }
    if (convex(*sharpest)) return {};
    core::Finding f = broken(arm, "cam.convexity", "no convex contour has this arm: its radius of curvature would not be above 0",
                             *sharpest, core::mm_from_m(sharpest->path.rho), 0.0);
    const bool roller = options.family == Family::kRoller;
    f.suggestion = either(earlier_end(arm, options, contacts, convex), roller ? wider_base(arm, options) : other_spring(arm, options));
    return {f};
}

core::Findings check_wrap(const ArmFunction& arm, const Cam& cam, double travel) {
    const double wrap = cam.working_psi.width(), allowed = cam.closed() ? 2.0 * core::kPi - kLeastIdleArc : kLongestHelix;
    if (wrap <= allowed) return {};
    core::Finding f = core::error_finding(
        "cam.wrap",
        cam.closed() ? "a planar groove cannot have this wrap: it would overlap itself" : "more turns of the groove than a cam can have",
        core::deg_from_rad(wrap), core::Bound::kAtMost, core::deg_from_rad(allowed), "deg");
    f.where = to_string(arm.kind());
    // Contacts move a little against the cam's angle as the arm changes. The next run finds the remainder.
    const double angle = 0.97 * travel * allowed / wrap;
    const core::Range loads = arm.law().loads();
    const double end = solve_between([&](double tau) { return arm.at_load(tau).angle - angle; }, loads.low, loads.high);
    if (cam.closed() && !cam.has_roller())
        f.suggestion = core::change(key_of(arm, "path.kind"), core::quoted("helix"))
                           .with(key_of(arm, "path.pitch_mm"), core::number(kPitch * core::mm_from_m(cam.options.cable_diameter), 3));
    f.suggestion.or_else(core::change("law.end_torque_Nm", core::number(end, 4)));
    f.source = cam.closed() ? "geometry: one turn less the idle arc" : "docs/theory/cams.md: arms and law of matching size";
    return {f};
}

void validate_roller(const ArmFunction& function, const CamOptions& options) {
    const Roller& r = options.roller;
    if (function.kind() == PartKind::kSeries) throw core::InvalidInput("k_se.family", "roller", "cable: a spool pays out a cable");
    if (options.path.kind != PathKind::kPlanar) throw core::InvalidInput("k_pe.path.kind", "helix", "planar: a roller runs on one rim");
    if (options.cable_diameter != 0.0)
        throw core::InvalidInput("cable.diameter_mm", fmt::format("{}", mm_from_m(options.cable_diameter)), "0 on a roller cam");
    core::require_positive("k_pe.roller.radius_mm", mm_from_m(r.radius), "mm");
    core::require_positive("k_pe.roller.base_radius_mm", mm_from_m(r.base_radius), "mm");
    core::require_positive("k_pe.roller.width_mm", mm_from_m(r.width), "mm");
    if (r.follower == FollowerKind::kArm) return validate_arm(r, function.base());
    const double widest = mm_from_m(r.base_radius + r.radius);
    if (!(std::abs(mm_from_m(r.offset)) < widest))
        throw core::InvalidInput("k_pe.roller.offset_mm", fmt::format("{}", mm_from_m(r.offset)),
                                 fmt::format("less than base and roller radius together, {:.4g} mm, on either side", widest));
}

core::Suggestion wider_base(const ArmFunction& arm, const CamOptions& options) {
    constexpr double kGrowth = 1.02, kReserve = 1.002;
    constexpr int kSteps = 233;  // a factor of 100
    CamOptions wider = options;
    for (int i = 1; i <= kSteps; ++i) {
        wider.roller = with_base(options.roller, options.roller.base_radius * std::pow(kGrowth, i));
        if (!closes(arm, wider)) continue;
        const double tenths = std::ceil(mm_from_m(kReserve * wider.roller.base_radius) * 10.0);
        return base_change(options.roller, core::number(tenths / 10.0));
    }
    return {};
}

}  // namespace fusee::cam
