#include "development.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "fusee/drawing/inspection.h"
#include "fusee/solid/sweep.h"
#include "marks.h"
#include "view.h"

namespace fusee::drawing {

namespace {

using core::mm_from_m;

constexpr double kDevelopmentHeading = 12.0, kAngleRoom = 8.0;  // name and letters above, angles below
constexpr double kSideRoom = 14.0;                              // of the dimension at each end
constexpr double kEndTick = 1.6, kAngleLabel = 4.4;             // of an end's mark and of an angle from the line
constexpr double kEndLetter = 1.6;                              // of P and Q above the development
constexpr double kApart = 16.0;                                 // of two angles' texts
constexpr double kQuarter = 0.25 * core::kTurn;
constexpr double kLineStep = core::kTurn / 72.0;  // of the centreline's polyline

/// Place of a direction of the contour: arc of the cylinder, z [mm].
Point developed(const cam::Cam& cam, double radius_mm, double psi) {
    const cam::PathPoint p = cam.path(psi);
    return {radius_mm * (psi + std::atan2(p.slope, p.h)), mm_from_m(p.z)};
}

/// Lines at whole quarters of a turn, or halves or turns where these are too near each other.
void draw_developed_angles(Sheet& sheet, const View& view, const core::Range& across, const core::Range& up, double radius_mm) {
    double step = kQuarter;
    while (view.scale * radius_mm * step < kApart) step *= 2.0;
    for (double angle = std::ceil(across.low / radius_mm / step) * step; angle * radius_mm <= across.high; angle += step) {
        const Point foot = view.at(radius_mm * angle, up.low), head = view.at(radius_mm * angle, up.high);
        sheet.strokes.push_back({Pen::kThin, {foot, head}});
        sheet.texts.push_back({fmt::format("{} deg", decimals(core::deg_from_rad(angle) + 0.0, 0)),
                               {foot[0], foot[1] + kAngleLabel},
                               Align::kMiddle,
                               Text::kSmall});
    }
}

void draw_developed_ends(Sheet& sheet, const solid::Part& part, const View& view, double radius_mm) {
    const auto ends = arc_ends(part);
    const char* const letters[] = {"P", "Q"};
    const double above = view.at(0.0, mm_from_m(part.z_high))[1] - kEndLetter;
    for (std::size_t i = 0; i < 2; ++i) {
        const Point at = view.at(developed(part.cam, radius_mm, ends[i].normal));
        sheet.strokes.push_back({Pen::kOutline, {{at[0], at[1] - kEndTick}, {at[0], at[1] + kEndTick}}});
        sheet.texts.push_back({letters[i], {at[0], above}, Align::kMiddle, Text::kTitle});
    }
}

}  // namespace

void draw_development(Sheet& sheet, const solid::Part& part, const Box& area) {
    const cam::Cam& cam = part.cam;
    if (cam.closed()) return;
    const double radius = solid::helix_radius_mm(part), low = mm_from_m(part.z_low), high = mm_from_m(part.z_high);
    Line groove;
    for (double psi = cam.groove_psi.low; psi < cam.groove_psi.high; psi += kLineStep) groove.push_back(developed(cam, radius, psi));
    groove.push_back(developed(cam, radius, cam.groove_psi.high));
    const double left = groove.front()[0], right = groove.back()[0];
    const double width = area.high[0] - area.low[0] - 2.0 * kSideRoom,
                 height = area.high[1] - area.low[1] - kDevelopmentHeading - kAngleRoom;
    const double scale = largest_scale([&](double s) { return s * (right - left) <= width && s * (high - low) <= height; });
    const View view{{area.low[0] + kSideRoom - scale * left, area.low[1] + kDevelopmentHeading + scale * high}, scale};

    sheet.texts.push_back(
        {fmt::format("development of the groove's centreline on \u00d8{} ({})", decimals(2.0 * radius, 2), scale_text(scale)),
         {area.low[0], area.low[1] + 4.0},
         Align::kLeft,
         Text::kBody});
    sheet.strokes.push_back({Pen::kOutline, view.at(Line{{left, low}, {right, low}, {right, high}, {left, high}}), true, "development"});
    sheet.strokes.push_back({Pen::kCentre, view.at(groove), false, "development"});
    draw_developed_angles(sheet, view, {left, right}, {low, high}, radius);
    draw_developed_ends(sheet, part, view, radius);
    for (const Point& end : {groove.front(), groove.back()}) {
        const double side = end == groove.front() ? -8.0 : 8.0;
        dimension_up(sheet, view.at(end[0], low), view.at(end), view.at(end)[0] + side, decimals(end[1] - low, 2));
    }
}

}  // namespace fusee::drawing
