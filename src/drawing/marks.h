#pragma once
#include <string>
#include <vector>

#include "badge.h"
#include "fusee/core/units.h"
#include "fusee/drawing/sheet.h"

/// Marks on a view: hatching, dimensions, callouts.
namespace fusee::drawing {

inline constexpr double kLineHeight = 4.4;    ///< of a line of text with its gap
inline constexpr double kCalloutGap = 1.8;    ///< between two callouts
inline constexpr double kTextOverLine = 1.2;  ///< of a baseline over the line it stands on

/// Thin lines at 45 degrees over the area within closed polygons (even-odd).
void hatch(Sheet& sheet, const std::vector<Line>& rings);

/// A leader's target with its text, and the symbols below it.
struct Callout {
    Point target{};  ///< on the sheet
    std::vector<std::string> lines;
    std::vector<Badge> badges = {};
};
/// Height of a column of callouts [mm].
[[nodiscard]] double height_of(const std::vector<Callout>& callouts);
/// Writes callouts below one another beside a view, in the order of their targets, so that leaders do not cross. Each is as near to its
/// target's height as possible.
/// @param side kLeft: texts begin at x; kRight: they end there
/// @param height from the column's upper end to its lower one
void write_callouts(Sheet& sheet, std::vector<Callout> callouts, Align side, double x, const core::Range& height);

/// Sentences from the upper edge of an area on, in lines as long as it is wide.
void write_notes(Sheet& sheet, const std::vector<std::string>& notes, const Box& area);

/// Dimension line at height y between two points' x; the value is on it if there is space, otherwise beside it.
void dimension_across(Sheet& sheet, const Point& a, const Point& b, double y, const std::string& words);
/// The same at x between two points' heights, `low` the lower one on the sheet.
void dimension_up(Sheet& sheet, const Point& low, const Point& high, double x, const std::string& words);

}  // namespace fusee::drawing
