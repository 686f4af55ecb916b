#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/sweep.h"
#include "outlines.h"

namespace fusee::exchange {

namespace {

constexpr double kSpoolMarkFrom = 0.7;  // of the rim, as on the part

/// Offset of the upper flange from the centreline of the cable [mm].
double upper_flange(const solid::Part& part) { return part.section.front().offset_mm + solid::flanges_of(part.options).upper_height_mm; }

/// The pivot of a roller's arm as a cross: a workshop drills the frame by it.
DxfLayer pivot_of(const cam::Roller& roller) {
    constexpr double kHalf_mm = 2.0;
    const auto [x, y] = arm_pivot_mm(roller);
    return {"PIVOT", {}, {}, {}, {}, {{{x - kHalf_mm, y}, {x + kHalf_mm, y}}, {{x, y - kHalf_mm}, {x, y + kHalf_mm}}}};
}

}  // namespace

solid::Point2 arm_pivot_mm(const cam::Roller& roller) {
    const double away = core::mm_from_m(roller.arm.pivot);
    return {away * std::cos(roller.direction), away * std::sin(roller.direction)};
}

DxfDrawing spool_drawing(const solid::Part& part, const std::string& provenance) {
    const double half_cable = core::mm_from_m(0.5 * part.cam.options.cable_diameter);
    const double pitch =
        part.cam.has_roller() ? core::mm_from_m(part.cam.options.roller.radius) : 0.0;  // of the cable or of the roller centre
    const DxfPolyline flange = sampled(part.cam, parallel(upper_flange(part)));
    const solid::Flanges flanges = solid::flanges_of(part.options);
    DxfDrawing drawing;
    drawing.provenance = provenance;
    drawing.layers.push_back({"PITCH", {sampled(part.cam, parallel(pitch))}, {}});
    drawing.layers.push_back({"FLOOR", {sampled(part.cam, parallel(-half_cable))}, {}});
    if (part.cam.closed()) {
        drawing.layers.push_back({"FLANGE", {flange}, {}});
        if (flanges.core_radius_mm > 0.0) {
            const auto lower = [&, offset = part.section.front().offset_mm + flanges.lower_height_mm](const cam::PathPoint& p) {
                return solid::flange_point(p, offset, flanges.core_radius_mm);
            };
            drawing.layers.push_back({"LOWER_FLANGE", {sampled(part.cam, lower)}, {}});
        }
    } else {
        drawing.layers.push_back({"FLANGE", {}, {{{0.0, 0.0}, solid::helix_radius_mm(part)}}});
    }
    drawing.layers.push_back(layer_of("BORE", solid::bore_outline(part.options.hub)));
    for (const solid::Cutter& cutter : solid::make_cutters(part))
        if (!cutter.radial && cutter.name != "mark") drawing.layers.push_back(layer_of(layer_name(cutter.name), cutter.outline));
    drawing.layers.push_back({"PITCH_SPLINE", {}, {}, brep::outline_splines(part, pitch)});
    drawing.layers.push_back({"FLOOR_SPLINE", {}, {}, brep::outline_splines(part, -half_cable)});
    if (part.cam.closed()) drawing.layers.push_back({"FLANGE_SPLINE", {}, {}, brep::outline_splines(part, upper_flange(part))});
    const double sign = solid::mark_angle(part) > 0.0 ? -1.0 : 1.0;
    const double rim = sign * (part.cam.closed() ? solid::crossing_at_zero(flange.points_mm, sign) : solid::helix_radius_mm(part));
    if (part.cam.has_roller() && part.cam.options.roller.follower == cam::FollowerKind::kArm)
        drawing.layers.push_back(pivot_of(part.cam.options.roller));
    drawing.layers.push_back({"MARK", {{{{kSpoolMarkFrom * rim, 0.0}, {rim, 0.0}}, false}}, {}});
    return drawing;
}

void require_kerf(double kerf_mm, const solid::HubOptions& hub) {
    const bool key = hub.lock == solid::HubLock::kKeyway;
    const double bore = hub.bore_diameter + hub.bore_clearance, narrowest = core::mm_from_m(key ? std::min(hub.key_width, bore) : bore);
    if (kerf_mm >= narrowest)
        throw core::InvalidInput("outputs.kerf_mm", fmt::format("{}", kerf_mm),
                                 fmt::format("less than {} mm: the {} would close", narrowest, key ? "keyway" : "bore"));
}

DxfDrawing kerf_drawing(const solid::Part& part, double kerf_mm, const std::string& provenance) {
    require_kerf(kerf_mm, part.options.hub);
    const Curve moved = parallel(upper_flange(part) + 0.5 * kerf_mm);
    return {{{"FLANGE", {sampled(part.cam, moved)}, {}}, layer_of("BORE", solid::bore_outline(narrowed(part.options.hub, kerf_mm)))},
            fmt::format("{}, kerf {} mm", provenance, kerf_mm)};
}

}  // namespace fusee::exchange
