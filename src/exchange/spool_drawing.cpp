#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "flanges.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/solid/outline.h"

namespace fusee::exchange {

namespace {

constexpr double kChord = kDrawingChord_mm;
constexpr double kMarkFrom = 0.7;  // of the rim, as the part's own mark
constexpr double kLargest = 0.05;  // step where the outline is nearly straight in psi [rad]

using Outline = std::function<solid::OutlinePoint(const cam::PathPoint&)>;

/// The curve's points over the groove, the step following its own curvature: sagitta = rho dpsi^2 / 8.
DxfPolyline sampled(const cam::Cam& cam, const Outline& outline) {
    DxfPolyline line;
    line.closed = cam.closed();
    const core::Range range = cam.groove_psi;
    for (double psi = range.low; psi < range.high - 1e-9;) {
        const solid::OutlinePoint here = outline(cam.path(psi));
        line.points_mm.push_back(here.point);
        const double trial = std::min(psi + kLargest, range.high);
        const double rho = std::max(std::abs(here.rho), std::abs(outline(cam.path(trial)).rho));
        psi += std::min(kLargest, std::sqrt(8.0 * kChord / std::max(rho, 1e-3)));
    }
    if (!line.closed) line.points_mm.push_back(outline(cam.path(range.high)).point);
    return line;
}

/// The pitch curve's parallel at a distance along its normal [mm].
Outline parallel(double offset_mm) {
    return [offset_mm](const cam::PathPoint& p) { return solid::flange_point(p, offset_mm, 0.0); };
}

/// Where the ray at body angle 0 leaves the outline: the crossing farthest out.
double crossing_at_zero(const DxfPolyline& line) {
    double far = 0.0;
    const std::size_t n = line.points_mm.size();
    for (std::size_t i = line.closed ? 0 : 1; i < n; ++i) {
        const Vec2 &a = line.points_mm[(i + n - 1) % n], &b = line.points_mm[i];
        if ((a[1] < 0.0) == (b[1] < 0.0)) continue;
        far = std::max(far, a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]));
    }
    return far;
}

DxfLayer bore_layer(const solid::HubOptions& hub) {
    if (hub.lock == solid::HubLock::kKeyway || hub.lock == solid::HubLock::kDFlat)
        return {"BORE", {{solid::ring_of(solid::bore_outline(hub), kChord), true}}, {}};
    return {"BORE", {}, {{{0.0, 0.0}, core::mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance))}}};
}

}  // namespace

DxfDrawing spool_drawing(const solid::Part& part, const std::string& provenance) {
    const double half_cable = core::mm_from_m(0.5 * part.cam.options.cable_diameter);
    const FlangeReach reach = flange_reach(part);
    const DxfPolyline flange = sampled(part.cam, parallel(reach.lip + reach.upper));
    DxfDrawing drawing;
    drawing.provenance = provenance;
    drawing.layers.push_back({"PITCH", {sampled(part.cam, parallel(0.0))}, {}});
    drawing.layers.push_back({"FLOOR", {sampled(part.cam, parallel(-half_cable))}, {}});
    if (part.cam.closed()) {
        drawing.layers.push_back({"FLANGE", {flange}, {}});
        if (reach.core_radius > 0.0) {
            const auto lower = [&](const cam::PathPoint& p) { return solid::flange_point(p, reach.lip + reach.lower, reach.core_radius); };
            drawing.layers.push_back({"LOWER_FLANGE", {sampled(part.cam, lower)}, {}});
        }
    } else {
        drawing.layers.push_back({"FLANGE", {}, {{{0.0, 0.0}, helix_radius_mm(part)}}});
    }
    drawing.layers.push_back(bore_layer(part.options.hub));
    drawing.layers.push_back({"PITCH_SPLINE", {}, {}, brep::outline_splines(part, 0.0)});
    drawing.layers.push_back({"FLOOR_SPLINE", {}, {}, brep::outline_splines(part, -half_cable)});
    if (part.cam.closed()) drawing.layers.push_back({"FLANGE_SPLINE", {}, {}, brep::outline_splines(part, reach.lip + reach.upper)});
    const double rim = part.cam.closed() ? crossing_at_zero(flange) : helix_radius_mm(part);
    drawing.layers.push_back({"MARK", {{{{kMarkFrom * rim, 0.0}, {rim, 0.0}}, false}}, {}});
    return drawing;
}

DxfDrawing kerf_drawing(const solid::Part& part, double kerf_mm, const std::string& provenance) {
    solid::HubOptions hub = part.options.hub;
    // Every side of the bore moves inwards by half the kerf: a key's depth and a flat's, from the bore's radius, stay as they are.
    hub.bore_clearance -= core::m_from_mm(kerf_mm);
    hub.key_width -= core::m_from_mm(kerf_mm);
    const double least = hub.lock == solid::HubLock::kKeyway ? hub.key_width : hub.bore_diameter + hub.bore_clearance;
    if (!(least > 0.0)) throw core::InvalidInput("outputs.kerf_mm", fmt::format("{}", kerf_mm), "less than the bore and its key are wide");
    const FlangeReach reach = flange_reach(part);
    const Outline moved = parallel(reach.lip + reach.upper + 0.5 * kerf_mm);
    return {{{"FLANGE", {sampled(part.cam, moved)}, {}}, bore_layer(hub)}, fmt::format("{}, kerf {} mm", provenance, kerf_mm)};
}

}  // namespace fusee::exchange
