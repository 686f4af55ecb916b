#include "dowels.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"

namespace fusee::toolpath {

namespace {

using core::mm_from_m;
using solid::Point2;

constexpr double kReamed_mm = 0.1;    // allowance of the drill below the reamer, in diameter
constexpr double kPeck_mm = 1.0;      // one descent of the drill
constexpr double kPoint = 0.30043;    // length of a drill's point of 118 deg over its diameter: 0.5/tan(59 deg)
constexpr double kReamerLead = 0.25;  // length of a machine reamer's lead of 45 deg over its diameter, assumed
constexpr double kIndexDepth = 2.0;   // of the hole for the index pin, in diameters

/// What a drill for a reamed hole cuts below the hole's full diameter: its point, and the reamer's lead [mm].
double lead_of(double pin) { return kPoint * (pin - kReamed_mm) + kReamerLead * pin; }

/// No pin where `wanted` are: a smaller one, or another way of milling the part.
core::Finding no_pin(const solid::Part& part, const char* rule, const char* what, double wanted, double smaller_mm, const char* way) {
    core::Finding f;
    f.rule = rule;
    f.what = what;
    f.measured = 0.0;
    f.bound = core::Bound::kAtLeast;
    f.allowed = wanted;
    f.unit = "pins";
    f.where = to_string(part.cam.kind);
    f.suggestion = core::change("machining.dowel_diameter_mm", fmt::format("{:.1f}", smaller_mm))
                       .or_else(core::change(fmt::format("machining.{}", to_string(part.cam.kind)), core::quoted(way)));
    return f;
}

core::Finding no_place(const solid::Part& part, double pin) {
    core::Finding f = no_pin(part, "toolpath.dowels",
                             "no two dowel pins fit between bore and groove: the half plates are registered by shaft and key only", 2.0,
                             pin > 1.5 ? pin - 0.5 : 0.8, "wrap");
    f.source = "docs/guides/milling.md: dowels, walls of 0.8 mm";
    return core::judged(f, core::Severity::kWarning);
}

core::Finding no_index(const solid::Part& part) {
    core::Finding f = no_pin(
        part, "toolpath.index",
        "no pin fits into the blank's upper face: A0 is set by hand to the outline, and each degree beside it costs some % of the arm", 1.0,
        1.0, "stack");
    f.source = "docs/guides/milling.md: index";
    return core::judged(f, core::Severity::kWarning);
}

/// A reamed hole as the spindle sees it, `depth` at its full diameter below the stock's top.
struct Reamed {
    Point2 at{};
    double depth = 0.0;
    bool blind = false;
};

void sink(Gcode& code, const Cutting& cutting, const Point2& at, double depth, double peck, double feed) {
    code.line("G0 X{:.5f} Y{:.5f}", at[0], at[1]);
    code.line("G0 Z{:.5f}", kClearance_mm);
    const int count = std::max(1, static_cast<int>(std::ceil(depth / peck - 1e-9)));
    for (int i = 1; i <= count; ++i) {
        code.line("G1 Z{:.5f} F{:.5f}", -depth * i / count, feed);
        code.line("G1 Z{:.5f}", kClearance_mm);
    }
    code.line("G0 Z{:.5f}", cutting.safe);
}

/// Drills all holes, then reams them. Both go deeper by point or lead; in a blind hole the drill makes room for the reamer's lead, too.
void drill_and_ream(Gcode& code, const Settings& settings, const Cutting& cutting, const std::vector<Reamed>& holes, double pin) {
    for (const bool reams : {false, true}) {
        const double diameter = reams ? pin : pin - kReamed_mm, tip = reams ? pin - 2.0 * kReamerLead * pin : 0.0;
        const double lead = reams ? kReamerLead * pin : kPoint * diameter;
        code.tool(reams ? 3 : 2, fmt::format("{} {:g} mm{}", reams ? "reamer" : "drill", diameter, reams ? " H7" : ", point 118 deg"),
                  fmt::format("cone {:.5f} {:.5f} {:.5f}", tip, lead, diameter), mm_from_m(settings.flute_length), diameter,
                  reams ? 0.1 * settings.spindle_rpm : 0.4 * settings.spindle_rpm, settings);
        for (const Reamed& hole : holes)
            sink(code, cutting, hole.at, hole.depth + lead + (hole.blind && !reams ? kReamerLead * pin : 0.0), reams ? 1e9 : kPeck_mm,
                 0.5 * cutting.plunge);
    }
}

}  // namespace

core::Findings bore_dowels(Gcode& code, const solid::Part& part, const Settings& settings, const Cutting& cutting,
                           const std::vector<Plate>& plates, double pitch) {
    const double pin = mm_from_m(settings.dowel_diameter);
    if (pin <= 0.0) {
        code.comment("no dowels: half plates are registered by shaft and key");
        return {};
    }
    const auto places = solid::pin_places(part, pin);
    if (places.empty()) return {no_place(part, pin)};
    code.comment("dowels: two pins ISO 8734 - {:g} m6 x {:.0f}, holes {:g} H7; body places {:.3f} {:.3f} and {:.3f} {:.3f}", pin,
                 std::floor(plates[0].thickness + plates[1].thickness), pin, places[0][0], places[0][1], places[1][0], places[1][1]);
    std::vector<Reamed> holes;
    for (std::size_t i = 0; i < plates.size(); ++i)
        for (const Point2& p : places) {
            holes.push_back({{p[0] + pitch * static_cast<double>(i), plates[i].turned_over ? -p[1] : p[1]},
                             plates[i].thickness + cutting.breakthrough,
                             false});
            code.comment("hole {:.5f} {:.5f} {:.5f} {:.5f}", holes.back().at[0], holes.back().at[1], pin, -plates[i].thickness);
        }
    drill_and_ream(code, settings, cutting, holes, pin);
    return {};
}

std::optional<Index> index_of(const solid::Part& part, const Settings& settings) {
    const double pin = mm_from_m(settings.dowel_diameter);
    if (pin <= 0.0 || !part.cam.closed()) return std::nullopt;
    // A through bore is held on an arbor, whose washers cover the face around it.
    const auto free = solid::free_for_pin(part, pin, part.options.hub.boss_height > 0.0 ? 0.0 : kWasher_mm);
    const Point2* place = solid::farthest_from({0.0, 0.0}, free);
    const double depth = std::min(kIndexDepth * pin, mm_from_m(part.z_high - part.z_low) - lead_of(pin) - solid::kPinWall_mm);
    if (!place || depth < 0.5 * pin) return std::nullopt;
    return Index{*place, pin, depth};
}

core::Findings bore_index(Gcode& code, const solid::Part& part, const Settings& settings, const Cutting& cutting) {
    const auto index = index_of(part, settings);
    if (!index) return {no_index(part)};
    code.comment("index: blind hole {:g} H7, {:.2f} mm deep, at body place {:.3f} {:.3f}; its pin sets A on the rotary axis",
                 index->diameter, index->depth, index->at[0], index->at[1]);
    code.comment("hole {:.5f} {:.5f} {:.5f} {:.5f}", index->at[0], index->at[1], index->diameter, -index->depth);
    drill_and_ream(code, settings, cutting, {{index->at, index->depth, true}}, index->diameter);
    return {};
}

}  // namespace fusee::toolpath
