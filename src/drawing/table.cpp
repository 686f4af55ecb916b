#include "table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/drawing/inspection.h"
#include "view.h"

namespace fusee::drawing {

namespace {

constexpr double kRow = 4.2, kColumnGap = 2.0, kPad = 1.0;
constexpr double kStep_deg = 10.0;
constexpr std::size_t kTorqueRows = 25;

using Cells = std::vector<std::string>;

double letters_width(const std::string& words) { return width_of(words, Text::kSmall); }

/// Width of every column.
std::vector<double> widths_of(const Table& table) {
    std::vector<double> widths(table.head.front().size(), 0.0);
    for (const auto* rows : {&table.head, &table.rows})
        for (const Cells& row : *rows)
            for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters_width(row[i]));
    return widths;
}

void write_row(Sheet& sheet, const Cells& row, const std::vector<double>& widths, double x, double y) {
    double right = x + kPad;
    for (std::size_t i = 0; i < row.size(); ++i) {
        right += widths[i] + (i > 0 ? kColumnGap : 0.0);
        if (!row[i].empty()) sheet.texts.push_back({row[i], {right, y}, Align::kRight, Text::kSmall});
    }
}

}  // namespace

double Table::width() const {
    const std::vector<double> widths = widths_of(*this);
    double width = 2.0 * kPad + kColumnGap * static_cast<double>(widths.size() - 1);
    for (const double w : widths) width += w;
    for (const std::string& line : title) width = std::max(width, letters_width(line));
    return width;
}

std::size_t write_table(Sheet& sheet, const Table& table, std::size_t first, const Point& corner, double bottom) {
    const std::vector<double> widths = widths_of(table);
    const double x = corner[0], width = table.width();
    double y = corner[1];
    const auto rule = [&](double at) { sheet.strokes.push_back({Pen::kThin, {{x, at}, {x + width, at}}}); };
    for (const std::string& line : table.title) sheet.texts.push_back({line, {x, y += kRow}, Align::kLeft, Text::kSmall});
    rule(y + 1.4);
    y += 1.0;
    for (const Cells& row : table.head) write_row(sheet, row, widths, x, y += kRow);
    rule(y + 1.4);
    y += 1.0;
    std::size_t i = first;
    for (; i < table.rows.size() && y + kRow + 1.4 <= bottom; ++i) write_row(sheet, table.rows[i], widths, x, y += kRow);
    rule(y + 1.4);
    return i;
}

Table check_table(const solid::Part& part) {
    const bool is_helix = !part.cam.closed(), roller = part.cam.has_roller();
    Table table{{roller ? "Check rows: the rim from P to Q at equal distances" : "Check rows: the floor from P to Q at equal distances"},
                {{"row", "length", "angle", "X", "Y"}, {"", "[mm]", "[deg]", "[mm]", "[mm]"}},
                {}};
    if (is_helix) table.head[0].emplace_back("Z"), table.head[1].emplace_back("[mm]");
    for (const char* name : {"radius", "normal", "tilt", "arm"}) table.head[0].emplace_back(name);
    for (const char* unit : {"[mm]", "[deg]", "[deg]", "[mm]"}) table.head[1].emplace_back(unit);
    if (!roller) table.head[0].emplace_back("d arm/d r"), table.head[1].emplace_back("");
    int number = 0;
    for (const CheckRow& at : check_rows(part)) {
        const auto mm = [](double value) { return fmt::format("{:.3f}", core::mm_from_m(value)); };
        const auto deg = [](double value) { return fmt::format("{:.2f}", core::deg_from_rad(value)); };
        const auto turned = [&](double angle) { return deg(part.cam.closed() ? core::within_turn(angle, 0.0) : angle); };
        Cells row{fmt::format("{}", ++number), fmt::format("{:.2f}", core::mm_from_m(at.length)), turned(at.angle), mm(at.x), mm(at.y)};
        if (is_helix) row.push_back(mm(at.z));
        for (const std::string& cell : {mm(at.radius), turned(at.normal), deg(at.tilt()), mm(at.arm)}) row.push_back(cell);
        if (!roller) row.push_back(fmt::format("{:.3f}", std::cos(at.tilt())));
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table inspection_table(const solid::Part& part) {
    const bool is_helix = !part.cam.closed();
    Table table{{part.cam.has_roller() ? "Radii of the rim" : "Radii of the floor"}, {{"angle", "radius"}, {"[deg]", "[mm]"}}, {}};
    if (is_helix) {
        table.head[0].emplace_back("z");
        table.head[1].emplace_back("[mm]");
    }
    for (Cells& row : table.head) row.emplace_back();
    for (const FloorPoint& p : inspect_floor(part, core::rad_from_deg(kStep_deg))) {
        Cells row{decimals(core::deg_from_rad(p.angle), 0), fmt::format("{:.3f}", core::mm_from_m(p.radius))};
        if (is_helix) row.push_back(fmt::format("{:.3f}", core::mm_from_m(p.z)));
        row.emplace_back(p.drilled ? "h" : p.works ? "w" : " ");
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table torque_table(const cam::Cam& cam) {
    Table table{{"Arm, tension and torque"},
                {{"turned", "arm", cam.has_roller() ? "force" : "tension", "torque"}, {"[deg]", "[mm]", "[N]", "[Nm]"}},
                {}};
    const std::size_t last = cam.working.size() - 1, count = std::min(kTorqueRows, cam.working.size());
    for (std::size_t i = 0; i < count; ++i) {
        const cam::ArmPoint& p = cam.working[count > 1 ? (i * last + (count - 1) / 2) / (count - 1) : 0].arm;
        table.rows.push_back({fmt::format("{:.2f}", core::deg_from_rad(p.angle)), fmt::format("{:.3f}", core::mm_from_m(p.arm)),
                              fmt::format("{:.2f}", p.tension), fmt::format("{:.4f}", p.tension * p.arm)});
    }
    return table;
}

}  // namespace fusee::drawing
