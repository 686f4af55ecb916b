#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "design/parts.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/report/simulation.h"
#include "fusee/solid/outline.h"
#include "page/column.h"

namespace fusee::report {

namespace {

using core::mm_from_m;
using Polyline = std::vector<std::array<double, 2>>;

// Below the top face, less deep than any timing mark, and at no height of mesh vertices.
constexpr double kUnderTop_mm = 0.0137;

std::string outline_text(const Polyline& line) {
    return core::listed(
        line, [](const solid::Point2& p) { return core::coordinate(p[0]) + "," + core::coordinate(p[1]); }, " ");
}

/// The pivot of a follower's arm in the body frame.
std::array<double, 2> pivot_mm(const cam::Cam& cam, const cam::Contact& contact) {
    const double angle = cam.options.roller.direction - cam.rotation_sign * contact.arm.angle,
                 away = mm_from_m(cam.options.roller.arm.pivot);
    return {away * std::cos(angle), away * std::sin(angle)};
}

/// The cable from its contact outwards, or the roller there. The torque of the tension about +z has the sign torque_sign.
Json end_json(const cam::Cam& cam, const cam::Contact& contact) {
    const double x = mm_from_m(contact.path.x()), y = mm_from_m(contact.path.y()), psi = contact.path.psi;
    Json end{{"load_Nm", contact.arm.tau}, {"contact_mm", {x, y}}};
    if (cam.has_roller()) {
        const double radius = mm_from_m(cam.options.roller.radius);
        end["radius_mm"] = radius;
        end["centre_mm"] = {x + radius * std::cos(psi), y + radius * std::sin(psi)};
        if (cam.options.roller.follower == cam::FollowerKind::kArm) end["pivot_mm"] = pivot_mm(cam, contact);
    } else {
        end["direction"] = {-std::sin(psi) * cam.options.torque_sign, std::cos(psi) * cam.options.torque_sign};
    }
    return end;
}

void widen(core::Range& range, double value) {
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
}

}  // namespace

Json spring_curves_json(const std::vector<spring::LawPoint>& samples) {
    using P = spring::LawPoint;
    return {{"tau_Nm", column(samples, &P::tau)},   {"theta_rad", column(samples, &P::theta)}, {"f_se_Nm", column(samples, &P::f_se)},
            {"f_pe_Nm", column(samples, &P::f_pe)}, {"s_Nm_per_rad", column(samples, &P::s)},  {"p_Nm_per_rad", column(samples, &P::p)}};
}

Json drawing_json(const solid::Part& part) {
    const cam::Cam& cam = part.cam;
    const double boss_mm = mm_from_m(part.options.hub.boss_height), d = cam.options.cable_diameter;
    const std::vector<Polyline> body = solid::slice(part.mesh, mm_from_m(part.z_high) - kUnderTop_mm);
    const auto boss = boss_mm > 0.0 ? solid::slice(part.mesh, mm_from_m(part.z_low) - 0.487 * boss_mm) : std::vector<Polyline>{};
    // All that the sheet has to hold: a roller stands outside the rim.
    Polyline around = cam.has_roller() ? solid::parallel(cam, cam.working_psi, 2.0 * cam.options.roller.radius) : Polyline{};
    if (cam.has_roller() && cam.options.roller.follower == cam::FollowerKind::kArm)
        for (const cam::Contact* end : {&cam.working.front(), &cam.working.back()}) around.push_back(pivot_mm(cam, *end));
    return {{"part", cam::to_string(cam.kind)},
            {"closed", cam.closed()},
            {"body", json_list(body, outline_text)},
            {"boss", json_list(boss, outline_text)},
            {"floor", outline_text(solid::parallel(cam, cam.groove_psi, -0.5 * d))},
            {"pitch", outline_text(solid::parallel(cam, cam.groove_psi, 0.0))},
            {"working", outline_text(solid::parallel(cam, cam.working_psi, 0.0))},
            {"around", outline_text(around)},
            {"ends", {end_json(cam, cam.working.front()), end_json(cam, cam.working.back())}}};
}

CamFigures measure(const cam::Cam& cam) {
    assert(!cam.working.empty());
    const cam::Contact& first = cam.working.front();
    const double arm_mm = core::mm_from_m(first.arm.arm);
    CamFigures f{cam.working.back().arm.angle - first.arm.angle,
                 {arm_mm, arm_mm},
                 {first.arm.tension, first.arm.tension},
                 {first.arm.state, first.arm.state},
                 core::mm_from_m(first.path.rho)};
    for (const cam::Contact& contact : cam.working) {
        widen(f.arms_mm, core::mm_from_m(contact.arm.arm));
        widen(f.tensions, contact.arm.tension);
        widen(f.states, contact.arm.state);
        f.least_rho_mm = std::min(f.least_rho_mm, core::mm_from_m(contact.path.rho));
    }
    return f;
}

std::string stretch_text(const cam::ArmPoint& at) {
    return fmt::format("{:.3g} mm at {:.3g} N: {:.3g} of the capstan's {:.3g} deg, {:.2g} %", core::mm_from_m(at.elongation.length),
                       at.tension, core::deg_from_rad(at.elongation.turn), core::deg_from_rad(at.elongation.travel),
                       100.0 * at.elongation.share());
}

std::string stretch_remark(const Simulation& s) {
    std::string text = "Cable elongation at the law's largest load, which both cams compensate: ";
    for (const StretchSide& side : s.stretches)
        text += fmt::format("{}{} by {}", &side == &s.stretches.front() ? "" : "; ", cam::to_string(side.part), stretch_text(side.at));
    return text + ".";
}

}  // namespace fusee::report
