#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/core/csv.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/coupon/calibration.h"

namespace fusee::coupon {

namespace {

using core::m_from_mm, core::mm_from_m;
using Kind = core::CsvColumn::Kind;

constexpr const char* kMeasured = "measured_deviation_mm";
constexpr double kFarthest_mm = 1e4;     // of a place from the axis
constexpr double kMostDeviation_mm = 5;  // more: a radius or a diameter instead of a deviation

struct ItemName {
    Inspected item;
    const char* name;
    bool on_contour;  ///< has a normal and an arm
};
constexpr std::array kItems{ItemName{Inspected::kContour, "contour", true}, ItemName{Inspected::kRim, "rim", true},
                            ItemName{Inspected::kBore, "bore", false}, ItemName{Inspected::kKey, "key", false},
                            ItemName{Inspected::kFace, "face", false}};

const std::vector<core::CsvColumn> kInspectionColumns{{"part", Kind::kText},
                                                      {"item", Kind::kText},
                                                      {"number"},
                                                      {"x_mm"},
                                                      {"y_mm"},
                                                      {"z_mm"},
                                                      {"normal_deg", Kind::kNumber, true, true},
                                                      {"nominal_mm"},
                                                      {"allowed_low_mm"},
                                                      {"allowed_high_mm"},
                                                      {kMeasured, Kind::kNumber, true, true}};

std::string inspection_header() { return core::listed(kInspectionColumns, &core::CsvColumn::name, ",") + "\n"; }

class InspectionReader {
public:
    explicit InspectionReader(const core::CsvTable& table) : table_(table) {}

    void take(std::size_t row, InspectionSheet& sheet) const {
        const std::string& part = table_.texts("part")[row];
        if (sheet.part.empty()) sheet.part = part;
        if (part != sheet.part) throw table_.fault(row, "part", part, sheet.part + " as in the rows before: one part a sheet");
        if (!part.starts_with("k_se") && !part.starts_with("k_pe")) throw table_.fault(row, "part", part, "k_se or k_pe, also mirrored");
        const ItemName& item = item_at(row);
        InspectionRow r;
        r.item = item.item;
        r.number = static_cast<int>(within(row, "number", 1.0, 1e6));
        r.x = m_from_mm(within(row, "x_mm", -kFarthest_mm, kFarthest_mm));
        r.y = m_from_mm(within(row, "y_mm", -kFarthest_mm, kFarthest_mm));
        r.z = m_from_mm(within(row, "z_mm", -kFarthest_mm, kFarthest_mm));
        r.normal = core::rad_from_deg(table_.numbers("normal_deg")[row]);
        if (item.on_contour && std::isnan(r.normal)) throw fault(row, "normal_deg", r.normal, "the direction of the normal");
        r.nominal = m_from_mm(within(row, "nominal_mm", item.on_contour ? 1e-3 : 0.0, kFarthest_mm));
        r.low = m_from_mm(within(row, "allowed_low_mm", -kMostDeviation_mm, kMostDeviation_mm));
        r.high = m_from_mm(within(row, "allowed_high_mm", mm_from_m(r.low), kMostDeviation_mm));
        r.deviation = m_from_mm(table_.numbers(kMeasured)[row]);
        if (!std::isnan(r.deviation)) within(row, kMeasured, -kMostDeviation_mm, kMostDeviation_mm);
        sheet.rows.push_back(r);
    }

private:
    [[nodiscard]] core::InvalidInput fault(std::size_t row, const char* column, double value, std::string allowed) const {
        return table_.fault(row, column, std::isnan(value) ? "an empty cell" : fmt::format("{:g}", value), std::move(allowed));
    }
    [[nodiscard]] const ItemName& item_at(std::size_t row) const {
        const std::string& name = table_.texts("item")[row];
        if (const ItemName* item = core::find_by(kItems, &ItemName::name, name)) return *item;
        throw table_.fault(row, "item", "'" + name + "'", core::listed(kItems, &ItemName::name));
    }
    double within(std::size_t row, const char* column, double low, double high) const {
        const double value = table_.numbers(column)[row];
        if (!(value >= low && value <= high)) throw fault(row, column, value, fmt::format("{:g} to {:g}", low, high));
        return value;
    }

    const core::CsvTable& table_;
};

std::string row_line(const std::string& part, const InspectionRow& r) {
    const ItemName* item = core::find_by(kItems, &ItemName::item, r.item);
    const std::string normal = std::isnan(r.normal) ? "" : fmt::format("{:.4f}", core::deg_from_rad(r.normal));
    return fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{},{:.4f},{:.4g},{:.4g},\n", part, item->name, r.number, mm_from_m(r.x),
                       mm_from_m(r.y), mm_from_m(r.z), normal, mm_from_m(r.nominal), mm_from_m(r.low), mm_from_m(r.high));
}

}  // namespace

bool is_inspection(std::string_view csv, const core::CsvMapping& mapping) {
    return core::csv_fits(csv, {{"normal_deg"}, {kMeasured}}, mapping);
}

InspectionSheet parse_inspection(std::string_view csv, const std::string& file, const core::CsvMapping& mapping) {
    const core::CsvTable table = core::parse_csv(csv, file, kInspectionColumns, {.mapping = mapping});
    const InspectionReader reader(table);
    InspectionSheet sheet;
    core::CsvFaults faults(file);
    for (std::size_t row = 0; row < table.rows(); ++row) faults.collect([&] { reader.take(row, sheet); });
    faults.throw_if_any();
    const auto measured = [](const InspectionRow& r) {
        return (r.item == Inspected::kContour || r.item == Inspected::kRim) && !std::isnan(r.deviation);
    };
    if (std::none_of(sheet.rows.begin(), sheet.rows.end(), measured))
        throw core::InvalidInput(file + ": " + kMeasured, "no row of the contour is filled", "at least one measured deviation");
    return sheet;
}

std::string empty_inspection(const InspectionSheet& sheet, const std::string& provenance) {
    std::string text = fmt::format(
        "# inspection of {}, {}\n# Clamp the part on its bore (datum A), its key in the position of the drawing (datum B). Fill {}: above "
        "0 "
        "is material\n# beyond the nominal along the outward normal (a bore: too wide). Rows may be left empty. Then: fusee calibrate "
        "{}_inspection.csv\n# contour, rim: at the groove's floor (rim), nominal_mm is the arm there. bore: its diameter. key: its middle "
        "across, nominal_mm its\n# width. face: its height near the edge.\n",
        sheet.part, provenance, kMeasured, sheet.part);
    text += inspection_header();
    for (const InspectionRow& row : sheet.rows) text += row_line(sheet.part, row);
    return text;
}

}  // namespace fusee::coupon
