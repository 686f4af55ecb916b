#include "marks.h"

#include <algorithm>
#include <cmath>

namespace fusee::drawing {

namespace {

constexpr double kHatchGap = 2.2;   // between lines, along an axis
constexpr double kLeaderGap = 1.2;  // from a text to its leader
constexpr double kExtensionGap = 0.8, kExtensionOver = 1.6;
constexpr double kSpaceForArrows = 9.0;  // shorter: arrows are outside
constexpr double kOutside = 6.0;         // length of line behind an outer arrow

/// Crossings of the line x + y = c with the rings, by rising x.
std::vector<Point> crossings(const std::vector<Line>& rings, double c) {
    std::vector<Point> found;
    for (const Line& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            const double u = a[0] + a[1] - c, v = b[0] + b[1] - c;
            if ((u < 0.0) == (v < 0.0)) continue;
            const double share = u / (u - v);
            found.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
        }
    std::sort(found.begin(), found.end());
    return found;
}

constexpr double kBadgeGap = 0.8;  // between a callout's texts and symbols
constexpr double kShelf = 30.0;    // line under a size, at the end of its leader, on which a datum stands

double block_height(const Callout& callout) {
    double height = kLineHeight * static_cast<double>(callout.lines.size());
    for (const Badge& badge : callout.badges) height += height_of(badge) + kBadgeGap;
    return height;
}

/// Upper ends of the callouts' blocks: near their targets, moved down until they do not overlap and up until they fit.
std::vector<double> stacked(const std::vector<Callout>& callouts, const core::Range& height) {
    std::vector<double> tops;
    double free = height.low;
    for (const Callout& callout : callouts) {
        tops.push_back(std::max(free, callout.target[1] - 0.5 * block_height(callout)));
        free = tops.back() + block_height(callout) + kCalloutGap;
    }
    double end = height.high;
    for (std::size_t i = callouts.size(); i-- > 0;) {
        tops[i] = std::min(tops[i], end - block_height(callouts[i]));
        end = tops[i] - kCalloutGap;
    }
    return tops;
}

void arrow(Sheet& sheet, const Point& from, const Point& tip) {
    sheet.arrows.push_back({tip, std::atan2(tip[1] - from[1], tip[0] - from[0])});
}

/// A dimension's line with its arrows along one axis (0: across, 1: up) at `level` of the other; it continues below a value
/// that is not between its ends.
void dimension_line(Sheet& sheet, std::size_t axis, const core::Range& ends, double level, const Box& value) {
    const auto at = [axis, level](double along) {
        Point p{level, level};
        p[axis] = along;
        return p;
    };
    const bool inside = ends.width() >= kSpaceForArrows;
    const double reach = inside ? 0.0 : kOutside;
    const bool beside = value.high[axis] < ends.low || value.low[axis] > ends.high;
    const core::Range line{std::min(ends.low - reach, beside ? value.low[axis] : ends.low),
                           std::max(ends.high + reach, beside ? value.high[axis] : ends.high)};
    sheet.strokes.push_back({Pen::kThin, {at(line.low), at(line.high)}});
    arrow(sheet, at(inside ? ends.high : line.low), at(ends.low));
    arrow(sheet, at(inside ? ends.low : line.high), at(ends.high));
}

void extension_line(Sheet& sheet, const Point& from, const Point& to) {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const Point way{(to[0] - from[0]) / length, (to[1] - from[1]) / length};
    sheet.strokes.push_back({Pen::kThin,
                             {{from[0] + kExtensionGap * way[0], from[1] + kExtensionGap * way[1]},
                              {to[0] + kExtensionOver * way[0], to[1] + kExtensionOver * way[1]}}});
}

}  // namespace

void hatch(Sheet& sheet, const std::vector<Line>& rings) {
    double low = 1e9, high = -1e9;
    for (const Line& ring : rings)
        for (const Point& p : ring) low = std::min(low, p[0] + p[1]), high = std::max(high, p[0] + p[1]);
    for (double c = std::ceil(low / kHatchGap) * kHatchGap; c < high; c += kHatchGap) {
        const std::vector<Point> ends = crossings(rings, c);
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) sheet.strokes.push_back({Pen::kThin, {ends[i], ends[i + 1]}});
    }
}

