#include <algorithm>
#include <cmath>
#include <limits>

#include "dowels.h"
#include "fusee/core/units.h"
#include "fusee/solid/sweep.h"
#include "fusee/toolpath/program.h"

namespace fusee::toolpath {

namespace {

using core::kTurn;
using core::mm_from_m;

constexpr double kWidestStep = 0.05;  // [rad]: where h'' is 0 the error of the lines is of higher order in the step
constexpr double kLeastDepth_mm = 1e-6;
constexpr double kShank_mm = 3.0;  // least, of the groove's cutter
constexpr double kNut_mm = 6.0, kArbor_mm = 15.0, kChuckLength_mm = 60.0;

/// The cutter's tip on the groove's floor, with the normal psi towards the spindle.
struct Station {
    double psi, x, y, z;  ///< machine [mm]: z the tip's height above the axis
    double top;           ///< of the uncut stock there [mm]
};

/// The data of a wrap.
struct Wrap {
    Wrap(const solid::Part& wrapped, const Settings& settings);
    [[nodiscard]] cam::PathPoint at(double psi) const;

    const solid::Part& part;
    double half_cable, lip, tolerance;
    double outline = 0.0;  ///< planar: extent of the upper flange beyond the pitch curve [mm]
    double radius = 0.0;   ///< of the round stock around the blank [mm]
    double reach = 0.0;    ///< largest height of the part above the tip: the slender section of the cutter is longer [mm]
    std::vector<Station> stations;

private:
    void place_stations();
    void measure_stock();
    [[nodiscard]] double step(const cam::PathPoint& p) const;
    [[nodiscard]] Station station(double psi) const;
};

Wrap::Wrap(const solid::Part& wrapped, const Settings& settings)
    : part(wrapped),
      half_cable(mm_from_m(0.5 * part.cam.options.cable_diameter)),
      lip(part.section.front().offset_mm),
      tolerance(mm_from_m(settings.tolerance)),
      outline(lip + solid::flanges_of(part.options).upper_height_mm) {
    measure_stock();
    place_stations();
}

cam::PathPoint Wrap::at(double psi) const {
    const core::Range groove = part.cam.groove_psi;
    if (part.cam.closed()) psi = core::within_turn(psi, groove.low);
    return part.cam.path(std::clamp(psi, groove.low, groove.high));
}

/// Planar: both flanges and the boss, each with its own height over the tip; helix: the common circle of both flanges.
void Wrap::measure_stock() {
    const solid::Flanges flanges = solid::flanges_of(part.options);
    const double boss = part.options.hub.boss_height > 0.0 ? 0.5 * mm_from_m(part.options.hub.boss_diameter) : 0.0;
    const core::Range groove = part.cam.groove_psi;
    radius = boss;
    double lowest = std::numeric_limits<double>::infinity();
    for (double psi = groove.low; psi <= groove.high; psi += 0.01) {
        const cam::PathPoint p = at(psi);
        const double tip = mm_from_m(p.h) - half_cable;
        lowest = std::min(lowest, tip);
        for (const auto& [offset, core_radius] :
             {std::pair{outline, 0.0}, std::pair{lip + flanges.lower_height_mm, flanges.core_radius_mm}}) {
            const solid::Point2 q = solid::flange_point(p, offset, core_radius).point;
            radius = std::max(radius, std::hypot(q[0], q[1]));
            reach = std::max(reach, q[0] * std::cos(psi) + q[1] * std::sin(psi) - tip);
        }
    }
    if (!part.cam.closed()) radius = std::max(radius, solid::helix_radius_mm(part));
    reach = std::max(reach, (part.cam.closed() ? boss : radius) - lowest);
}

/// Eq. 3: between stations Y, Z and A are linear, with an error of h'' dpsi^2/8 in the height and h''^2 dpsi^2/(8 rho) in the envelope.
double Wrap::step(const cam::PathPoint& p) const {
    const double second = std::abs(mm_from_m(p.rho - p.h)), rho = mm_from_m(p.rho);
    return std::min(kWidestStep, std::sqrt(4.0 * tolerance / std::max(second + second * second / rho, 1e-9)));
}

Station Wrap::station(double psi) const {
    const cam::PathPoint p = at(psi);
    const double h = mm_from_m(p.h);
    return {psi, mm_from_m(p.z), -mm_from_m(p.slope), h - half_cable, part.cam.closed() ? h + outline : radius};
}

void Wrap::place_stations() {
    const cam::Cam& cam = part.cam;
    const core::Range turn = cam.groove_psi, working = cam.working_psi;
    // A closed groove starts where no cable runs, and meets itself one turn later.
    const double from = cam.closed() ? 0.5 * (working.low + working.high - kTurn) : turn.low;
    const double to = cam.closed() ? from + kTurn : turn.high;
    for (double psi = from; psi < to;) {
        stations.push_back(station(psi));
        const double trial = step(at(psi));
        psi += std::min(trial, step(at(psi + trial)));
    }
    stations.push_back(station(to));
}

double way_between(const Station& a, const Station& b, double lift_a, double lift_b) {
    const auto place = [](const Station& s, double lift) {
        const double c = std::cos(s.psi), t = std::sin(s.psi), u = s.z + lift, v = -s.y;
        return std::array{u * c - v * t, u * t + v * c, s.x};
    };
    const auto p = place(a, lift_a), q = place(b, lift_b);
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

/// Nose diameter of the groove's cutter [mm].
double nose_diameter(const solid::Part& part) {
    return 2.0 * part.options.groove.radius_ratio * mm_from_m(part.cam.options.cable_diameter);
}

/// Of the arbor's washers [mm].
double washer_radius(const solid::HubOptions& hub) { return 0.5 * mm_from_m(hub.bore_diameter + hub.bore_clearance) + kWasher_mm; }

/// The highest clamp above the rotary axis [mm].
double clamp_radius(const solid::Part& part, const Settings& settings) {
    const double chuck = 0.5 * mm_from_m(settings.chuck_diameter);
    return part.options.hub.boss_height > 0.0 ? chuck : std::max(chuck, washer_radius(part.options.hub));
}

/// Emits the passes: each `depth` below the previous one, never below the floor, and only where material remains.
class Passes {
public:
    Passes(Gcode& code, const Settings& settings, const Wrap& wrap)
        : code_(code),
          wrap_(wrap),
          sign_(settings.rotary_sign),
          depth_(mm_from_m(settings.wrap_depth)),
          feed_(mm_per_min(feed_of(settings, settings.wrap_feed, nose_diameter(wrap.part), settings.wrap_rpm))),
          plunge_(settings.plunge_feed > 0.0 ? mm_per_min(settings.plunge_feed) : feed_ / 3.0),
          clear_(wrap.radius + kClearance_mm),
          safe_(std::max(wrap.radius, clamp_radius(wrap.part, settings)) + mm_from_m(settings.safe_height)) {}

    void cut() {
        double deepest = 0.0;
        for (const Station& s : wrap_.stations) deepest = std::max(deepest, s.top - s.z);
        const int count = std::max(1, static_cast<int>(std::ceil(deepest / depth_ - 1e-9)));
        const double step = wrap_.part.cam.closed() ? deepest / count : depth_;
        for (int pass = 1; pass <= count; ++pass) cut_pass(step * pass, step * (pass - 1));
    }

private:
    /// Height of the tip above the floor in a pass at `depth` below the stock's top.
    static double lift(const Station& s, double depth) { return std::max(0.0, s.top - depth - s.z); }

    void cut_pass(double depth, double before) {
        const auto& all = wrap_.stations;
        const auto left = [&](std::size_t i) { return lift(all[i], before) - lift(all[i], depth) > kLeastDepth_mm; };
        for (std::size_t i = 0; i < all.size();) {
            while (i < all.size() && !left(i)) ++i;
            std::size_t end = i;
            while (end < all.size() && left(end)) ++end;
            // One more station on both sides: the groove ends where the next pass is already at its depth.
            if (i < all.size()) cut_run(i == 0 ? 0 : i - 1, std::min(end, all.size() - 1), depth);
            i = end;
        }
    }

    void cut_run(std::size_t first, std::size_t last, double depth) {
        const auto& all = wrap_.stations;
        const auto at = [&](const Station& s) { return fmt::format("A{:.5f} X{:.5f} Y{:.5f}", degrees(s), s.x, s.y); };
        code_.line("G0 {}", at(all[first]));
        code_.line("G0 Z{:.5f}", clear_);
        code_.line("G1 Z{:.5f} F{:.5f}", all[first].z + lift(all[first], depth), plunge_);
        code_.line("G93");
        for (std::size_t i = first + 1; i <= last; ++i) {
            const double now = lift(all[i], depth), way = way_between(all[i - 1], all[i], lift(all[i - 1], depth), now);
            code_.line("G1 {} Z{:.5f} F{:.5f}", at(all[i]), all[i].z + now, feed_ / way);
        }
        code_.line("G94");
        code_.line("G1 Z{:.5f} F{:.5f}", clear_, feed_);
        code_.line("G0 Z{:.5f}", safe_);
    }

    [[nodiscard]] double degrees(const Station& s) const { return -sign_ * core::deg_from_rad(s.psi); }

    Gcode& code_;
    const Wrap& wrap_;
    int sign_;
    double depth_, feed_, plunge_, clear_, safe_;
};

/// The boss in a chuck, or the bore on an arbor with a nut.
void describe_clamping(Gcode& code, const solid::Part& part, const Settings& settings) {
    const solid::HubOptions& hub = part.options.hub;
    const double boss = mm_from_m(hub.boss_height), low = mm_from_m(part.z_low), high = mm_from_m(part.z_high);
    const double chuck = 0.5 * mm_from_m(settings.chuck_diameter);
    if (boss > 0.0) {
        const double grip = std::min(boss, mm_from_m(settings.chuck_grip));
        code.comment("clamping: the boss in a collet chuck, {:.1f} mm inside", grip);
        code.comment("clamp round {:.5f} {:.5f} {:.5f}", chuck, low - boss - kChuckLength_mm, low - boss + grip);
        return;
    }
    const double washer = washer_radius(hub);
    code.comment("clamping: an arbor through the bore, {:.0f} mm out of the chuck, with washers of {:.2f} mm and a nut", kArbor_mm,
                 2.0 * washer);
    code.comment("clamp round {:.5f} {:.5f} {:.5f}", washer, low - kArbor_mm, low);
    code.comment("clamp round {:.5f} {:.5f} {:.5f}", washer, high, high + kNut_mm);
    code.comment("clamp round {:.5f} {:.5f} {:.5f}", chuck, low - kArbor_mm - kChuckLength_mm, low - kArbor_mm);
}

/// How A0 is found. A pin at the body angle psi stands at Y = -sin(psi + A), Z = cos(psi + A) times its distance: beside the axis a
/// degree moves it most.
void describe_index(Gcode& code, const solid::Part& part, const Settings& settings) {
    if (!part.cam.closed()) {
        code.comment("A0: anywhere, the blank is round; what is cut by hand comes after the groove, from this A0");
        return;
    }
    const auto index = index_of(part, settings);
    if (!index) {
        code.comment("index none");
        code.comment("A0: by the outline, with an indicator: the blank has no place for an index pin");
        return;
    }
    const double psi = core::deg_from_rad(std::atan2(index->at[1], index->at[0])), a = std::remainder(-90.0 - psi, 360.0);
    code.comment("A: turn the index pin {:g} mm to the side of +Y, its top {:.2f} mm above the axis under an indicator; there A is {:.3f}",
                 index->diameter, 0.5 * index->diameter, settings.rotary_sign * a);
    code.comment("index {:.5f} {:.5f} {:.5f} {:.5f}", index->at[0], index->at[1], index->diameter, mm_from_m(part.z_high) - index->depth);
}

void describe(Gcode& code, const solid::Part& part, const Settings& settings, const Wrap& wrap) {
    code.comment("part {}: the groove on a rotary axis", to_string(part.cam.kind));
    code.comment("X: along the cam's axis, towards its upper side, X0 in the groove's plane at body angle 0 or where a helix begins");
    code.comment("Y0 Z0: the cam's axis, Z towards the spindle, measured to the cutter's tip");
    code.comment("A0: body angle 0 looks at the spindle; a positive A turns the part {} about +X",
                 settings.rotary_sign > 0 ? "by the right-hand rule" : "against the right-hand rule");
    code.comment("{}", part.cam.closed() ? "blank: both outlines and the hub, see the blank's program"
                                         : "blank: turned round, with its hub; the groove's sides stand up to its surface");
    code.comment("by hand: {}", left_out(part));
    code.comment("cuts wrap");
    code.comment("cutter ball {:.5f}", nose_diameter(part));
    code.comment("stock round {:.5f} {:.5f} {:.5f}", wrap.radius, mm_from_m(part.z_low), mm_from_m(part.z_high));
    code.comment("rotary {}", settings.rotary_sign);
    describe_index(code, part, settings);
    describe_clamping(code, part, settings);
}

/// Changes to the cutter of the groove's section.
void change_tool(Gcode& code, const solid::Part& part, const Settings& settings, const Wrap& wrap) {
    const double nose = nose_diameter(part), half = core::deg_from_rad(0.5 * part.options.groove.throat);
    const double width = 2.0 * part.section.back().z_mm, slender = wrap.reach + 1.0;
    const auto words =
        fmt::format("groove cutter, nose radius {:.3f} mm, flanks at {:.1f} deg to its axis, {:.3f} mm wide, slender over {:.2f} mm",
                    0.5 * nose, half, width, slender);
    code.tool(1, words, fmt::format("form {:.5f} {:.5f} {:.5f}", nose, half, width), slender, std::max(kShank_mm, width), settings.wrap_rpm,
              settings);
}

}  // namespace

Program wrap_program(const solid::Part& part, const Settings& settings, const std::string& provenance) {
    require_valid(settings);
    const Wrap wrap(part, settings);
    Gcode code(provenance);
    describe(code, part, settings, wrap);
    code.begin(settings);
    change_tool(code, part, settings, wrap);
    Passes(code, settings, wrap).cut();
    code.end();
    return {"",
            code.text(),
            {judge_chip_load(settings, settings.wrap_feed, nose_diameter(part), settings.wrap_rpm, "machining.wrap_feed_mm_per_min",
                             to_string(part.cam.kind))}};
}

}  // namespace fusee::toolpath
