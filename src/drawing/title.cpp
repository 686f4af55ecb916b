#include "title.h"

#include <fmt/format.h>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/solid/outline.h"
#include "tolerances.h"
#include "view.h"
#include "words.h"

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
    const char* body = series ? "spool" : cam.has_roller() ? "roller cam" : "cam";
    if (pulls_back(subject)) return fmt::format("{} of one spring, way back", body);
    if (is_of_spring(subject)) return fmt::format("{} of one spring", body);
    return fmt::format("{}: {} of the {} spring", subject.name, body, series ? "series" : "parallel");
}

/// A field of the title block: its name small above, its value below in the largest size that fits.
void field(Sheet& sheet, const Box& box, const std::string& name, const std::string& value, double size) {
    sheet.strokes.push_back({Pen::kThin, {box.low, {box.high[0], box.low[1]}, box.high, {box.low[0], box.high[1]}}, true});
    sheet.texts.push_back({name, {box.low[0] + kFieldPad, box.low[1] + 3.0}, Align::kLeft, kLabel});
    if (value.empty()) return;
    const double space = box.high[0] - box.low[0] - 2.0 * kFieldPad, width = width_of(value, size);
    sheet.texts.push_back({value, {box.low[0] + kFieldPad, box.high[1] - 2.2}, Align::kLeft, width > space ? size * space / width : size});
}

/// One field: its width, name and value.
struct Field {
    double width;
    std::string name, value;
    double size = Text::kBody;
};

/// Rows of fields, one below the other.
class Block {
public:
    explicit Block(Sheet& sheet) : sheet_(sheet), y_(kTitleCorner[1]) {}

    /// @returns its upper and lower edge
    core::Range row(double height, const std::vector<Field>& fields) {
        double x = kTitleCorner[0];
        for (const Field& f : fields) {
            field(sheet_, {{x, y_}, {x + f.width, y_ + height}}, f.name, f.value, f.size);
            x += f.width;
        }
        y_ += height;
        return {y_ - height, y_};
    }

private:
    Sheet& sheet_;
    double y_;
};

/// A truncated cone from its side and, to the right, from its small end.
void draw_projection_symbol(Sheet& sheet, const Point& at) {
    const View view{at, 1.0};
    sheet.strokes.push_back({Pen::kOutline, view.at(Line{{-9.0, -1.3}, {-9.0, 1.3}, {-3.0, 2.6}, {-3.0, -2.6}}), true});
    for (const double radius : {1.3, 2.6})
        sheet.strokes.push_back({Pen::kOutline, view.at(solid::ring_of(solid::circle(radius, {4.5, 0.0}), 0.01)), true});
    sheet.strokes.push_back({Pen::kCentre, view.at(Line{{-10.5, 0.0}, {9.0, 0.0}})});
    sheet.strokes.push_back({Pen::kCentre, view.at(Line{{4.5, -3.6}, {4.5, 3.6}})});
}

}  // namespace

Titled title_of(const Subject& subject) { return {part_words(subject), subject.part.chordal_error_mm}; }

void draw_title(Sheet& sheet, const Subject& subject, const Titled& body, double scale, std::size_t number, std::size_t count) {
    const Box& frame = Sheet::kFrame;
    sheet.strokes.push_back({Pen::kCut, {frame.low, {frame.high[0], frame.low[1]}, frame.high, {frame.low[0], frame.high[1]}}, true});
    const Tolerances t = tolerances_of(subject);
    const TitleOptions& title = subject.title;
    const std::string ident = title.number.empty() ? "" : title.number + "-" + subject.name;
    Block block(sheet);
    block.row(10.6, {{70.0, "legal owner", title.owner}, {110.0, "title", body.title, Text::kTitle}});
    block.row(9.3, {{70.0, "identification number", ident},
                    {18.0, "revision", title.revision},
                    {36.0, "date of issue", title.date},
                    {20.0, "sheet", fmt::format("{}/{}", number, count)},
                    {36.0, "document type", "part drawing"}});
    block.row(9.3, {{70.0, "created by", title.created_by}, {54.0, "approved by", title.approved_by}, {56.0, "design", subject.design}});
    block.row(9.3, {{106.0, "material", checks::designation_of(subject.process)}, {74.0, "process", process_words(subject.process.kind)}});
    const auto [top, bottom] = block.row(9.3, {{64.0, "general tolerance", t.general},
                                               {36.0, "mesh: chordal error", fmt::format("{} mm", decimals(body.chordal_mm, 4))},
                                               {18.0, "scale", scale_text(scale)},
                                               {12.0, "size", "A3"},
                                               {14.0, "unit", "mm"},
                                               {36.0, "projection", ""}});
    draw_projection_symbol(sheet, {frame.high[0] - 11.0, 0.5 * (top + bottom) + 1.2});
    block.row(frame.high[1] - bottom, {{180.0, "made by", subject.provenance, Text::kSmall}});
}

void draw_general_marks(Sheet& sheet, const Subject& subject) {
    const Tolerances t = tolerances_of(subject);
    const double edge = core::mm_from_m(t.edge), y = kTitleCorner[1] - kBadgeHeight - 2.0;
    double x = kTitleCorner[0] + 1.0;
    for (const Badge& badge : {roughness_badge(t, t.roughness), Badge{Symbol::kEdge, {fmt::format("-{} outer", decimals(edge))}},
                               Badge{Symbol::kEdge, {fmt::format("+{} inner, ISO 13715", decimals(edge))}}}) {
        draw_badge(sheet, badge, {x, y});
        x += width_of(badge) + 3.0;
    }
}

}  // namespace fusee::drawing
