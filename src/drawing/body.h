#pragma once
#include <vector>

#include "fusee/drawing/drawing.h"
#include "marks.h"
#include "view.h"

/// The body in two views, first angle: along its axis seen from +z, and above that section A-A, cut along x and seen from below the sheet.
namespace fusee::drawing {

/// Columns of a view's callouts: texts end at `left` and begin at `right`.
struct Columns {
    double left = 0.0, right = 0.0;
    core::Range height;  ///< from the upper end to the lower one, on the sheet
};

/// Visible edges from +z [mm].
[[nodiscard]] std::vector<Line> edges_from_above(const solid::Part& part);
/// The cut through axis and timing mark, (x, z) [mm].
[[nodiscard]] std::vector<Line> axial_cut(const solid::Part& part);

void draw_front(Sheet& sheet, const Subject& subject, const std::vector<Line>& edges, const View& view, const Columns& columns);

struct SectionCallouts {
    std::vector<Callout> left, right;
};
[[nodiscard]] SectionCallouts section_callouts(const Subject& subject, const std::vector<Line>& cut, const View& view);
void draw_section(Sheet& sheet, const Subject& subject, const std::vector<Line>& cut, const View& view, const Columns& columns);

/// The part in space, beside them.
void draw_isometric(Sheet& sheet, const Subject& subject, const Box& area);

/// Both views with their callouts, as large as the area allows. @returns their scale
double draw_body(Sheet& sheet, const Subject& subject, const Box& area);

}  // namespace fusee::drawing
