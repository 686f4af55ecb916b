#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "body.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/stack.h"
#include "motion.h"
#include "tolerances.h"
#include "words.h"

namespace fusee::drawing {

namespace {

using core::mm_from_m;

// Below a face by less than the depth of any timing mark, at a height without vertices of a mesh.
constexpr double kUnderFace_mm = 0.0137;
constexpr double kBeyond = 4.0;      // of centre lines over the outline, on the sheet
constexpr double kCutEnd = 5.0;      // thick end of the cutting plane's line
constexpr double kDimension = 11.0;  // of the overall dimensions from the outline

Line circle_line(double radius_mm, Point centre_mm = {}) { return solid::ring_of(solid::circle(radius_mm, centre_mm), 0.005); }

void stroke(Sheet& sheet, const View& view, Pen pen, const Line& line, bool closed) {
    sheet.strokes.push_back({pen, view.at(line), closed});
}

void draw_hidden(Sheet& sheet, const solid::Part& part, const View& view) {
    const solid::HubOptions& hub = part.options.hub;
    const cam::Cam& cam = part.cam;
    if (!cam.has_roller())
        stroke(sheet, view, Pen::kHidden, solid::parallel(cam, cam.groove_psi, -0.5 * cam.options.cable_diameter), cam.closed());
    if (hub.boss_height > 0.0) stroke(sheet, view, Pen::kHidden, circle_line(mm_from_m(0.5 * hub.boss_diameter)), true);
    if (hub.kind == solid::HubKind::kOverhung) stroke(sheet, view, Pen::kHidden, solid::ring_of(solid::bore_outline(hub), 0.005), true);
    if (solid::anchor_leads_down(cam, part.options))
        for (const solid::Cutter& hole : solid::make_cutters(part))
            if (hole.name == "anchor") stroke(sheet, view, Pen::kHidden, solid::ring_of(hole.outline, 0.005), true);
    if (hub.lock != solid::HubLock::kSetScrew) return;
    const double half = mm_from_m(0.5 * hub.screw_diameter), inner = mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance));
    for (const double y : {-half, half})
        stroke(sheet, view, Pen::kHidden, {{std::sqrt(inner * inner - half * half), y}, {mm_from_m(0.5 * hub.boss_diameter), y}}, false);
}

/// Centre lines; that along x is the cutting plane, with arrows in the viewing direction of the section.
void draw_axes(Sheet& sheet, const Box& box, const Point& axis) {
    const double left = box.low[0] - kBeyond, right = box.high[0] + kBeyond, y = axis[1];
    sheet.strokes.push_back({Pen::kCentre, {{axis[0], box.low[1] - kBeyond}, {axis[0], box.high[1] + kBeyond}}});
    sheet.strokes.push_back({Pen::kCentre, {{left, y}, {right, y}}});
    for (const double x : {left, right + kCutEnd}) {
        const double foot = x - 0.5 * kCutEnd;
        sheet.strokes.push_back({Pen::kCut, {{x - kCutEnd, y}, {x, y}}});
        sheet.strokes.push_back({Pen::kThin, {{foot, y}, {foot, y - 7.0}}});
        sheet.arrows.push_back({{foot, y - 7.0}, -0.5 * core::kPi});
    }
}

void name_cut(Sheet& sheet, const Box& box, const Point& axis) {
    const double left = box.low[0] - kBeyond - 0.5 * kCutEnd, right = box.high[0] + kBeyond + 0.5 * kCutEnd;
    for (const double x : {left, right}) {
        std::vector<Text> places;
        for (const double aside : {0.0, 4.0, -4.0})
            for (const double down : {5.2, -8.4, 9.0, -12.0, 13.0, 17.0, -16.0})
                places.push_back({"A", {x + aside, axis[1] + down}, Align::kMiddle, Text::kTitle});
        sheet.write_clear(places);
    }
}

/// The point that lies farthest along an axis (0: x, 1: y), in the direction of `sign`.
Point outermost(const std::vector<Line>& lines, std::size_t axis, double sign) {
    Point far = lines.front().front();
    for (const Line& line : lines)
        for (const Point& p : line)
            if (sign * p[axis] > sign * far[axis]) far = p;
    return far;
}

/// The point of an outline that is farthest from the axis.
Point farthest(const std::vector<Line>& lines) {
    Point far{};
    for (const Line& line : lines)
        for (const Point& p : line)
            if (std::hypot(p[0], p[1]) > std::hypot(far[0], far[1])) far = p;
    return far;
}

