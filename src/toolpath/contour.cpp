#include <algorithm>
#include <array>
#include <cmath>

#include "dowels.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/program.h"

namespace fusee::toolpath {

namespace {

using core::mm_from_m;
using solid::Arc;

constexpr double kContourStepover = 0.6;                 // of clearing rings for a wall wider than the cutter, in cutter diameters
constexpr double kSpare_mm = 1.0;                        // of stock beyond the cutter's path
constexpr double kClampStrip_mm = 12.0;                  // of sheet beyond that at both ends
constexpr double kClamp_mm = 10.0, kClampTop_mm = 10.0;  // width and height of the clamps there
constexpr double kLooseBore = 1.05;                      // least bore over cutter, so that a helical move is possible

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
        const bool through = wall.bottom >= plate.thickness && plate.in_sheet;
        // On its boss the part stands fast, and the ring of the blank around it is held: by tabs, or by a skin as thick.
        const bool skin = wall.bottom >= plate.thickness && !plate.in_sheet && cutting.tabs == 0;
        const double bottom = wall.bottom + (through ? cutting.breakthrough : skin ? -cutting.tab_height : 0.0);
        const double gap = gap_between(wall.ring, plate.walls.back().ring);
        const int passes = std::max(1, static_cast<int>(std::ceil((bottom - top) / cutting.depth_per_pass - 1e-9)));
        const int outer = std::max(0, static_cast<int>(std::ceil((gap - cutting.cutter) / (kContourStepover * cutting.cutter))));
        for (int pass = 1; pass <= passes; ++pass) {
            const double depth = top + (bottom - top) * pass / passes;
            const double over_tabs = plate.thickness - cutting.tab_height;
            for (int k = outer; k >= 0; --k)  // the full slot first, the wall last
                mill_ring(code, cutting, shifted(parallel(wall.ring, k * kContourStepover * cutting.cutter), x), depth, over_tabs);
        }
        top = bottom;
    }
}

core::Finding bore_too_small(const solid::Part& part, const Plate& plate, double cutter) {
    const double widest = 2.0 * plate.bore_radius / kLooseBore;
    core::Finding f = core::error_finding("toolpath.bore", "the flat end mill is too wide for a helical move in the bore", cutter,
                                          core::Bound::kAtMost, widest, "mm");
    f.where = to_string(part.cam.kind);
    f.suggestion = core::change("machining.tool_diameter_mm", fmt::format("{:.2f}", 0.99 * widest));
    f.source = "docs/theory/toolpaths.md";
    return f;
}

void require_planar(const solid::Part& part) {
    if (part.cam.closed()) return;
    throw core::InvalidInput(std::string(to_string(part.cam.kind)) + ".path.kind", "helix", "planar: a helix is cut on a rotary axis");
}

/// The stock of plates side by side along X [mm].
struct Sheet {
    double half = 0.0;  ///< of its width; a plate's place is twice as long
    double thickness = 0.0;
    std::array<double, 2> x{};
};

/// The lead-ins start one cutter beyond those of the last ring; the widest clearing ring lies within one cutter of the outline.
/// @param strip for the clamps at both ends
Sheet sheet_of(const Cutting& cutting, double reach, double thickness, std::size_t plates, double strip) {
    const double half = reach + lead_length(cutting.cutter) + 0.5 * cutting.cutter + kSpare_mm;
    return {half, thickness, {-half - strip, 2.0 * half * static_cast<double>(plates) - half + strip}};
}

void describe_sheet(Gcode& code, const Cutting& cutting, const Sheet& sheet) {
    code.comment("sheet {:.3f} x {:.3f} mm, {:.3f} mm thick, on a board; clamps on {:.0f} mm of both ends, at most {:.0f} mm high",
                 sheet.x[1] - sheet.x[0], 2.0 * sheet.half, sheet.thickness, kClamp_mm, kClampTop_mm);
    if (cutting.tabs > 0)
        code.comment("{} tabs of {:.1f} x {:.1f} mm hold each plate", cutting.tabs, cutting.tab_width, cutting.tab_height);
    else
        code.comment("no tabs: hold the sheet down by vacuum or double-sided tape");
    if (cutting.tabs == 0) code.comment("held box {:.5f} {:.5f} {:.5f} {:.5f}", sheet.x[0], sheet.x[1], -sheet.half, sheet.half);
    code.comment("clamp box {:.5f} {:.5f} {:.5f} {:.5f} {:.5f}", sheet.x[0], sheet.x[0] + kClamp_mm, -sheet.half, sheet.half, kClampTop_mm);
    code.comment("clamp box {:.5f} {:.5f} {:.5f} {:.5f} {:.5f}", sheet.x[1] - kClamp_mm, sheet.x[1], -sheet.half, sheet.half, kClampTop_mm);
    code.comment("board {:.5f} {:.5f}", -sheet.thickness, cutting.breakthrough);
}

