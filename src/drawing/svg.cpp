#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

#include "fusee/core/file.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/drawing/sheet.h"
#include "look.h"

namespace fusee::drawing {

namespace {

using core::coordinate;

/// The classes of all pens, and the fonts.
std::string style() {
    std::string css = "path{fill:none;stroke:#000;stroke-linejoin:round}";
    for (const PenLook& pen : kPens) {
        css += fmt::format(".{}{{stroke-width:{}", pen.name, pen.width_mm);
        const auto dashes = std::span(pen.dashes_mm).first(static_cast<std::size_t>(pen.dashes));
        if (!dashes.empty()) css += fmt::format(";stroke-dasharray:{}", fmt::join(dashes, " "));
        css += '}';
    }
    return css + fmt::format(".arrow{{fill:#000;stroke:none}}text{{font-family:'{}';white-space:pre}}", fmt::join(kFonts, "','"));
}

std::string stroke_element(const Stroke& stroke) {
    std::string data;
    for (const Point& p : stroke.line) data += (data.empty() ? "M" : "L") + coordinate(p[0]) + " " + coordinate(p[1]);
    const char* gap = *stroke.role == '\0' ? "" : " ";
    return fmt::format("<path class=\"{}{}{}\" d=\"{}{}\"/>\n", kPens[static_cast<std::size_t>(stroke.pen)].name, gap, stroke.role, data,
                       stroke.closed ? "Z" : "");
}

std::string arrow_element(const Arrow& arrow) {
    return fmt::format("<path class=\"arrow\" transform=\"translate({} {}) rotate({})\" d=\"M0 0L{} {}V{}Z\"/>\n", coordinate(arrow.tip[0]),
                       coordinate(arrow.tip[1]), coordinate(core::deg_from_rad(arrow.towards)), -kArrowLength, kArrowHalfWidth,
                       -kArrowHalfWidth);
}

std::string text_element(const Text& text) {
    const char* anchor = text.align == Align::kLeft ? "start" : text.align == Align::kMiddle ? "middle" : "end";
    const std::string x = coordinate(text.at[0]), y = coordinate(text.at[1]);
    return fmt::format("<text x=\"{0}\" y=\"{1}\" font-size=\"{2}\" text-anchor=\"{3}\"{4}>{5}</text>\n", x, y, coordinate(text.size),
                       anchor, text.upright ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "", core::escape(text.words));
}

}  // namespace

std::string svg(const Sheet& sheet) {
    std::string out = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}mm\" "
        "height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n<style>{3}</style>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        Sheet::kWidth, Sheet::kHeight, core::escape(sheet.title), style());
    for (const Stroke& stroke : sheet.strokes) out += stroke_element(stroke);
    for (const Arrow& arrow : sheet.arrows) out += arrow_element(arrow);
    for (const Text& text : sheet.texts) out += text_element(text);
    return out + "</svg>\n";
}

std::vector<std::filesystem::path> write_svg(const std::filesystem::path& base, const std::vector<Sheet>& sheets) {
    std::vector<std::filesystem::path> written;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        std::filesystem::path path = base;
        path += i == 0 ? ".svg" : fmt::format("_{}.svg", i + 1);
        core::write_file(path, svg(sheets[i]));
        written.push_back(std::move(path));
    }
    return written;
}

}  // namespace fusee::drawing
