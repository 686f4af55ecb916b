#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/arcs.h"
#include "fusee/toolpath/program.h"
#include "gcode.h"
#include "plates.h"

namespace fusee::toolpath {

namespace {

using core::mm_from_m;
using solid::Arc;

constexpr double kContourStepover = 0.6;  // of clearing rings for a wall wider than the cutter, in cutter diameters
constexpr double kSpare_mm = 1.0;         // of stock beyond the cutter's path
constexpr double kLooseBore = 1.05;       // least bore over cutter, so that a helical move is possible

double extent_of(const std::vector<Arc>& ring) {
    double reach = 0.0;
    for (const Arc& arc : ring) {
        const solid::Point2 p = arc.at(arc.begin);
        reach = std::max(reach, std::hypot(p[0], p[1]));
    }
    return reach;
}

/// The largest gap between the ring and a wider one: the difference of their support functions.
double gap_between(const std::vector<Arc>& ring, const std::vector<Arc>& wider) {
    const auto support = [](const std::vector<Arc>& of, double psi) {
        double h = -1e9;
        for (const Arc& arc : of) {
            const solid::Point2 p = arc.at(arc.begin);
            h = std::max(h, p[0] * std::cos(psi) + p[1] * std::sin(psi));
        }
        return h;
    };
    double gap = 0.0;
    for (const Arc& arc : ring) gap = std::max(gap, support(wider, arc.begin) - support(ring, arc.begin));
    return gap;
}

std::vector<Arc> shifted(std::vector<Arc> ring, double x) {
    for (Arc& arc : ring) arc.centre_mm[0] += x;
    return ring;
}

void mill_plate(Gcode& code, const Cutting& cutting, const Plate& plate, double x) {
    code.comment("plate {} at {:.5f} {}", plate.name, x, plate.turned_over ? "turned" : "upright");
    if (plate.bore_radius > 0.0)
        mill_bore(code, cutting, x, plate.bore_radius, plate.bore_depth + (plate.bored_through() ? cutting.breakthrough : 0.0));
    double top = 0.0;
    for (const Wall& wall : plate.walls) {
        const double bottom = wall.bottom + (wall.bottom >= plate.thickness ? cutting.breakthrough : 0.0);
        const double gap = gap_between(wall.ring, plate.walls.back().ring);
        const int passes = std::max(1, static_cast<int>(std::ceil((bottom - top) / cutting.depth_per_pass - 1e-9)));
        const int outer = std::max(0, static_cast<int>(std::ceil((gap - cutting.cutter) / (kContourStepover * cutting.cutter))));
        for (int pass = 1; pass <= passes; ++pass)
            for (int k = outer; k >= 0; --k)  // the full slot first, the wall last
                mill_ring(code, cutting, shifted(parallel(wall.ring, k * kContourStepover * cutting.cutter), x),
                          top + (bottom - top) * pass / passes);
        top = bottom;
    }
}

core::Finding bore_too_small(const solid::Part& part, const Plate& plate, double cutter) {
    const double widest = 2.0 * plate.bore_radius / kLooseBore;
    core::Finding f = core::error_finding("toolpath.bore", "the flat end mill is too wide for a helical move in the bore", cutter,
                                          core::Bound::kAtMost, widest, "mm");
    f.where = to_string(part.cam.kind);
    f.suggestion = fmt::format("machining.tool_diameter_mm = {:.2f}", 0.99 * widest);
    f.source = "docs/theory/toolpaths.md";
    return f;
}

void require_planar(const solid::Part& part) {
    if (part.cam.closed()) return;
    throw core::InvalidInput(std::string(to_string(part.cam.kind)) + ".path.kind", "helix", "planar: a helix is cut on a rotary axis");
}

/// Plates side by side along X, out of one sheet.
core::Outcome<Program> mill_sheet(const solid::Part& part, const Settings& settings, const std::vector<Plate>& plates,
                                  const std::string& cuts, Gcode code) {
    const Cutting cutting(settings);
    double reach = 0.0, thickness = 0.0;
    for (const Plate& plate : plates) {
        if (plate.bore_radius > 0.0 && cutting.cutter * kLooseBore > 2.0 * plate.bore_radius)
            return bore_too_small(part, plate, cutting.cutter);
        reach = std::max(reach, extent_of(plate.walls.back().ring));
        thickness = std::max(thickness, plate.thickness);
    }
    // The lead-ins start one cutter beyond those of the last ring; the widest clearing ring lies within one cutter of the outline.
    const double half = reach + lead_length(cutting.cutter) + 0.5 * cutting.cutter + kSpare_mm;
    const double width = 2.0 * half * static_cast<double>(plates.size());
    code.comment("X0 Y0: the cam's axis in the first plate; Z0: top of the stock; sheet {:.3f} x {:.3f} mm, {:.3f} mm thick, on a board",
                 width, 2.0 * half, thickness);
    code.comment("T1: flat end mill, cuts to its centre. Its true diameter in mm is the number below");
    code.comment("not in this program: {}", left_out(part));
    code.comment("cuts {}", cuts);
    code.comment("cutter end {:.5f}", cutting.cutter);
    code.comment("stock box {:.5f} {:.5f} {:.5f} {:.5f} {:.5f} 0", -half, width - half, -half, half, -thickness);
    code.line("#<cutter> = {:.5f}", cutting.cutter);
    code.begin(settings.spindle_rpm);
    code.line("G0 Z{:.5f}", cutting.safe);
    for (std::size_t i = 0; i < plates.size(); ++i) mill_plate(code, cutting, plates[i], 2.0 * half * static_cast<double>(i));
    code.end();
    return Program{"", code.text()};
}

}  // namespace

core::Outcome<Program> contour_program(const solid::Part& part, const Settings& settings, const std::string& provenance) {
    require_valid(settings);
    require_planar(part);
    Gcode code(provenance);
    code.comment("part {}: two half plates; the groove's plane is up in both, the upper one is turned over about X",
                 to_string(part.cam.kind));
    return mill_sheet(part, settings, half_plates(part, settings), "floor", std::move(code));
}

core::Outcome<Program> blank_program(const solid::Part& part, const Settings& settings, const std::string& provenance) {
    require_valid(settings);
    require_planar(part);
    Gcode code(provenance);
    code.comment("part {}: outlines before the groove is cut on a rotary axis{}", to_string(part.cam.kind),
                 part.options.hub.boss_height > 0.0 ? "; clamped by its boss, which is turned first" : "");
    auto program = mill_sheet(part, settings, {blank_plate(part, settings)}, "blank", std::move(code));
    return program ? core::Outcome<Program>(Program{"_blank", program->text}) : program;
}

core::Outcome<Program> boss_program(const solid::Part& part, const Settings& settings, const std::string& provenance) {
    require_valid(settings);
    Gcode code(provenance);
    code.comment("part {}: the boss as a plate of its own, lower face up", to_string(part.cam.kind));
    const double on = mm_from_m(part.options.groove.rib - part.options.hub.web);
    if (part.options.hub.kind == solid::HubKind::kOverhung && on > 0.0)
        code.comment("the bore goes on {:.3f} mm into the lower plate, from below", on);
    auto program = mill_sheet(part, settings, {boss_plate(part, settings)}, "boss", std::move(code));
    return program ? core::Outcome<Program>(Program{"_boss", program->text}) : program;
}

core::Outcome<Program> rim_program(const solid::Part& part, const Settings& asked, const std::string& provenance) {
    constexpr double kSlopes = 0.1;  // of the tolerance: a follower's arm depends on the slope of the rim, not its distance
    require_valid(asked);
    Settings settings = asked;
    settings.tolerance *= kSlopes;
    Gcode code(provenance);
    code.comment("part {}: a plate with a rim for a roller", to_string(part.cam.kind));
    Plate plate = blank_plate(part, settings);
    plate.name = "rim";
    return mill_sheet(part, settings, {plate}, "floor", std::move(code));
}

core::Outcome<std::vector<Program>> part_programs(const solid::Part& part, const Settings& settings, const std::string& provenance) {
    const Method asked = part.cam.kind == cam::PartKind::kSeries ? settings.k_se : settings.k_pe;
    const bool rim = part.cam.has_roller(), planar = part.cam.closed(), stacked = !rim && planar && asked == Method::kStack;
    std::vector<core::Outcome<Program>> made;
    if (rim) made.push_back(rim_program(part, settings, provenance));
    if (stacked) made.push_back(contour_program(part, settings, provenance));
    if ((rim || stacked) && part.options.hub.boss_height > 0.0) made.push_back(boss_program(part, settings, provenance));
    if (!rim && !stacked && planar) made.push_back(blank_program(part, settings, provenance));
    if (!rim && !stacked) made.push_back(wrap_program(part, settings, provenance));
    std::vector<Program> programs;
    core::Findings refusals;
    for (const auto& program : made) {
        if (program)
            programs.push_back(*program);
        else
            core::append(refusals, program.refusal());
    }
    if (!refusals.empty()) return refusals;
    return programs;
}

}  // namespace fusee::toolpath
