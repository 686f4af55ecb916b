#include "motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/drawing/inspection.h"
#include "fusee/solid/outline.h"
#include "words.h"

namespace fusee::drawing {

namespace {

using core::mm_from_m;

constexpr double kBeyondOutline = 8.0;  // of the cable's line on the sheet
constexpr double kTurnSpan = 1.2;       // of the turn's arc [rad]

/// Direction in which the cable leaves at psi: along the tangent, towards its guide. Body frame, at cam angle 0.
Point exit_direction(const cam::Cam& cam, const cam::PathPoint& contact) {
    const cam::Guide& guide = cam.options.guide;
    const Point tangent{-std::sin(contact.psi), std::cos(contact.psi)};
    Point to{std::cos(guide.direction), std::sin(guide.direction)};
    if (guide.kind != cam::GuideKind::kParallel) to = {guide.distance * to[0] - contact.x(), guide.distance * to[1] - contact.y()};
    const double sign = tangent[0] * to[0] + tangent[1] * to[1] < 0.0 ? -1.0 : 1.0;
    return {sign * tangent[0], sign * tangent[1]};
}

/// Length of a line from a point within a box until it leaves it.
double length_within(const Box& box, const Point& from, const Point& way) {
    double length = 1e9;
    for (std::size_t i = 0; i < 2; ++i)
        if (std::abs(way[i]) > 1e-9) length = std::min(length, ((way[i] > 0.0 ? box.high[i] : box.low[i]) - from[i]) / way[i]);
    return std::max(0.0, length);
}

void draw_circle(Sheet& sheet, const View& view, const Point& centre, double radius, const char* name) {
    sheet.strokes.push_back({Pen::kThin, view.at(solid::ring_of(solid::circle(radius, centre), 0.005)), true, name});
}

/// The roller and its arm at the beginning of the law, where body and world agree.
std::vector<Callout> draw_arm(Sheet& sheet, const Subject& subject, const View& view, const Box& box) {
    constexpr double kPivot = 1.5;  // radius of its circle on the sheet
    const cam::Roller& roller = subject.part.cam.options.roller;
    if (roller.follower != cam::FollowerKind::kArm) return {};
    const cam::PathPoint& contact = subject.part.cam.working.front().path;
    const double radius = mm_from_m(roller.radius), away = mm_from_m(roller.arm.pivot);
    const Point centre{mm_from_m(contact.x()) + radius * std::cos(contact.psi), mm_from_m(contact.y()) + radius * std::sin(contact.psi)};
    const Point pivot{away * std::cos(roller.direction), away * std::sin(roller.direction)};
    const Point from = view.at(centre), to = view.at(pivot);
    const double whole = std::hypot(to[0] - from[0], to[1] - from[1]);
    const Point way{(to[0] - from[0]) / whole, (to[1] - from[1]) / whole};
    const double room = length_within(box, from, way) + kBeyondOutline, length = std::min(whole, room);
    const Point tip{from[0] + length * way[0], from[1] + length * way[1]};
    draw_circle(sheet, view, centre, radius, "roller");
    sheet.strokes.push_back({Pen::kThin, {from, tip}, false, "follower-arm"});
    if (whole <= room)
        draw_circle(sheet, view, pivot, kPivot / view.scale, "pivot");
    else
        sheet.arrows.push_back({tip, std::atan2(way[1], way[0])});
    return {{tip,
             {fmt::format("roller's arm of {},", decimals(mm_from_m(roller.arm.length))),
              fmt::format("pivot at x {}, y {}", decimals(pivot[0]), decimals(pivot[1]))}}};
}

}  // namespace

std::vector<Callout> draw_partner(Sheet& sheet, const Subject& subject, const View& view, const Box& box) {
    const solid::Part& part = subject.part;
    const cam::Cam& cam = part.cam;
    if (cam.has_roller()) return draw_arm(sheet, subject, view, box);
    const cam::PathPoint contact = cam.path(arc_ends(part).front().normal);
    const Point way = exit_direction(cam, contact), on_sheet{way[0], -way[1]};
    const Point from = view.at(mm_from_m(contact.x()), mm_from_m(contact.y()));
    const double length = length_within(box, from, on_sheet) + kBeyondOutline;
    const Point tip{from[0] + length * on_sheet[0], from[1] + length * on_sheet[1]};
    sheet.strokes.push_back({Pen::kThin, {from, tip}, false, "cable-exit"});
    sheet.arrows.push_back({tip, std::atan2(on_sheet[1], on_sheet[0])});
    const double angle = core::within_turn(std::atan2(way[1], way[0]), 0.0);
    const Point middle{tip[0] - 4.0 * on_sheet[0], tip[1] - 4.0 * on_sheet[1]};
    return {{middle,
             {fmt::format("cable at the {},", beginning_of(subject)),
              fmt::format("leaves at {} deg", decimals(core::deg_from_rad(angle), 2))}}};
}

Callout draw_turn(Sheet& sheet, const Subject& subject, const View& view) {
    const solid::Part& part = subject.part;
    const solid::HubOptions& hub = part.options.hub;
    const double bore = 0.5 * (hub.bore_diameter + hub.bore_clearance);
    const double radius = mm_from_m(std::max(1.6 * bore, 0.5 * hub.boss_diameter)) + 1.5 / view.scale;
    const double sense = part.cam.rotation_sign, middle = 1.5 * core::kPi;
    Line arc;
    for (int i = 0; i <= 24; ++i) {
        const double angle = middle + sense * kTurnSpan * (i / 24.0 - 0.5);
        arc.push_back(view.at(radius * std::cos(angle), radius * std::sin(angle)));
    }
    const double end = middle + 0.5 * sense * kTurnSpan + 0.5 * sense * core::kPi;  // the tangent, y upwards
    sheet.arrows.push_back({arc.back(), -end});
    const Point target = arc[6];
    sheet.strokes.push_back({Pen::kThin, std::move(arc), false, "turn"});
    return {target,
            {"turns in this sense", pulls_back(subject)     ? "as the angle falls"
                                    : is_of_spring(subject) ? "as the angle rises"
                                                            : "as the load rises"}};
}

void draw_arc_ends(Sheet& sheet, const solid::Part& part, const View& view) {
    const auto ends = arc_ends(part);
    constexpr double kTick = 1.6;
    const char* const letters[] = {"P", "Q"};
    for (std::size_t i = 0; i < 2; ++i) {
        const Point at = view.at(mm_from_m(ends[i].x), mm_from_m(ends[i].y));
        const double nx = std::cos(ends[i].normal), ny = -std::sin(ends[i].normal);
        sheet.strokes.push_back(
            {Pen::kOutline, {{at[0] - kTick * nx, at[1] - kTick * ny}, {at[0] + kTick * nx, at[1] + kTick * ny}}, false, "arc-end"});
        std::vector<Text> places;
        for (const double out : {-5.0, -7.0, 6.0, 9.0, 12.0, 15.0, -10.0, 18.0, -13.0, 22.0, 26.0})
            for (const double turn : {0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2}) {
                const double c = std::cos(turn), s = std::sin(turn), x = c * nx - s * ny, y = s * nx + c * ny;
                places.push_back({letters[i], {at[0] + out * x, at[1] + out * y + 1.7}, Align::kMiddle, Text::kTitle});
            }
        sheet.write_clear(places);
    }
}

}  // namespace fusee::drawing
