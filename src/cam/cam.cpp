#include "fusee/cam/cam.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "enclosure.h"
#include "fusee/cam/certificate.h"
#include "fusee/cam/contact.h"
#include "fusee/cam/mirror.h"
#include "fusee/core/error.h"
#include "idle_arc.h"
#include "path.h"
#include "refusal.h"
#include "scan.h"

/// A cam's path in pieces with computable bounds, by the same formulas as its points.
namespace fusee::cam {

namespace {

using math::Interval;
using math::Jet;

/// rho between two knots of an arc that starts at `begin_psi` in `direction`, as a function of psi.
Jet rho_between(const IdleArc::Knot& from, const IdleArc::Knot& to, const Jet& psi, double begin_psi, int direction) {
    const Jet gone = static_cast<double>(direction) * (psi - begin_psi) - from.x;
    const Interval rate = (Interval(to.state.rho) - from.state.rho) / (Interval(to.x) - from.x);
    return from.state.rho + Jet(rate, Interval(0.0)) * gone;
}

/// One piece for each pair of knots, by psi. @param finish adds the arc's height
template <class Finish>
std::vector<ContourPiece> by_psi(const IdleArc& arc, double begin_psi, int direction, const Finish& finish) {
    std::vector<ContourPiece> result;
    const auto& knots = arc.knots();
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const IdleArc::Knot from = knots[i - 1], to = knots[i];
        const double a = begin_psi + direction * from.x, b = begin_psi + direction * to.x;
        result.push_back({{std::min(a, b), std::max(a, b)}, false, [=](const Interval& box) {
                              ContourJet at;
                              at.psi = Jet::parameter(box);
                              at.rho = rho_between(from, to, at.psi, begin_psi, direction);
                              finish(at);
                              return at;
                          }});
    }
    return result;
}

/// The working arc; empty if the law has no bounds.
std::vector<ContourPiece> working_pieces(const ArmFunction& arm, const CamOptions& options, const Height& height) {
    std::vector<ContourPiece> result;
    const auto heights = std::make_shared<const Height>(height);
    for (const spring::LawSegment& law : spring::segments(arm.law()))
        result.push_back(
            {law.parameter, true, [arm, options, heights, law](const Interval& box) {
                 const ContactJet contact = touch(arm.kind(), arm.over(law.over(box)), options);
                 const Height::AxialSlope axial_slope = heights->over(contact.path.psi.value);
                 return ContourJet{contact.path.psi, contact.path.rho, contact.arm.angle, axial_slope.first, axial_slope.second};
             }});
    return result;
}

/// A planar contour's idle arc, from the working arc's high end on.
std::vector<ContourPiece> idle_pieces(const IdleArc& arc, double begin_psi) {
    return by_psi(arc, begin_psi, +1, [](ContourJet&) {});
}

/// A helix beyond one end of its working arc.
std::vector<ContourPiece> run_out_pieces(const RunOut& run_out) {
    return by_psi(run_out.arc(), run_out.end().psi, run_out.direction(), [run_out](ContourJet& at) {
        const Height::AxialSlope axial_slope = run_out.over(at.rho);
        at.axial_slope = axial_slope.first;
        at.axial_slope_rate = axial_slope.second;
    });
}

constexpr std::size_t kScan = 801;     // loads at which contacts are checked and bracketed
constexpr double kIdleDistance = 0.9;  // of the least arm: the idle arc leaves nearly as much space for a bore as the working arc

void validate(const ArmFunction& arm, const CamOptions& o) {
    const std::string part = to_string(arm.kind());
    if (o.torque_sign != 1 && o.torque_sign != -1)
        throw core::InvalidInput(part + ".torque_sign", fmt::format("{}", o.torque_sign), "1 or -1");
    core::require_within(part + ".target_rows", o.target_rows, 200, 10000);
    if (o.family == Family::kRoller)
        validate_roller(arm, o);
    else
        core::require_positive("cable.diameter_mm", core::mm_from_m(o.cable_diameter), "mm");
    core::require_within(part + ".path.margin_deg", core::deg_from_rad(o.path.margin), 2.8, 172.0, "deg");
    if (o.guide.kind != GuideKind::kParallel) core::require_positive(part + ".guide.distance_mm", core::mm_from_m(o.guide.distance), "mm");
    if (o.guide.kind == GuideKind::kIdler) core::require_positive(part + ".guide.radius_mm", core::mm_from_m(o.guide.radius), "mm");
    if (o.path.kind == PathKind::kPlanar) return;
    if (o.path.lead == Lead::kConstantPitch) core::require_positive(part + ".path.pitch_mm", core::mm_from_m(o.path.pitch), "mm");
    if (o.path.lead == Lead::kAimedAtGuide && o.guide.kind == GuideKind::kParallel)
        throw core::InvalidInput(part + ".path.lead", "aimed", "constant_pitch with a parallel guide, which has no point to aim at");
    if (o.path.lead == Lead::kAimedAtGuide && o.path.hand == Hand::kLeft)
        throw core::InvalidInput(part + ".path.hand", "left", "right with lead aimed: the groove leads to its guide, up or down");
}

/// The contacts of a cam with these arms, or their first error.
core::Outcome<std::vector<Contact>> sound_contacts(const ArmFunction& arm, const CamOptions& options) {
    std::vector<Contact> contacts = scan_contacts(arm, options, kScan);
    if (core::Findings findings = check_contacts(arm, options, contacts); !findings.empty()) return findings;
    return contacts;
}

/// Working positions evenly spaced in cam angle: needed arms and contacts. @param flat the arms in the plane
std::vector<Contact> working_rows(const ArmFunction& asked, const ArmFunction& flat, const CamOptions& options,
                                  const std::vector<Contact>& scanned, const Height& height) {
    std::vector<Contact> rows;
    const double last = scanned.back().arm.angle;
    for (int i = 0; i < options.target_rows; ++i) {
        Contact row = contact_at(flat, options, scanned, last * i / (options.target_rows - 1));
        row.arm = asked.at_load(row.arm.tau);
        row.path.z = height.at(row.path.psi);
        row.fleet = fleet_of(row, options.guide);
        rows.push_back(row);
    }
    return rows;
}

SupportState state_of(const PathPoint& p) { return {p.h, p.slope, p.rho}; }

/// Adds the part's name to findings of an idle arc.
core::Findings named(core::Findings findings, PartKind kind) {
    for (core::Finding& f : findings) {
        f.where = fmt::format("{}: {}", to_string(kind), f.where);
        f.suggestion = f.suggestion.of_table(to_string(kind));
    }
    return findings;
}

/// The arc that closes a planar contour.
core::Outcome<IdleArc> idle_arc(const ArmFunction& arm, const WorkingArc& arc, const CamOptions& options, double least_h) {
    const core::Range psi = arc.psi();
    auto idle = IdleArc::close(state_of(arc.at(psi.high)), state_of(arc.at(psi.low)), core::kTurn - psi.width(),
                               {options.path.min_idle_curvature_radius, kIdleDistance * least_h});
    if (idle) return idle;
    core::Findings findings = named(idle.refusal(), arm.kind());
    if (options.family != Family::kRoller) return findings;
    findings.front().suggestion = wider_base(arm, options);
    if (findings.front().suggestion.empty()) findings.front().suggestion = "a lower law.end_torque_Nm: no base radius closes this rim";
    return findings;
}

/// Planar: the working arc and the idle arc that closes it.
std::function<PathPoint(double)> closed_path(const std::shared_ptr<const WorkingArc>& arc, const IdleArc& closing) {
    return [arc, psi = arc->psi(), closing](double angle) -> PathPoint {
        const double inside = core::within_turn(angle, psi.low);
        PathPoint point;
        if (inside <= psi.high) {
            point = arc->at(inside);
        } else {
            const SupportState s = closing.at(inside - psi.high);
            point = {angle, s.h, s.slope, s.rho, 0.0};
        }
        point.psi = angle;
        return point;
    };
}

/// The working arc, the margin to the anchor and some groove beyond it. Never close to whole turns: start and end of the groove would form
/// slivers.
core::Range open_groove(const core::Range& working, double margin) {
    constexpr double kBeyondAnchor = 1.6, kApart = 0.05;
    core::Range groove{working.low - kBeyondAnchor * margin, working.high + kBeyondAnchor * margin};
    const double from_whole = std::remainder(groove.width(), core::kTurn);
    if (std::abs(from_whole) < kApart) groove.high += kApart - from_whole;
    return groove;
}

std::vector<ContourPiece> joined(std::vector<ContourPiece> working, const std::vector<std::vector<ContourPiece>>& others) {
    for (const auto& other : others) working.insert(working.end(), other.begin(), other.end());
    return working;
}

/// Helix: the working arc and a run-out at both ends of the groove.
void make_open(Cam& cam, const ArmFunction& arm, const std::shared_ptr<const WorkingArc>& arc, const Height& height) {
    const core::Range psi = arc->psi(), groove = cam.groove_psi;
    const Lead lead = cam.options.path.lead;
    const auto working = [arc, height](double angle) {
        PathPoint point = arc->at(angle);
        point.z = height.at(angle);
        return point;
    };
    const RunOut below(working(psi.low), -1, psi.low - groove.low, height.slope_at(false), lead);
    const RunOut above(working(psi.high), +1, groove.high - psi.high, height.slope_at(true), lead);
    cam.path = [working, psi, below, above](double angle) {
        return angle < psi.low ? below.at(angle) : angle > psi.high ? above.at(angle) : working(angle);
    };
    cam.pieces = [arm, options = cam.options, height, below, above] {
        return joined(working_pieces(arm, options, height), {run_out_pieces(below), run_out_pieces(above)});
    };
}

/// Planar: the working arc and the idle arc that closes it. Refusal: no idle arc closes it.
core::Outcome<Cam> closed(Cam cam, const ArmFunction& arm, const std::shared_ptr<const WorkingArc>& arc, const Height& height,
                          const std::vector<Contact>& scanned) {
    const auto least =
        std::min_element(scanned.begin(), scanned.end(), [](const Contact& a, const Contact& b) { return a.path.h < b.path.h; });
    const auto idle = idle_arc(arm, *arc, cam.options, least->path.h);
    if (!idle) return idle.refusal();
    cam.path = closed_path(arc, *idle);
    cam.pieces = [arm, options = cam.options, height, closing = *idle, begin = cam.working_psi.high] {
        return joined(working_pieces(arm, options, height), {idle_pieces(closing, begin)});
    };
    cam.groove_psi = {cam.working_psi.low, cam.working_psi.low + core::kTurn};
    return cam;
}

constexpr double kStep_deg = 5.0, kMost_deg = 170.0;  // largest margin of a profile

}  // namespace

