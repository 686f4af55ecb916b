#include "body.h"

#include <algorithm>

namespace fusee::drawing {

namespace {

constexpr double kColumn = 50.0;   // of callouts, 24 letters wide
constexpr double kAside = 22.0;    // beside the body: a dimension, the cutting plane's end and space for leaders
constexpr double kHeading = 9.0;   // name of the section
constexpr double kBetween = 12.0;  // the views
constexpr double kBelow = 15.0;    // a dimension

/// Heights of the two views with their callouts, at a scale.
struct Heights {
    double section = 0.0, front = 0.0;
};

Heights heights_at(double scale, const Subject& subject, const std::vector<Line>& cut, const Box& front_mm) {
    const SectionCallouts callouts = section_callouts(subject, cut, {});
    const Box cut_mm = extent(cut);
    return {std::max({scale * (cut_mm.high[1] - cut_mm.low[1]) + 6.0, height_of(callouts.left), height_of(callouts.right)}),
            scale * (front_mm.high[1] - front_mm.low[1])};
}

}  // namespace

double draw_body(Sheet& sheet, const Subject& subject, const Box& area) {
    const std::vector<Line> edges = edges_from_above(subject.part), cut = axial_cut(subject.part);
    const Box front = extent(edges), section = extent(cut);
    const double width = area.high[0] - area.low[0] - 2.0 * (kColumn + kAside), height = area.high[1] - area.low[1];
    const double scale = largest_scale([&](double s) {
        const Heights h = heights_at(s, subject, cut, front);
        return s * (front.high[0] - front.low[0]) <= width && kHeading + h.section + kBetween + h.front + kBelow <= height;
    });
    const Heights h = heights_at(scale, subject, cut, front);
    const double spare = std::max(0.0, height - (kHeading + h.section + kBetween + h.front + kBelow));
    const double section_top = area.low[1] + kHeading, front_top = section_top + h.section + kBetween + 0.5 * spare;

    const double x = 0.5 * (area.low[0] + area.high[0]) - 0.5 * scale * (front.low[0] + front.high[0]);
    const double section_middle = section_top + 0.5 * h.section, front_middle = front_top + 0.5 * h.front;
    const View above{{x, section_middle + 0.5 * scale * (section.low[1] + section.high[1])}, scale};
    const View along{{x, front_middle + 0.5 * scale * (front.low[1] + front.high[1])}, scale};
    Columns columns{area.low[0] + kColumn, area.high[0] - kColumn, {section_top - 4.0, section_top + h.section + 4.0}};
    sheet.texts.push_back({"A-A", {x, area.low[1] + 4.0}, Align::kMiddle, Text::kTitle});
    draw_section(sheet, subject, cut, above, columns);
    columns.height = {columns.height.high + 2.0, area.high[1]};
    draw_front(sheet, subject, edges, along, columns);
    return scale;
}

}  // namespace fusee::drawing