Words anchor_words(const solid::Part& part, const solid::Cutter& hole) {
    const solid::Arc& rim = hole.outline.front();
    const auto [x, y] = rim.centre_mm;
    const double angle = core::within_turn(std::atan2(y, x), 0.0);
    const std::string wide = decimals(2.0 * rim.radius_mm), upper = deep_words(part, "anchor", mm_from_m(part.z_high) - hole.low_mm);
    Words words{fmt::format("hole \u00d8{}, {},", wide, upper), "for the cable's end"};
    if (solid::anchor_leads_down(part.cam, part.options))
        words = {fmt::format("hole \u00d8{} from below,", wide), decimals(hole.high_mm - mm_from_m(part.z_low)) + " deep, for the",
                 "cable's end"};
    words.push_back(fmt::format("at R {}, {} deg", decimals(std::hypot(x, y)), decimals(core::deg_from_rad(angle), 2)));
    words.push_back(fmt::format("(x {}, y {})", decimals(x), decimals(y)));
    if (const double edge = part.options.features.anchor_edge_radius; edge > 0.0)
        words.push_back(fmt::format("edge R {} by hand", decimals(mm_from_m(edge))));
    return words;
}

Words screw_words(const solid::Cutter& hole) {
    const solid::Arc& rim = hole.outline.front();  // (y, z)
    return {fmt::format("set screw hole \u00d8{},", decimals(2.0 * rim.radius_mm)),
            fmt::format("radial, 0 deg, z {}", decimals(rim.centre_mm[1]))};
}

Point on_circle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

Words dowel_words(const solid::Part& part, const std::vector<solid::Cutter>& cutters) {
    Words words{"", "reamed through " + std::string(solid::is_stack(part.cam, part.options) ? "all" : "both half"), "plates, at"};
    for (const solid::Cutter& cutter : cutters)
        if (cutter.name == "dowel") {
            const solid::Arc& rim = cutter.outline.front();
            words.front() = fmt::format("2 dowel holes \u00d8{} H7,", decimals(2.0 * rim.radius_mm));
            words.push_back(fmt::format("(x {}, y {})", decimals(rim.centre_mm[0]), decimals(rim.centre_mm[1])));
        }
    return words;
}

/// A callout without its side.
struct Remark {
    Point place_mm{};
    Words words;
    std::vector<Badge> badges = {};
};

std::vector<Remark> hub_remarks(const Subject& subject) {
    const solid::HubOptions& hub = subject.part.options.hub;
    if (hub.kind == solid::HubKind::kOverhung) return {};  // in the section: hidden from above
    const double radius = mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance));
    std::vector<Remark> all{{on_circle(radius, 0.8 * core::kPi), bore_words(subject), bore_badges(subject)}};
    if (hub.lock == solid::HubLock::kKeyway) all.push_back({{solid::bore_reach_mm(hub), 0.0}, lock_words(subject), lock_badges(subject)});
    if (hub.lock == solid::HubLock::kDFlat)
        all.push_back({{radius - mm_from_m(hub.flat_depth), 0.0}, lock_words(subject), lock_badges(subject)});
    return all;
}

std::vector<Remark> cutter_remarks(const Subject& subject) {
    const solid::Part& part = subject.part;
    const solid::FeatureOptions& f = part.options.features;
    const Tolerances t = tolerances_of(subject);
    const std::vector<Badge> placed{frame(Symbol::kPosition, t.position, kDatumsAB)};
    std::vector<Remark> all;
    const std::vector<solid::Cutter> cutters = solid::make_cutters(part);
    bool dowels = false;  // both have one callout
    for (const solid::Cutter& cutter : cutters) {
        if (cutter.name == "dowel" && !std::exchange(dowels, true))
            all.push_back({cutter.outline.front().centre_mm,
                           dowel_words(part, cutters),
                           {frame(Symbol::kPosition, t.position, kDatumsAB, "\u00d8")}});
        if (cutter.name == "anchor")
            all.push_back({cutter.outline.front().centre_mm,
                           anchor_words(part, cutter),
                           {frame(Symbol::kPosition, t.position, kDatumsAB, "\u00d8")}});
        if (cutter.name == "leg_slot") all.push_back({on_circle(mm_from_m(f.leg_slot_radius), f.leg_slot_angle), slot_words(part), placed});
        if (cutter.name == "set_screw")
            all.push_back({{mm_from_m(0.5 * part.options.hub.boss_diameter), 0.0}, screw_words(cutter), lock_badges(subject)});
        if (cutter.name == "mark")
            all.push_back({cutter.outline.front().centre_mm, mark_words(part), t.mark_is_b ? lock_badges(subject) : placed});
    }
    return all;
}