double PathPoint::x() const { return h * std::cos(psi) - slope * std::sin(psi); }
double PathPoint::y() const { return h * std::sin(psi) + slope * std::cos(psi); }

core::Outcome<Cam> synthesize_cam(const ArmFunction& asked, const CamOptions& options) {
    validate(asked, options);
    if (options.path.kind == PathKind::kHelix && options.path.hand == Hand::kLeft) {  // every formula rises with psi
        const auto right = synthesize_cam(asked, mirrored(options));
        return right ? core::Outcome<Cam>(mirrored(*right)) : right;
    }
    const auto upright = sound_contacts(asked, options);
    if (!upright) return upright.refusal();
    const std::optional<ArmFunction> flat = in_plane(asked, options, *upright);
    const auto corrected = flat ? sound_contacts(*flat, options) : upright;
    if (!corrected) return corrected.refusal();
    const ArmFunction& arm = flat ? *flat : asked;
    const std::vector<Contact>& scanned = *corrected;
    const auto arc = std::make_shared<const WorkingArc>(arm, options, scanned);
    const Height height(options, scanned);
    Cam cam;
    cam.kind = arm.kind();
    cam.options = options;
    cam.rotation_sign = rotation_sign(arm.kind(), options.torque_sign);
    cam.working_psi = arc->psi();
    if (core::Findings findings = check_wrap(arm, cam, scanned.back().arm.angle); !findings.empty()) return findings;
    cam.working = working_rows(asked, arm, options, scanned, height);
    cam.anchor_psi = anchor_direction(cam, options.path.margin);
    if (!cam.closed()) {
        cam.groove_psi = open_groove(cam.working_psi, options.path.margin);
        make_open(cam, arm, arc, height);
        return cam;
    }
    return closed(std::move(cam), arm, arc, height, scanned);
}

double anchor_direction(const Cam& cam, double margin) {
    const double wound = cam.options.torque_sign > 0 ? cam.working_psi.low : cam.working_psi.high;
    const double psi = wound - cam.options.torque_sign * margin;
    return cam.closed() && psi < cam.working_psi.low ? psi + core::kTurn : psi;
}

std::vector<double> margins_by_distance(const Cam& cam) {
    const double own = core::deg_from_rad(cam.options.path.margin);
    std::vector<double> all{cam.options.path.margin};
    for (double step = kStep_deg; step < kMost_deg; step += kStep_deg)
        for (const double margin : {own + step, own - step})
            if (margin >= kStep_deg && margin <= kMost_deg) all.push_back(core::rad_from_deg(margin));
    return all;
}

Cam with_margin(Cam cam, double margin) {
    cam.options.path.margin = margin;
    cam.anchor_psi = anchor_direction(cam, margin);
    return cam;
}

}  // namespace fusee::cam
