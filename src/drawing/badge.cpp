#include "badge.h"

#include <cmath>

#include "fusee/core/units.h"
#include "view.h"

namespace fusee::drawing {

namespace {

constexpr double kSymbolCell = 6.8;  // a tolerance's symbol, a datum's triangle, the sign of a roughness or of an edge
constexpr double kCellPad = 1.4;     // beside a cell's text
constexpr double kMiddle = 0.5 * kBadgeHeight;
constexpr double kTriangle = 2.6, kStem = 1.6;  // of a datum, above its box

bool is_framed(Symbol symbol) { return symbol < Symbol::kDatum; }

/// Class of a symbol's strokes in the SVG.
const char* role_of(Symbol symbol) {
    switch (symbol) {
        case Symbol::kLineProfile:
            return "line-profile";
        case Symbol::kPosition:
            return "position";
        case Symbol::kPerpendicular:
            return "perpendicularity";
        case Symbol::kRunout:
            return "run-out";
        case Symbol::kDatum:
            return "datum";
        case Symbol::kRoughness:
        case Symbol::kRoughnessCut:
            return "roughness";
        case Symbol::kEdge:
            return "edge-state";
    }
    return "";
}

Line arc(const Point& centre, double radius, double from, double to) {
    Line line;
    for (int i = 0; i <= 24; ++i) {
        const double angle = from + (to - from) * i / 24.0;
        line.push_back({centre[0] + radius * std::cos(angle), centre[1] - radius * std::sin(angle)});
    }
    return line;
}

/// Lines of the symbol about the middle of its cell, y downwards.
std::vector<Line> lines_of(Symbol symbol) {
    switch (symbol) {
        case Symbol::kLineProfile:
            return {arc({0.0, 1.2}, 2.2, 0.0, core::kPi)};
        case Symbol::kPosition:
            return {arc({0.0, 0.0}, 1.3, 0.0, core::kTurn), {{-2.2, 0.0}, {2.2, 0.0}}, {{0.0, -2.2}, {0.0, 2.2}}};
        case Symbol::kPerpendicular:
            return {{{-2.2, 1.9}, {2.2, 1.9}}, {{0.0, 1.9}, {0.0, -2.0}}};
        case Symbol::kRunout:
            return {{{-1.8, 1.8}, {1.8, -1.8}}};
        case Symbol::kDatum:
            return {};
        case Symbol::kRoughness:
            return {{{-2.9, -0.2}, {-1.3, 2.6}, {1.9, -2.9}, {3.4, -2.9}}};
        case Symbol::kRoughnessCut:
            return {{{-2.9, -0.2}, {-1.3, 2.6}, {1.9, -2.9}, {3.4, -2.9}}, {{-2.9, -0.2}, {0.3, -0.2}}};
        case Symbol::kEdge:
            return {{{-1.2, -2.4}, {-1.2, 2.4}, {3.2, 2.4}}};
    }
    return {};
}

void box(Sheet& sheet, double left, double right, double top, const char* role) {
    sheet.strokes.push_back({Pen::kThin, {{left, top}, {right, top}, {right, top + kBadgeHeight}, {left, top + kBadgeHeight}}, true, role});
}

/// Triangle, stem and box below one another, the letter in the box.
void draw_datum(Sheet& sheet, const std::string& letter, const Point& corner) {
    const double width = width_of(letter, Text::kBody) + 2.0 * kCellPad, x = corner[0] + 0.5 * width, top = corner[1];
    const double apex = top + kTriangle, foot = apex + kStem;
    sheet.strokes.push_back({Pen::kThin, {{x - 1.5, top}, {x + 1.5, top}, {x, apex}}, true, "datum"});
    sheet.strokes.push_back({Pen::kThin, {{x, apex}, {x, foot}}, false, "datum"});
    box(sheet, corner[0], corner[0] + width, foot, "datum");
    sheet.texts.push_back({letter, {corner[0] + kCellPad, foot + kMiddle + 0.37 * Text::kBody}});
}

}  // namespace

Badge frame(Symbol symbol, double width, const std::vector<std::string>& datums, const std::string& prefix) {
    Badge badge{symbol, {prefix + decimals(core::mm_from_m(width))}};
    badge.cells.insert(badge.cells.end(), datums.begin(), datums.end());
    return badge;
}

double height_of(const Badge& badge) { return kBadgeHeight + (badge.symbol == Symbol::kDatum ? kTriangle + kStem : 0.0); }

double width_of(const Badge& badge) {
    double width = badge.symbol == Symbol::kDatum ? 0.0 : kSymbolCell;
    for (const std::string& cell : badge.cells) width += width_of(cell, Text::kBody) + 2.0 * kCellPad;
    return width;
}

void draw_badge(Sheet& sheet, const Badge& badge, const Point& corner) {
    if (badge.symbol == Symbol::kDatum) return draw_datum(sheet, badge.cells.front(), corner);
    const auto [left, top] = corner;
    const char* role = role_of(badge.symbol);
    for (Line& line : lines_of(badge.symbol)) {
        for (Point& p : line) p = {left + 0.5 * kSymbolCell + p[0], top + kMiddle + p[1]};
        if (badge.symbol == Symbol::kRunout) sheet.arrows.push_back({line.back(), -0.25 * core::kPi});
        sheet.strokes.push_back({Pen::kThin, std::move(line), false, role});
    }
    const bool framed = is_framed(badge.symbol);
    if (framed) box(sheet, left, left + kSymbolCell, top, role);
    double x = left + kSymbolCell;
    for (const std::string& cell : badge.cells) {
        const double width = width_of(cell, Text::kBody) + 2.0 * kCellPad;
        sheet.texts.push_back({cell, {x + kCellPad, top + kMiddle + 0.37 * Text::kBody}});
        if (framed) box(sheet, x, x + width, top, role);
        x += width;
    }
}

}  // namespace fusee::drawing