double height_of(const std::vector<Callout>& callouts) {
    double height = 0.0;
    for (const Callout& callout : callouts) height += block_height(callout) + kCalloutGap;
    return height;
}

void write_callouts(Sheet& sheet, std::vector<Callout> callouts, Align side, double x, const core::Range& height) {
    const auto higher = [](const Callout& a, const Callout& b) { return a.target[1] < b.target[1]; };
    std::stable_sort(callouts.begin(), callouts.end(), higher);
    const std::vector<double> tops = stacked(callouts, height);
    for (std::size_t i = 0; i < callouts.size(); ++i) {
        const Callout& callout = callouts[i];
        for (std::size_t k = 0; k < callout.lines.size(); ++k)
            sheet.texts.push_back({callout.lines[k], {x, tops[i] + kLineHeight * (static_cast<double>(k) + 0.77)}, side});
        const double shelf = tops[i] + kLineHeight * static_cast<double>(callout.lines.size());
        double below = shelf + kBadgeGap;
        for (const Badge& badge : callout.badges) {
            if (badge.symbol == Symbol::kDatum) below -= kBadgeGap;  // on the frame or shelf above it
            draw_badge(sheet, badge, {side == Align::kLeft ? x : x - width_of(badge), below});
            below += height_of(badge) + kBadgeGap;
        }
        const bool on_shelf = !callout.badges.empty() && callout.badges.front().symbol == Symbol::kDatum;
        const Point from{x + (side == Align::kLeft ? -kLeaderGap : kLeaderGap), on_shelf ? shelf : tops[i] + 0.5 * block_height(callout)};
        if (on_shelf) sheet.strokes.push_back({Pen::kThin, {from, {from[0] + (side == Align::kLeft ? 1.0 : -1.0) * kShelf, shelf}}});
        sheet.strokes.push_back({Pen::kThin, {from, callout.target}});
        arrow(sheet, from, callout.target);
    }
}

void dimension_across(Sheet& sheet, const Point& a, const Point& b, double y, const std::string& words) {
    const core::Range ends{std::min(a[0], b[0]), std::max(a[0], b[0])};
    const double over = y - kTextOverLine;
    for (const Point& end : {a, b}) extension_line(sheet, end, {end[0], y});
    std::vector<Text> candidates{{words, {ends.high + kOutside + 1.0, over}}, {words, {ends.low - kOutside - 1.0, over}, Align::kRight}};
    if (width_of(words, Text::kBody) + 2.0 < ends.width())
        candidates.insert(candidates.begin(), {words, {ends.low + 0.5 * ends.width(), over}, Align::kMiddle});
    sheet.write_clear(candidates);
    dimension_line(sheet, 0, ends, y, box_of(sheet.texts.back()));
}

void dimension_up(Sheet& sheet, const Point& low, const Point& high, double x, const std::string& words) {
    for (const Point& end : {low, high}) extension_line(sheet, end, {x, end[1]});
    const core::Range ends{high[1], low[1]};
    const double width = width_of(words, Text::kBody), left = x - kTextOverLine;
    std::vector<Text> candidates;
    for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8})
        if (2.0 * std::min(share, 1.0 - share) * ends.width() > width + 1.0)
            candidates.push_back({words, {left, ends.low + share * ends.width()}, Align::kMiddle, Text::kBody, true});
    candidates.push_back({words, {left, ends.low - kOutside - 1.0}, Align::kLeft, Text::kBody, true});
    candidates.push_back({words, {left, ends.high + kOutside + 1.0}, Align::kRight, Text::kBody, true});
    sheet.write_clear(candidates);
    dimension_line(sheet, 1, ends, x, box_of(sheet.texts.back()));
}

}  // namespace fusee::drawing
