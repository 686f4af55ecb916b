#include "title.h"

#include <fmt/format.h>

#include <algorithm>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/solid/outline.h"
#include "view.h"

namespace fusee::drawing {

namespace {

constexpr double kLabel = 2.4;  // size of a field's name
constexpr double kFieldPad = 1.5;

const char* process_words(checks::ProcessKind kind) {
    switch (kind) {
        case checks::ProcessKind::kFdm:
            return "filament print (fdm)";
        case checks::ProcessKind::kSla:
            return "resin print (sla)";
        case checks::ProcessKind::kSls:
            return "powder print (sls)";
        case checks::ProcessKind::kMill:
            return "milled, 3 axes (mill)";
        case checks::ProcessKind::kMill4:
            return "milled, 4 axes (mill4)";
        case checks::ProcessKind::kEdm:
            return "wire-cut plates (edm)";
        case checks::ProcessKind::kLaser:
            return "laser-cut plates (laser)";
    }
    return "";
}

std::string part_words(const Subject& subject) {
    const cam::Cam& cam = subject.part.cam;
    const bool series = cam.kind == cam::PartKind::kSeries;
    return fmt::format("{}: {} of the {} spring", subject.name,
                       series             ? "spool"
                       : cam.has_roller() ? "roller cam"
                                          : "cam",
                       series ? "series" : "parallel");
}

/// A field of the title block: its name small above, its value below in the largest size that fits.
void field(Sheet& sheet, const Box& box, const std::string& name, const std::string& value, double size = Text::kBody) {
    sheet.strokes.push_back({Pen::kThin, {box.low, {box.high[0], box.low[1]}, box.high, {box.low[0], box.high[1]}}, true});
    sheet.texts.push_back({name, {box.low[0] + kFieldPad, box.low[1] + 3.0}, Align::kLeft, kLabel});
    const double space = box.high[0] - box.low[0] - 2.0 * kFieldPad, width = width_of(value, size);
    sheet.texts.push_back({value, {box.low[0] + kFieldPad, box.high[1] - 2.2}, Align::kLeft, width > space ? size * space / width : size});
}

/// A truncated cone from its side and, to the right, from its small end.
void draw_projection_symbol(Sheet& sheet, const Point& at) {
    const View view{at, 1.0};
    sheet.strokes.push_back({Pen::kOutline, view.at(Line{{-9.0, -1.5}, {-9.0, 1.5}, {-3.0, 3.0}, {-3.0, -3.0}}), true});
    for (const double radius : {1.5, 3.0})
        sheet.strokes.push_back({Pen::kOutline, view.at(solid::ring_of(solid::circle(radius, {4.5, 0.0}), 0.01)), true});
    sheet.strokes.push_back({Pen::kCentre, view.at(Line{{-10.5, 0.0}, {9.0, 0.0}})});
    sheet.strokes.push_back({Pen::kCentre, view.at(Line{{4.5, -4.2}, {4.5, 4.2}})});
}

}  // namespace

void draw_title(Sheet& sheet, const Subject& subject, double scale, std::size_t number, std::size_t count) {
    const Box& frame = Sheet::kFrame;
    sheet.strokes.push_back({Pen::kCut, {frame.low, {frame.high[0], frame.low[1]}, frame.high, {frame.low[0], frame.high[1]}}, true});
    const checks::ProcessLimits limits = checks::process_limits(subject.process);
    const double x = kTitleCorner[0], right = frame.high[0];
    double y = kTitleCorner[1];
    const auto row = [&y](double height) {
        const core::Range between{y, y + height};
        y = between.high;
        return between;
    };
    const auto [a0, a1] = row(12.0);
    field(sheet, {{x, a0}, {x + 70.0, a1}}, "design", subject.design, Text::kTitle);
    field(sheet, {{x + 70.0, a0}, {right, a1}}, "part", part_words(subject), Text::kTitle);
    const auto [b0, b1] = row(11.0);
    field(sheet, {{x, b0}, {x + 70.0, b1}}, "process", process_words(subject.process.kind));
    field(sheet, {{x + 70.0, b0}, {x + 125.0, b1}}, "general tolerance",
          fmt::format("\u00b1{} mm", decimals(core::mm_from_m(limits.tolerance))));
    field(sheet, {{x + 125.0, b0}, {right, b1}}, "mesh: chordal error", fmt::format("{} mm", decimals(subject.part.chordal_error_mm, 4)));
    const auto [c0, c1] = row(10.0);
    field(sheet, {{x, c0}, {x + 35.0, c1}}, "scale", scale_text(scale));
    field(sheet, {{x + 35.0, c0}, {x + 70.0, c1}}, "sheet", fmt::format("{} of {}", number, count));
    field(sheet, {{x + 70.0, c0}, {x + 100.0, c1}}, "format", "A3");
    field(sheet, {{x + 100.0, c0}, {x + 125.0, c1}}, "unit", "mm");
    field(sheet, {{x + 125.0, c0}, {right, c1}}, "projection", " ");
    draw_projection_symbol(sheet, {right - 14.0, 0.5 * (c0 + c1)});
    field(sheet, {{x, y}, {right, frame.high[1]}}, "made by", subject.provenance, Text::kSmall);
}

}  // namespace fusee::drawing
