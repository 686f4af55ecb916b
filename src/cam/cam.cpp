#include "fusee/cam/cam.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "fusee/cam/contact.h"
#include "fusee/cam/idle_arc.h"
#include "fusee/cam/path.h"
#include "fusee/core/error.h"
#include "solve.h"

namespace fusee::cam {

namespace {

constexpr std::size_t kScan = 801;          // loads at which contacts are checked and bracketed
constexpr double kLeastIdleArc = 0.2;       // [rad] of normals that a planar contour needs to close
constexpr double kIdleDistance = 0.9;       // of the least arm: the idle arc leaves a bore nearly as much room as the working arc does

void validate(const ArmFunction& arm, const CamOptions& o) {
    const std::string part = to_string(arm.kind());
    if (o.torque_sign != 1 && o.torque_sign != -1) throw core::InvalidInput(part + ".torque_sign", fmt::format("{}", o.torque_sign), "1 or -1");
    core::require_within(part + ".target_rows", o.target_rows, 200, 100000);
    core::require_positive("cable.diameter", o.cable_diameter, "m");
    core::require_within(part + ".path.margin", o.path.margin, 0.05, 3.0, "rad");
    if (o.guide.kind != GuideKind::kParallel) core::require_positive(part + ".guide.distance", o.guide.distance, "m");
    if (o.guide.kind == GuideKind::kIdler) core::require_positive(part + ".guide.radius", o.guide.radius, "m");
    if (o.path.kind == PathKind::kPlanar) return;
    if (o.path.lead == Lead::kConstantPitch) core::require_positive(part + ".path.pitch", o.path.pitch, "m");
    if (o.path.lead == Lead::kAimedAtGuide && o.guide.kind == GuideKind::kParallel)
        throw core::InvalidInput(part + ".path.lead", "aimed", "constant_pitch with a parallel guide: there is no point to aim at");
}

core::Finding broken(const ArmFunction& arm, const char* rule, const char* what, const Contact& at, double measured_mm, std::string suggestion) {
    core::Finding f;
    f.rule = rule;
    f.severity = core::Severity::kRequired;
    f.what = what;
    f.measured = measured_mm;
    f.allowed = 0.0;
    f.unit = "mm";
    f.where = fmt::format("{} at {:.4g} Nm, cam angle {:.1f} deg", to_string(arm.kind()), at.arm.tau, core::deg_from_rad(at.arm.angle));
    f.suggestion = std::move(suggestion);
    f.source = "cable kinematics: the envelope of the cable's lines exists and is convex";
    return f;
}

/// The loads on the other side of the first and last break, as the nearest feasible change.
std::string feasible_range(const std::vector<Contact>& contacts, const std::vector<bool>& good) {
    const auto first_bad = std::find(good.begin(), good.end(), false);
    if (first_bad != good.begin())
        return fmt::format("law.end_torque_Nm = {:.4g}, or a base spring that keeps the arm's bend smaller",
                           contacts[static_cast<std::size_t>(first_bad - good.begin()) - 1].arm.tau);
    const auto first_good = std::find(good.begin(), good.end(), true);
    if (first_good == good.end()) return "another base spring (rate, preload): no load of the law can be had";
    return fmt::format("law.start_torque_Nm = {:.4g}, or a larger preload", contacts[static_cast<std::size_t>(first_good - good.begin())].arm.tau);
}

core::Findings check_contacts(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts) {
    core::Findings findings;
    std::vector<bool> reached, convex;
    const Contact *nearest = &contacts.front(), *sharpest = &contacts.front();
    for (const Contact& c : contacts) {
        const double reach = guide_reach(arm.kind(), c.arm, options);
        if (!(reach >= guide_reach(arm.kind(), nearest->arm, options))) nearest = &c;
        if (!(c.path.rho >= sharpest->path.rho)) sharpest = &c;
        reached.push_back(reach > 0.0);
        convex.push_back(c.path.rho > 0.0);
    }
    const double least_reach = guide_reach(arm.kind(), nearest->arm, options);
    if (!(least_reach > 0.0))
        findings.push_back(broken(arm, "cam.guide", "the guide is too near: no straight cable from cam to guide has the arm asked for", *nearest,
                                  core::mm_from_m(least_reach),
                                  fmt::format("{}.guide.distance_mm = {:.1f}", to_string(arm.kind()),
                                              core::mm_from_m(options.guide.distance) + 1.1 * std::abs(core::mm_from_m(least_reach)))));
    else if (!(sharpest->path.rho > 0.0))
        findings.push_back(broken(arm, "cam.convexity", "no convex contour has this arm: its radius of curvature would not be positive", *sharpest,
                                  core::mm_from_m(sharpest->path.rho), feasible_range(contacts, convex)));
    return findings;
}

std::vector<Contact> scan(const ArmFunction& arm, const CamOptions& options) {
    std::vector<Contact> contacts;
    const core::Range loads = arm.law().loads();
    for (std::size_t i = 0; i < kScan; ++i)
        contacts.push_back(touch(arm.kind(), arm.at_load(loads.low + loads.width() * static_cast<double>(i) / (kScan - 1)), options));
    return contacts;
}

/// Working positions evenly spaced in cam angle.
std::vector<Contact> working_rows(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& scanned, const Height& height) {
    std::vector<Contact> rows;
    const double last = scanned.back().arm.angle;
    for (int i = 0; i < options.target_rows; ++i) {
        const double angle = last * i / (options.target_rows - 1);
        const auto after = std::upper_bound(scanned.begin() + 1, scanned.end() - 1, angle, [](double v, const Contact& c) { return v < c.arm.angle; });
        const double tau = solve_between([&](double t) { return arm.at_load(t).angle - angle; }, (after - 1)->arm.tau, after->arm.tau);
        Contact row = touch(arm.kind(), arm.at_load(tau), options);
        row.path.z = height.at(row.path.psi);
        if (options.guide.kind != GuideKind::kParallel) row.fleet = std::atan2(options.guide.z - row.path.z, row.span);
        rows.push_back(row);
    }
    return rows;
}

SupportState state_of(const PathPoint& p) { return {p.h, p.slope, p.rho}; }

core::Finding too_much_wrap(const ArmFunction& arm, double wrap, double allowed) {
    core::Finding f;
    f.rule = "cam.wrap";
    f.severity = core::Severity::kRequired;
    f.what = "a planar groove cannot hold this wrap: it would run over itself";
    f.measured = core::deg_from_rad(wrap);
    f.bound = core::Bound::kAtMost;
    f.allowed = core::deg_from_rad(allowed);
    f.unit = "deg";
    f.where = to_string(arm.kind());
    f.suggestion = fmt::format("{}.path.kind = \"helix\"", to_string(arm.kind()));
    f.source = "geometry: one turn less the idle arc";
    return f;
}

/// Planar: the working arc and the idle arc that closes it.
core::Outcome<std::function<PathPoint(double)>> closed_path(std::shared_ptr<const WorkingArc> arc, const CamOptions& options, double least_arm) {
    const core::Range psi = arc->psi();
    const auto idle = IdleArc::close(state_of(arc->at(psi.high)), state_of(arc->at(psi.low)), 2.0 * core::kPi - psi.width(),
                                     {options.path.min_idle_curvature_radius, kIdleDistance * least_arm});
    if (!idle) return idle.refusal();
    return std::function<PathPoint(double)>([arc, psi, closing = *idle](double angle) -> PathPoint {
        const double turn = 2.0 * core::kPi;
        const double inside = angle - turn * std::floor((angle - psi.low) / turn);
        PathPoint point;
        if (inside <= psi.high) {
            point = arc->at(inside);
        } else {
            const SupportState s = closing.at(inside - psi.high);
            point = {angle, s.h, s.slope, s.rho, 0.0};
        }
        point.psi = angle;
        return point;
    });
}

/// The working arc, the margin to the anchor and some groove beyond it. Never close to whole turns: begin and end of the groove would make slivers.
core::Range open_groove(const core::Range& working, double margin) {
    constexpr double kBeyondAnchor = 1.6, kTurn = 2.0 * core::kPi, kApart = 0.05;
    core::Range groove{working.low - kBeyondAnchor * margin, working.high + kBeyondAnchor * margin};
    const double from_whole = std::remainder(groove.width(), kTurn);
    if (std::abs(from_whole) < kApart) groove.high += kApart - from_whole;
    return groove;
}

/// Helix: the working arc and a run-out at both ends of the groove.
std::function<PathPoint(double)> open_path(std::shared_ptr<const WorkingArc> arc, const Height& height, const core::Range& groove) {
    const core::Range psi = arc->psi();
    const RunOut below(arc->at(psi.low), -1, psi.low - groove.low), above(arc->at(psi.high), +1, groove.high - psi.high);
    return [arc, psi, below, above, height](double angle) {
        PathPoint point = angle < psi.low ? below.at(angle) : angle > psi.high ? above.at(angle) : arc->at(angle);
        point.z = height.at(angle);
        return point;
    };
}

}  // namespace

double PathPoint::x() const { return h * std::cos(psi) - slope * std::sin(psi); }
double PathPoint::y() const { return h * std::sin(psi) + slope * std::cos(psi); }

core::Outcome<Cam> synthesize_cam(const ArmFunction& arm, const CamOptions& options) {
    validate(arm, options);
    const std::vector<Contact> scanned = scan(arm, options);
    if (core::Findings findings = check_contacts(arm, options, scanned); !findings.empty()) return findings;
    const auto arc = std::make_shared<const WorkingArc>(arm, options, scanned);
    const Height height(options, scanned);
    Cam cam;
    cam.kind = arm.kind();
    cam.options = options;
    cam.rotation_sign = rotation_sign(arm.kind(), options.torque_sign);
    cam.working_psi = arc->psi();
    cam.working = working_rows(arm, options, scanned, height);
    const double margin = options.path.margin, wound = options.torque_sign > 0 ? cam.working_psi.low : cam.working_psi.high;
    cam.anchor_psi = wound - options.torque_sign * margin;
    if (!cam.closed()) {
        cam.groove_psi = open_groove(cam.working_psi, margin);
        cam.path = open_path(arc, height, cam.groove_psi);
        return cam;
    }
    const double room = 2.0 * core::kPi - kLeastIdleArc;
    if (cam.working_psi.width() > room) return too_much_wrap(arm, cam.working_psi.width(), room);
    const auto least = std::min_element(scanned.begin(), scanned.end(), [](const Contact& a, const Contact& b) { return a.arm.arm < b.arm.arm; });
    auto path = closed_path(arc, options, least->arm.arm);
    if (!path) return path.refusal();
    cam.path = *path;
    cam.groove_psi = {cam.working_psi.low, cam.working_psi.low + 2.0 * core::kPi};
    if (cam.anchor_psi < cam.groove_psi.low) cam.anchor_psi += 2.0 * core::kPi;
    return cam;
}

}  // namespace fusee::cam