void describe_turned(Gcode& code, const solid::Part& part, const Settings& settings, const Sheet& sheet) {
    const double boss = mm_from_m(part.options.hub.boss_height), grip = std::min(boss, mm_from_m(settings.chuck_grip));
    const double radius = 0.5 * mm_from_m(settings.chuck_diameter), face = -sheet.thickness - boss + grip;
    code.comment(
        "blank: turned disc of at least {:.3f} mm diameter, {:.3f} mm thick, above its boss of {:.3f} x {:.3f} mm, with the bore from "
        "below",
        2.0 * sheet.half, sheet.thickness, mm_from_m(part.options.hub.boss_diameter), boss);
    code.comment("clamping: upright chuck on the boss, {:.1f} mm inside; no board; {} of {:.1f} mm {} the ring around the part", grip,
                 settings.tabs > 0 ? "tabs" : "a skin", mm_from_m(settings.tab_height), settings.tabs > 0 ? "hold" : "holds");
    const double held = 0.35 * mm_from_m(part.options.hub.boss_diameter);  // a square within the boss
    code.comment("held box {:.5f} {:.5f} {:.5f} {:.5f}", -held, held, -held, held);
    code.comment("clamp box {:.5f} {:.5f} {:.5f} {:.5f} {:.5f}", -radius, radius, -radius, radius, face);
}

/// Plates side by side along X, out of one sheet or above a turned boss.
core::Outcome<Program> mill_sheet(const solid::Part& part, const Settings& settings, const std::vector<Plate>& plates,
                                  const std::string& cuts, Gcode code) {
    Cutting cutting(settings);
    double reach = 0.0, thickness = 0.0;
    for (const Plate& plate : plates) {
        if (plate.bore_radius > 0.0 && cutting.cutter * kLooseBore > 2.0 * plate.bore_radius)
            return bore_too_small(part, plate, cutting.cutter);
        reach = std::max(reach, extent_of(plate.walls.back().ring));
        thickness = std::max(thickness, plate.thickness);
    }
    const bool in_sheet = plates.front().in_sheet;
    const Sheet sheet = sheet_of(cutting, reach, thickness, plates.size(), in_sheet ? kClampStrip_mm : 0.0);
    if (in_sheet) cutting.safe += kClampTop_mm;
    code.comment("X0 Y0: the cam's axis in the first plate; Z0: top of the stock");
    in_sheet ? describe_sheet(code, cutting, sheet) : describe_turned(code, part, settings, sheet);
    code.comment("by hand: {}{}", left_out(part), cutting.tabs > 0 ? ", tabs filed" : in_sheet ? "" : ", the skin filed");
    code.comment("cuts {}", cuts);
    code.comment("cutter end {:.5f}", cutting.cutter);
    code.comment("stock box {:.5f} {:.5f} {:.5f} {:.5f} {:.5f} 0", sheet.x[0], sheet.x[1], -sheet.half, sheet.half, -thickness);
    code.comment("the number below is the end mill's true diameter in mm: a worn cutter changes it only");
    code.line("#<cutter> = {:.5f}", cutting.cutter);
    code.begin(settings);
    core::Findings findings;
    if (cuts == "floor" && plates.size() == 2) core::append(findings, bore_dowels(code, part, settings, cutting, plates, 2.0 * sheet.half));
    if (cuts == "blank") core::append(findings, bore_index(code, part, settings, cutting));
    code.tool(1, fmt::format("flat end mill {:.2f} mm, cuts to its centre", cutting.cutter), fmt::format("end {:.5f}", cutting.cutter),
              mm_from_m(settings.flute_length), cutting.cutter, settings.spindle_rpm, settings);
    for (std::size_t i = 0; i < plates.size(); ++i) mill_plate(code, cutting, plates[i], 2.0 * sheet.half * static_cast<double>(i));
    code.end();
    findings.push_back(judge_chip_load(settings, settings.feed, cutting.cutter, settings.spindle_rpm, "machining.feed_mm_per_min",
                                       to_string(part.cam.kind)));
    return Program{"", code.text(), findings};
}

core::Outcome<Program> named(core::Outcome<Program> program, const char* suffix) {
    if (!program) return program.refusal();
    Program result = std::move(program).value();
    result.suffix = suffix;
    return result;
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
    code.comment("part {}: outlines before the groove is cut on a rotary axis", to_string(part.cam.kind));
    Plate plate = blank_plate(part, settings);
    plate.in_sheet = part.options.hub.boss_height <= 0.0;  // else the boss is turned first, and holds the part
    auto program = mill_sheet(part, settings, {plate}, "blank", std::move(code));
    return named(std::move(program), "_blank");
}

core::Outcome<Program> boss_program(const solid::Part& part, const Settings& settings, const std::string& provenance) {
    require_valid(settings);
    Gcode code(provenance);
    code.comment("part {}: the boss as a plate of its own, lower face up", to_string(part.cam.kind));
    const double on = mm_from_m(part.options.groove.rib - part.options.hub.web);
    if (part.options.hub.kind == solid::HubKind::kOverhung && on > 0.0)
        code.comment("the bore goes on {:.3f} mm into the lower plate, from below", on);
    auto program = mill_sheet(part, settings, {boss_plate(part, settings)}, "boss", std::move(code));
    return named(std::move(program), "_boss");
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
    std::vector<Program> programs;
    core::Findings refusals;
    const auto add = [&](core::Outcome<Program> made) {
        if (made)
            programs.push_back(std::move(made).value());
        else
            core::append(refusals, made.refusal());
    };
    if (rim) add(rim_program(part, settings, provenance));
    if (stacked) add(contour_program(part, settings, provenance));
    if ((rim || stacked) && part.options.hub.boss_height > 0.0) add(boss_program(part, settings, provenance));
    if (!rim && !stacked && planar) add(blank_program(part, settings, provenance));
    if (!rim && !stacked) add(wrap_program(part, settings, provenance));
    if (!refusals.empty()) return refusals;
    return programs;
}

}  // namespace fusee::toolpath
