#include "groove_view.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/stack.h"
#include "fusee/solid/sweep.h"
#include "marks.h"
#include "view.h"

namespace fusee::drawing {

namespace {

using core::mm_from_m;

constexpr double kCalloutColumn = 46.0;   // of callouts
constexpr double kLipDimension = 12.0;    // the dimension of the lips' width
constexpr double kDepthDimension = 13.0;  // the dimension of the depth
constexpr double kGrooveHeading = 8.0;

/// Material beside the groove as a polygon, (distance from the cable's centreline, height) [mm], and its broken-off end.
struct Profile {
    Line line;
    double broken_mm = 0.0;
};

Profile profile_of(const solid::Part& part) {
    const solid::Flanges flanges = solid::flanges_of(part.options);
    const solid::SectionPoint &low = part.section.front(), &high = part.section.back();
    const double upper = part.cam.closed() ? flanges.upper_height_mm : 0.0, lower = part.cam.closed() ? flanges.lower_height_mm : 0.0;
    const double floor = -mm_from_m(0.5 * part.cam.options.cable_diameter), broken = floor - 0.8 * (low.offset_mm - floor);
    Profile profile{{}, broken};
    profile.line = {
        {broken, low.z_mm - flanges.rib_mm}, {low.offset_mm + lower, low.z_mm - flanges.rib_mm}, {low.offset_mm + lower, low.z_mm}};
    for (const solid::SectionPoint& p : part.section) profile.line.push_back({p.offset_mm, p.z_mm});
    profile.line.insert(
        profile.line.end(),
        {{high.offset_mm + upper, high.z_mm}, {high.offset_mm + upper, high.z_mm + flanges.rib_mm}, {broken, high.z_mm + flanges.rib_mm}});
    return profile;
}

std::vector<Callout> groove_callouts(const Subject& subject, const View& view) {
    const solid::Part& part = subject.part;
    const solid::GrooveOptions& groove = part.options.groove;
    const solid::SectionPoint& lip = part.section.back();
    const solid::SectionPoint& flank = part.section[part.section.size() - 2];  // end of the floor's arc
    const double d = mm_from_m(part.cam.options.cable_diameter), rib = mm_from_m(groove.rib);
    const solid::SectionPoint& floor = part.section[part.section.size() / 4];
    const std::string height =
        part.options.flange_height > 0.0 ? fmt::format(", {} over the lips", decimals(mm_from_m(part.options.flange_height))) : "";
    const double edge = part.cam.closed() ? lip.offset_mm + solid::flanges_of(part.options).upper_height_mm : lip.offset_mm;
    const bool stack = solid::is_stack(part.cam, part.options);
    const char* const beside = stack ? "plates 1 and 3, each" : part.cam.closed() ? "flange" : "land, at least";
    std::vector<Callout> all{{view.at(edge, lip.z_mm + 0.5 * rib), {fmt::format("{} {}", beside, decimals(rib))}},
                             {view.at(0.5 * d * std::cos(0.5), 0.5 * d * std::sin(0.5)),
                              {fmt::format("cable \u00d8{}", decimals(d)), subject.cable.construction + height}},
                             {view.at(floor.offset_mm, floor.z_mm),
                              {stack ? fmt::format("edge of plate 2, {} thick", decimals(2.0 * lip.z_mm))
                                     : fmt::format("floor R {}", decimals(groove.radius_ratio * d))}}};
    if (!stack)
        all.push_back({view.at(0.5 * (flank.offset_mm + lip.offset_mm), 0.5 * (flank.z_mm + lip.z_mm)),
                       {fmt::format("throat {} deg", decimals(core::deg_from_rad(groove.throat), 1))}});
    return all;
}

}  // namespace

void draw_groove(Sheet& sheet, const Subject& subject, const Box& area) {
    const solid::Part& part = subject.part;
    if (part.cam.has_roller()) return;
    const Profile profile = profile_of(part);
    const Box mm = extent({profile.line});
    const double room_width = area.high[0] - area.low[0] - kCalloutColumn - kLipDimension,
                 room_height = area.high[1] - area.low[1] - kGrooveHeading - kDepthDimension;
    const double scale =
        largest_scale([&](double s) { return s * (mm.high[0] - mm.low[0]) <= room_width && s * (mm.high[1] - mm.low[1]) <= room_height; });
    const double middle = area.low[1] + kGrooveHeading + 0.5 * room_height;
    const View view{{area.low[0] - scale * mm.low[0], middle + 0.5 * scale * (mm.low[1] + mm.high[1])}, scale};
    sheet.texts.push_back({fmt::format("groove ({})", scale_text(scale)), {area.low[0], area.low[1] + 4.0}, Align::kLeft, Text::kTitle});

    const Line line = view.at(profile.line);
    hatch(sheet, {line});
    sheet.strokes.push_back({Pen::kOutline, line});
    sheet.strokes.push_back({Pen::kThin, {line.back(), line.front()}});
    const double d = mm_from_m(part.cam.options.cable_diameter), floor = -0.5 * d;
    sheet.strokes.push_back({Pen::kHidden, view.at(solid::ring_of(solid::circle(0.5 * d), 0.002)), true});
    const solid::SectionPoint &low = part.section.front(), &high = part.section.back();
    const double bottom = extent({line}).high[1], right = extent({line}).high[0];
    dimension_across(sheet, view.at(floor, 0.0), view.at(low.offset_mm, low.z_mm), bottom + 8.0, decimals(low.offset_mm - floor));
    write_callouts(sheet, groove_callouts(subject, view), Align::kLeft, right + kLipDimension + 4.0,
                   {area.low[1] + kGrooveHeading, area.high[1] - kDepthDimension});
    dimension_up(sheet, view.at(low.offset_mm, low.z_mm), view.at(high.offset_mm, high.z_mm), right + 8.0, decimals(high.z_mm - low.z_mm));
}

}  // namespace fusee::drawing