std::vector<Remark> contour_remarks(const Subject& subject, const std::vector<Line>& edges) {
    const cam::Cam& cam = subject.part.cam;
    const Tolerances t = tolerances_of(subject);
    const std::vector<Badge> profile{frame(Symbol::kLineProfile, t.contour, kDatumsAB), roughness_badge(t, t.fine_roughness)};
    const auto at = [&cam](double psi, double offset) { return solid::parallel(cam, {psi, psi}, offset).front(); };
    const auto [low, high] = cam.working_psi;
    const Point far = farthest(edges);
    std::vector<Remark> all{{far,
                             {fmt::format("R {} at {} deg,", decimals(std::hypot(far[0], far[1])),
                                          decimals(core::deg_from_rad(core::within_turn(std::atan2(far[1], far[0]), 0.0)), 1)),
                              "farthest from the axis"}}};
    if (cam.has_roller()) {
        all.push_back({at(low + 0.5 * (high - low), 0.0), {"rim from P to Q:", "places on sheet 2"}, profile});
        return all;
    }
    const double inner = -0.5 * cam.options.cable_diameter;
    all.push_back({at(low + 0.35 * (high - low), 0.0), {"centreline of the cable", "on the working arc"}});
    all.push_back({at(low + 0.75 * (high - low), inner), {"floor from P to Q:", "places on sheet 2"}, profile});
    return all;
}

/// Callouts to the side of their targets; those nearest to the middle change sides if a column is too full.
void write_beside(Sheet& sheet, std::vector<Callout> all, double middle, const Columns& columns) {
    std::stable_sort(all.begin(), all.end(), [](const Callout& a, const Callout& b) { return a.target[0] < b.target[0]; });
    const auto is_right = std::find_if(all.begin(), all.end(), [middle](const Callout& c) { return c.target[0] >= middle; });
    std::vector<Callout> left(all.begin(), is_right), right(is_right, all.end());
    while (height_of(right) > columns.height.width() && height_of(left) + height_of({right.front()}) <= columns.height.width()) {
        left.push_back(std::move(right.front()));
        right.erase(right.begin());
    }
    while (height_of(left) > columns.height.width() && height_of(right) + height_of({left.back()}) <= columns.height.width()) {
        right.push_back(std::move(left.back()));
        left.pop_back();
    }
    write_callouts(sheet, std::move(left), Align::kRight, columns.left, columns.height);
    write_callouts(sheet, std::move(right), Align::kLeft, columns.right, columns.height);
}

}  // namespace

std::vector<Line> edges_from_above(const solid::Part& part) {
    std::vector<Line> edges = solid::slice(part.mesh, mm_from_m(part.z_high) - kUnderFace_mm);
    if (part.options.hub.boss_height <= 0.0) return edges;  // otherwise the lower flange is wider than the upper one
    std::vector<Line> lower = solid::slice(part.mesh, mm_from_m(part.z_low) + kUnderFace_mm);
    const auto width = [](const Line& line) { return extent({line}).high[0] - extent({line}).low[0]; };
    const auto widest = std::max_element(lower.begin(), lower.end(), [&](const Line& a, const Line& b) { return width(a) < width(b); });
    if (widest != lower.end()) edges.push_back(std::move(*widest));
    return edges;
}

void draw_front(Sheet& sheet, const Subject& subject, const std::vector<Line>& edges, const View& view, const Columns& columns) {
    const solid::Part& part = subject.part;
    for (const Line& edge : edges) stroke(sheet, view, Pen::kOutline, edge, true);
    draw_hidden(sheet, part, view);
    if (!part.cam.has_roller()) stroke(sheet, view, Pen::kCentre, solid::parallel(part.cam, part.cam.working_psi, 0.0), false);
    const Box box = extent(view.at(edges));
    draw_axes(sheet, box, view.origin);

    std::vector<Callout> all = draw_partner(sheet, subject, view, box);
    all.push_back(draw_turn(sheet, subject, view));
    for (const auto& remarks : {hub_remarks(subject), cutter_remarks(subject), contour_remarks(subject, edges)})
        for (const Remark& remark : remarks) all.push_back({view.at(remark.place_mm), remark.words, remark.badges});
    write_beside(sheet, std::move(all), view.origin[0], columns);
    name_cut(sheet, box, view.origin);

    const Point left_end = outermost(edges, 0, -1.0), right_end = outermost(edges, 0, 1.0), low_end = outermost(edges, 1, -1.0),
                top_end = outermost(edges, 1, 1.0);
    dimension_across(sheet, view.at(left_end), view.at(right_end), box.high[1] + kDimension, decimals(right_end[0] - left_end[0], 2));
    dimension_up(sheet, view.at(low_end), view.at(top_end), box.low[0] - kDimension - kCutEnd, decimals(top_end[1] - low_end[1], 2));
    draw_arc_ends(sheet, part, view);
}

}  // namespace fusee::drawing
