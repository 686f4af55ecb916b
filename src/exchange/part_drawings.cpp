#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/stack.h"
#include "fusee/solid/sweep.h"
#include "outlines.h"

namespace fusee::exchange {

namespace {

/// Offset of the upper flange from the centreline of the cable [mm].
double upper_flange(const solid::Part& part) { return part.section.front().offset_mm + solid::flanges_of(part.options).upper_height_mm; }

/// The pivot of a roller's arm as a cross: a workshop drills the frame by it.
DxfLayer pivot_of(const cam::Roller& roller) {
    constexpr double kHalf_mm = 2.0;
    const auto [x, y] = arm_pivot_mm(roller);
    return {"PIVOT", {}, {}, {}, {}, {{{x - kHalf_mm, y}, {x + kHalf_mm, y}}, {{x, y - kHalf_mm}, {x, y + kHalf_mm}}}};
}

constexpr double kMarkFrom = 0.7, kTickFrom = 0.85;  // of the rim: the timing mark, as on the part, and the other ticks
constexpr double kTicksApart_mm = 0.8;

bool is_core(const solid::Plate& plate) { return plate.offset_mm < 0.0; }

/// Layers are found by name: all dowels are on one layer.
void add_layer(DxfDrawing& drawing, DxfLayer layer) {
    for (DxfLayer& there : drawing.layers)
        if (there.name == layer.name) {
            there.polylines.insert(there.polylines.end(), layer.polylines.begin(), layer.polylines.end());
            there.circles.insert(there.circles.end(), layer.circles.begin(), layer.circles.end());
            there.arcs.insert(there.arcs.end(), layer.arcs.begin(), layer.arcs.end());
            there.lines.insert(there.lines.end(), layer.lines.begin(), layer.lines.end());
            return;
        }
    drawing.layers.push_back(std::move(layer));
}

/// Draws as many ticks as the number of the plate; the first one is the timing mark.
/// @param rim_mm along +x, below 0: along -x
DxfLayer ticks(std::size_t number, double rim_mm) {
    DxfLayer mark{"MARK", {}, {}};
    for (std::size_t i = 0; i < number; ++i) {
        const double y = kTicksApart_mm * static_cast<double>(i);
        mark.polylines.push_back({{{(i == 0 ? kMarkFrom : kTickFrom) * rim_mm, y}, {0.95 * rim_mm, y}}, false});
    }
    return mark;
}

/// The openings of one plate; bore and keyway are narrowed as in the hub.
void add_openings(DxfDrawing& drawing, const solid::Part& part, const solid::Plate& plate, double kerf_mm) {
    for (const solid::Opening& opening : plate.openings) {
        const bool bore = opening.name == "bore";
        const auto outline =
            bore ? std::optional(solid::bore_outline(narrowed(part.options.hub, kerf_mm))) : solid::inset(opening.outline, 0.5 * kerf_mm);
        if (!outline)
            throw core::InvalidInput("outputs.kerf_mm", fmt::format("{}", kerf_mm),
                                     "less than the width of every opening: the " + opening.name + " would close");
        add_layer(drawing, layer_of(layer_name(opening.name), *outline));
    }
}

std::vector<DxfDrawing> drawings(const solid::Part& part, double kerf_mm, const std::string& provenance) {
    const std::vector<solid::Plate> plates = solid::stack_plates(part);
    const double sign = solid::mark_angle(part) > 0.0 ? -1.0 : 1.0;
    std::vector<DxfDrawing> all;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        const solid::Plate& plate = plates[i];
        const std::string outline = is_core(plate) ? "FLOOR" : "FLANGE";
        const DxfPolyline rim = sampled(part.cam, parallel(plate.offset_mm + 0.5 * kerf_mm));
        DxfDrawing drawing{{{outline, {rim}, {}}},
                           fmt::format("{}; plate {} of {} from below: {}, {:.3f} mm thick", provenance, i + 1, plates.size(), plate.name,
                                       plate.thickness_mm)};
        add_openings(drawing, part, plate, kerf_mm);
        if (kerf_mm == 0.0) {
            drawing.layers.push_back({outline + "_SPLINE", {}, {}, brep::outline_splines(part, plate.offset_mm)});
            drawing.layers.push_back(ticks(i + 1, sign * solid::crossing_at_zero(rim.points_mm, sign)));
        } else {
            drawing.provenance += fmt::format(", kerf {} mm", kerf_mm);
        }
        all.push_back(std::move(drawing));
    }
    return all;
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
        if (!cutter.radial && cutter.name != "mark") add_layer(drawing, layer_of(layer_name(cutter.name), cutter.outline));
    drawing.layers.push_back({"PITCH_SPLINE", {}, {}, brep::outline_splines(part, pitch)});
    drawing.layers.push_back({"FLOOR_SPLINE", {}, {}, brep::outline_splines(part, -half_cable)});
    if (part.cam.closed()) drawing.layers.push_back({"FLANGE_SPLINE", {}, {}, brep::outline_splines(part, upper_flange(part))});
    const double sign = solid::mark_angle(part) > 0.0 ? -1.0 : 1.0;
    const double rim = sign * (part.cam.closed() ? solid::crossing_at_zero(flange.points_mm, sign) : solid::helix_radius_mm(part));
    if (part.cam.has_roller() && part.cam.options.roller.follower == cam::FollowerKind::kArm)
        drawing.layers.push_back(pivot_of(part.cam.options.roller));
    drawing.layers.push_back({"MARK", {{{{kMarkFrom * rim, 0.0}, {rim, 0.0}}, false}}, {}});
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

DxfDrawing plate_drawing(const solid::Extrusion& plate, const std::string& provenance) {
    DxfDrawing drawing{{layer_of("OUTLINE", plate.outline)}, fmt::format("{}; {:.3f} mm thick", provenance, plate.length_mm)};
    for (const solid::RoundHole& hole : plate.holes)
        add_layer(drawing, {fmt::format("HOLE_{:.4g}", 2.0 * hole.radius_mm), {}, {{{hole.x_mm, hole.y_mm}, hole.radius_mm}}});
    return drawing;
}

std::vector<DxfDrawing> stack_drawings(const solid::Part& part, const std::string& provenance) { return drawings(part, 0.0, provenance); }

std::vector<DxfDrawing> stack_kerf_drawings(const solid::Part& part, double kerf_mm, const std::string& provenance) {
    require_kerf(kerf_mm, part.options.hub);
    return drawings(part, kerf_mm, provenance);
}

}  // namespace fusee::exchange
