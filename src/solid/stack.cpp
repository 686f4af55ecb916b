#include "fusee/solid/stack.h"

#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

namespace {

using core::mm_from_m;

constexpr double kGraze_mm = 0.05;  // a slot less deep in a plate is not cut through it

double core_of(const GrooveOptions& groove, double cable) { return groove.plate > 0.0 ? groove.plate : 2.0 * groove.radius_ratio * cable; }

}  // namespace

bool is_stack(const cam::Cam& cam, const PartOptions& options) {
    return options.groove.stacked && cam.closed() && !cam.has_roller() && options.hub.boss_height <= 0.0;
}

std::vector<SectionPoint> stack_section(const cam::Cam& cam, const PartOptions& options) {
    const double d = mm_from_m(cam.options.cable_diameter), half = 0.5 * mm_from_m(core_of(options.groove, cam.options.cable_diameter));
    const double floor = -0.5 * d, lip = floor + options.groove.depth_ratio * d;
    return {{lip, -half}, {floor, -half}, {floor, 0.0}, {floor, half}, {lip, half}};
}

double core_thickness(const Part& part) { return core_of(part.options.groove, part.cam.options.cable_diameter); }

std::vector<Plate> stack_plates(const Part& part) {
    const double rib = mm_from_m(part.options.groove.rib), core = mm_from_m(core_thickness(part));
    const Flanges flanges = flanges_of(part.options);
    const double lip = part.section.front().offset_mm;
    std::vector<Plate> plates{{"lower flange", rib, lip + flanges.lower_height_mm, {}},
                              {"core", core, -mm_from_m(0.5 * part.cam.options.cable_diameter), {}},
                              {"upper flange", rib, lip + flanges.upper_height_mm, {}}};
    const Dowels dowels = place_dowels(part);
    for (Plate& plate : plates) {
        plate.openings.push_back({"bore", bore_outline(part.options.hub)});
        for (const Point2& centre : dowels.centres_mm)
            if (dowels.space_mm > kDowel_mm) plate.openings.push_back({"dowel", circle(0.5 * (kDowel_mm - kReamed_mm), centre)});
    }
    const double slot_mm = mm_from_m(part.options.features.leg_slot_depth) - kGraze_mm;
    const std::array above{rib + core, rib, 0.0};  // of each plate
    for (const Cutter& cutter : top_holes(part))
        for (std::size_t i = 0; i < plates.size(); ++i)
            if ((cutter.name == "anchor" && i > 0) || (cutter.name == "leg_slot" && slot_mm > above[i]))
                plates[i].openings.push_back({cutter.name, cutter.outline});
    return plates;
}

std::optional<Outline> inset(const Outline& outline, double inset_mm) {
    Outline smaller = outline;
    for (Arc& arc : smaller) {
        if (arc.radius_mm <= inset_mm) return std::nullopt;
        arc.radius_mm -= inset_mm;
    }
    return smaller;
}

}  // namespace fusee::solid
