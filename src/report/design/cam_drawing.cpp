#include "design/cam_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "design/markers.h"
#include "fusee/core/units.h"
#include "fusee/solid/slice.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using core::mm_from_m;
using Point = std::array<double, 2>;
using Line = std::vector<Point>;

// Below the top face, less deep than any timing mark, and at no height of mesh vertices.
constexpr double kUnderTop_mm = 0.0137;

/// SVG's y points down, the body's up.
std::string path_data(const Line& line, bool closed) {
    std::string out;
    for (const Point& p : line) out += (out.empty() ? "M" : "L") + coordinate(p[0]) + " " + coordinate(-p[1]);
    return closed && !out.empty() ? out + "Z" : out;
}

std::string path_element(const char* css, const std::string& data) { return fmt::format("<path class=\"{}\" d=\"{}\"/>", css, data); }

std::string rings(const std::vector<Line>& lines) {
    std::string data;
    for (const Line& ring : lines) data += path_data(ring, true);
    return data;
}

/// The square sheet around the drawing. Text and marks scale with it.
struct Sheet {
    Point centre{};
    double reach = 0.0;                                         ///< of the drawing, from the centre [mm]
    [[nodiscard]] double half() const { return 1.36 * reach; }  // space for markers and cables
    [[nodiscard]] double unit() const { return half() / 50.0; }
};

Sheet sheet_around(const std::vector<Line>& lines) {
    Point low{}, high{};  // the axis is always on the sheet
    for (const Line& line : lines)
        for (const Point& p : line)
            for (std::size_t i = 0; i < 2; ++i) {
                low[i] = std::min(low[i], p[i]);
                high[i] = std::max(high[i], p[i]);
            }
    Sheet sheet{{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])}};
    for (const Line& line : lines)
        for (const Point& p : line) sheet.reach = std::max(sheet.reach, std::hypot(p[0] - sheet.centre[0], p[1] - sheet.centre[1]));
    return sheet;
}

/// The cable at one end of the law, from its contact outwards: the torque of its tension about +z has the sign torque_sign.
std::string cable(const cam::Cam& cam, const cam::Contact& contact, const Sheet& sheet, const char* css, const std::string& name) {
    const double x = mm_from_m(contact.path.x()), y = -mm_from_m(contact.path.y()), u = sheet.unit();
    const double tx = -std::sin(contact.path.psi) * cam.options.torque_sign, ty = -std::cos(contact.path.psi) * cam.options.torque_sign;
    const double length = 26 * u, end_x = x + length * tx, end_y = y + length * ty;
    return fmt::format(
        "<g class=\"{}\"><path d=\"M{} {}L{} {}\"/><circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>"
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"middle\">{}</text></g>",
        css, coordinate(x), coordinate(y), coordinate(end_x), coordinate(end_y), coordinate(x), coordinate(y), coordinate(0.8 * u),
        coordinate(end_x), coordinate(end_y + (ty < 0 ? -1.2 * u : 3.2 * u)), coordinate(2.6 * u), escape(name));
}

/// The roller at one end of the law.
std::string roller(const cam::Cam& cam, const cam::Contact& contact, const Sheet& sheet, const char* css, const std::string& name) {
    const double radius = mm_from_m(cam.options.roller.radius), size = 2.6 * sheet.unit();
    const double x = mm_from_m(contact.path.x()) + radius * std::cos(contact.path.psi),
                 y = -mm_from_m(contact.path.y()) - radius * std::sin(contact.path.psi);
    return fmt::format(
        "<g class=\"{0}\"><path d=\"M{1} {2}a{3} {3} 0 1 0 {4} 0a{3} {3} 0 1 0 {5} 0\"/>"
        "<text x=\"{6}\" y=\"{7}\" font-size=\"{8}\" text-anchor=\"middle\">{9}</text></g>",
        css, coordinate(x - radius), coordinate(y), coordinate(radius), coordinate(2.0 * radius), coordinate(-2.0 * radius), coordinate(x),
        coordinate(y + 0.35 * size), coordinate(size), escape(name));
}

std::string scale_bar(const Sheet& sheet) {
    const double want = 0.4 * sheet.half(), power = std::pow(10.0, std::floor(std::log10(want))), u = sheet.unit();
    const double length = want >= 5 * power ? 5 * power : want >= 2 * power ? 2 * power : power;
    const double x = sheet.centre[0] - sheet.half() + 3 * u, y = -sheet.centre[1] + sheet.half() - 3 * u;
    return fmt::format("<g class=\"scale\"><path d=\"M{} {}v{}h{}v{}\"/><text x=\"{}\" y=\"{}\" font-size=\"{}\">{:g} mm</text></g>",
                       coordinate(x), coordinate(y - 1.5 * u), coordinate(1.5 * u), coordinate(length), coordinate(-1.5 * u),
                       coordinate(x + length + 1.5 * u), coordinate(y), coordinate(2.8 * u), length);
}

std::string axis(const Sheet& sheet) {
    const double u = sheet.unit();
    return fmt::format(
        "<g class=\"axis\"><path d=\"M{0} 0H{1}M0 {0}V{2}\"/><text x=\"{3}\" y=\"{4}\" font-size=\"{5}\">x</text>"
        "<text x=\"{4}\" y=\"{6}\" font-size=\"{5}\">y</text></g>",
        coordinate(-2 * u), coordinate(7 * u), coordinate(-7 * u), coordinate(7.4 * u), coordinate(0.8 * u), coordinate(2.4 * u),
        coordinate(-7.4 * u));
}

}  // namespace

std::string cam_svg(const solid::Part& part, const std::vector<Marker>& markers) {
    const cam::Cam& cam = part.cam;
    const double d = cam.options.cable_diameter;
    const Line pitch = solid::parallel(cam, cam.groove_psi, 0.0);
    const std::vector<Line> body = solid::slice(part.mesh, mm_from_m(part.z_high) - kUnderTop_mm);
    const double boss_mm = mm_from_m(part.options.hub.boss_height);
    const std::vector<Line> boss = boss_mm > 0.0 ? solid::slice(part.mesh, mm_from_m(part.z_low) - 0.487 * boss_mm) : std::vector<Line>{};
    std::vector<Line> all = body;
    all.insert(all.end(), boss.begin(), boss.end());
    all.push_back(pitch);
    if (cam.has_roller()) all.push_back(solid::parallel(cam, cam.working_psi, 2.0 * cam.options.roller.radius));
    const Sheet sheet = sheet_around(all);

    std::string out = fmt::format(
        "<svg class=\"cam {0}\" width=\"{1}mm\" height=\"{1}mm\" viewBox=\"{2} {3} {1} {1}\" role=\"group\" "
        "aria-label=\"{0} to scale, with the places of its findings\">",
        cam::to_string(cam.kind), coordinate(2 * sheet.half()), coordinate(sheet.centre[0] - sheet.half()),
        coordinate(-sheet.centre[1] - sheet.half()));
    out += path_element("body", rings(body)) + path_element("boss", rings(boss));
    out += path_element("floor", path_data(solid::parallel(cam, cam.groove_psi, -0.5 * d), cam.closed()));
    out += path_element("pitch", path_data(pitch, cam.closed()));
    out += path_element("working", path_data(solid::parallel(cam, cam.working_psi, 0.0), false));
    out += axis(sheet);
    const auto touching = cam.has_roller() ? roller : cable;
    out += touching(cam, cam.working.front(), sheet, "cable", fmt::format("{:.3g} Nm", cam.working.front().arm.tau));
    out += touching(cam, cam.working.back(), sheet, "cable end", fmt::format("{:.3g} Nm", cam.working.back().arm.tau));
    out += markers_svg(markers, sheet.centre, sheet.reach + 6.5 * sheet.unit(), 2.1 * sheet.unit());
    return out + scale_bar(sheet) + "</svg>\n";
}

}  // namespace fusee::report
