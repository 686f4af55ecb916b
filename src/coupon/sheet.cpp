#include "fusee/coupon/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/coupon/calibration.h"
#include "fusee/math/statistics.h"

namespace fusee::coupon {

namespace {

constexpr core::Range kNothing{0.0, 0.0}, kLength_mm{0.01, 1e4}, kYesNo{0.0, 1.0}, kForce_N{-1e4, 1e4};
constexpr const char *kNone = "-", *kYesOrNo = "1=yes 0=no";

constexpr std::array kKinds{
    ItemKind{Item::kCableDiameter, "cable_diameter", "mm", kNone, kLength_mm, kNothing, "do not change: the cable of the profile"},
    ItemKind{Item::kDiscFloor, "disc_floor", "mm", kNone, kLength_mm, kNothing, "do not change: nominal radius of the disc's floor"},
    ItemKind{Item::kLengthX, "length_x", "mm", "mm", kLength_mm, kLength_mm, "plate: outer face to outer face along x"},
    ItemKind{Item::kLengthY, "length_y", "mm", "mm", kLength_mm, kLength_mm, "plate: the same along y"},
    ItemKind{Item::kLengthZ, "length_z", "mm", "mm", kLength_mm, kLength_mm, "plate: height of plate and tower above the bed"},
    ItemKind{Item::kBore, "bore", "mm", "mm", kLength_mm, kLength_mm, "plate: diameter of the hole drawn with the given one"},
    ItemKind{Item::kShaft, "shaft", "mm", "mm", kLength_mm, kLength_mm, "diameter of the shaft for the holes"},
    ItemKind{Item::kShaftEnters, "shaft_enters", "mm", kYesOrNo, kLength_mm, kYesNo, "does the shaft enter by hand and turn?"},
    ItemKind{Item::kCableSeats,
             "cable_seats",
             "ratio",
             kYesOrNo,
             {0.5, 2.0},
             kYesNo,
             "groove ladder: does the tight cable lie on the floor, not on the flanks?"},
    ItemKind{Item::kDiscPull, "disc_pull", "turn", "mm", {0.0, 100.0}, {0.0, 1e5}, "disc: cable drawn off after that many turns"},
    ItemKind{Item::kDiscTorque, "disc_torque", "N", "Nm", {0.0, 1e4}, {-1e3, 1e3}, "disc: torque on its shaft at that cable tension"},
    ItemKind{
        Item::kSeriesSpring, "series_spring", "mm", "N", {0.0, 1e5}, kForce_N, "disc on K_SE's spring: force in the cable after that pull"},
    ItemKind{Item::kParallelSpring, "parallel_spring", "mm", "N", {0.0, 1e4}, kForce_N, "K_PE's spring alone: force at that travel"},
};

const std::vector<core::CsvColumn> kColumns{{"item", core::CsvColumn::Kind::kText},
                                            {"given"},
                                            {"given_unit", core::CsvColumn::Kind::kText},
                                            {"measured", core::CsvColumn::Kind::kNumber, true, true},
                                            {"unit", core::CsvColumn::Kind::kText}};

const ItemKind& kind_of(Item item) { return *core::find_by(kKinds, &ItemKind::item, item); }

/// Reads one row at a time and refuses errors of the items.
class Reader {
public:
    explicit Reader(const core::CsvTable& table) : table_(table) {}

    void take(std::size_t row, Sheet& sheet) const {
        const ItemKind& kind = kind_at(row);
        require_unit(row, "given_unit", kind.given_unit);
        require_unit(row, "unit", kind.unit);
        const double given = require_within(row, "given", kind.given), measured = table_.numbers("measured")[row];
        if (kind.unit == kNone) {
            if (!std::isnan(measured)) throw fault(row, "measured", measured, "an empty cell: this value is nominal, not measured");
            double& drawn = kind.item == Item::kDiscFloor ? sheet.disc_floor_mm : sheet.cable_diameter_mm;
            if (drawn > 0.0 && drawn != given) throw fault(row, "given", given, fmt::format("{:g}, as in an earlier row", drawn));
            drawn = given;
        } else if (!std::isnan(measured)) {
            require_within(row, "measured", kind.measured);
            if (kind.unit == kYesOrNo && measured != 0.0 && measured != 1.0) throw fault(row, "measured", measured, "1 (yes) or 0 (no)");
            sheet.rows.push_back({kind.item, given, measured});
        }
    }

private:
    [[nodiscard]] core::InvalidInput fault(std::size_t row, const char* column, double value, std::string allowed) const {
        return table_.fault(row, column, fmt::format("{:g}", value), std::move(allowed));
    }
    [[nodiscard]] const ItemKind& kind_at(std::size_t row) const {
        const std::string& name = table_.texts("item")[row];
        if (const ItemKind* kind = core::find_by(kKinds, &ItemKind::name, name)) return *kind;
        throw table_.fault(row, "item", "'" + name + "'", core::listed(kKinds, &ItemKind::name));
    }
    void require_unit(std::size_t row, const char* column, const char* unit) const {
        if (const std::string& found = table_.texts(column)[row]; found != unit)
            throw table_.fault(row, column, "'" + found + "'", fmt::format("'{}'", unit));
    }
    double require_within(std::size_t row, const char* column, core::Range range) const {
        const double value = table_.numbers(column)[row];
        if (!range.holds(value)) throw fault(row, column, value, fmt::format("{:g} to {:g}", range.low, range.high));
        return value;
    }

    const core::CsvTable& table_;
};

std::string line(Item item, double given) {
    const ItemKind& kind = kind_of(item);
    return fmt::format("{},{:.6g},{},,{}\n", kind.name, given, kind.given_unit, kind.unit);
}

std::string lines(Item item, const std::vector<double>& given, int repeats = 1) {
    std::string text;
    for (const double value : given)
        for (int i = 0; i < repeats; ++i) text += line(item, value);
    return text;
}

std::vector<double> parts_of(double whole, int count) {
    std::vector<double> parts;
    for (int i = 0; i <= count; ++i) parts.push_back(whole * i / count);
    return parts;
}

/// Values with their numbers: "0: 6, 1: 6.1".
std::string counted(const std::vector<double>& values, int first) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
        text += fmt::format("{}{}: {:.4g}", i == 0 ? "" : ", ", static_cast<int>(i) + first, values[i]);
    return text;
}

}  // namespace

std::span<const ItemKind> item_kinds() { return kKinds; }

std::vector<Row> Sheet::of(Item item) const {
    std::vector<Row> some;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(some), [item](const Row& row) { return row.item == item; });
    return some;
}

Sheet parse_sheet(std::string_view csv, const std::string& file, const core::CsvMapping& mapping) {
    const core::CsvTable table = core::parse_csv(csv, file, kColumns, {.mapping = mapping});
    const Reader reader(table);
    Sheet sheet;
    core::CsvFaults faults(file);
    for (std::size_t row = 0; row < table.rows(); ++row) faults.collect([&] { reader.take(row, sheet); });
    faults.throw_if_any();
    if (sheet.rows.empty()) throw core::InvalidInput(file + ": measured", "no row is filled", "at least one measured figure");
    return sheet;
}

std::string empty_sheet(const Drawn& drawn, const std::string& provenance) {
    constexpr int kRepeats = 3;
    constexpr double kTorques_N[] = {5.0, 10.0, 20.0};
    std::string text = fmt::format(
        "# coupons of {}\n# Fill the column `measured`, in its row's unit, with a decimal point. Rows may be empty, repeated and "
        "added.\n# README.md beside this sheet explains the measurement of each item. Then: fusee calibrate COUPON.csv\n"
        "item,given,given_unit,measured,unit\n",
        provenance);
    text += line(Item::kCableDiameter, drawn.cable_diameter_mm) + line(Item::kDiscFloor, drawn.disc_floor_mm);
    text += lines(Item::kLengthX, drawn.x_mm, kRepeats) + lines(Item::kLengthY, drawn.y_mm, kRepeats) +
            lines(Item::kLengthZ, drawn.z_mm, kRepeats);
    text += lines(Item::kBore, drawn.bores_mm) + line(Item::kShaft, drawn.shaft_mm) + lines(Item::kShaftEnters, drawn.bores_mm);
    text += lines(Item::kCableSeats, drawn.groove_ratios);
    text += lines(Item::kDiscPull, parts_of(drawn.disc_turns, 6));
    text += lines(Item::kDiscTorque, {std::begin(kTorques_N), std::end(kTorques_N)});
    text += lines(Item::kSeriesSpring, {20.0, 40.0, 60.0, 80.0}) + lines(Item::kParallelSpring, {5.0, 10.0, 15.0, 20.0});
    return text;
}

core::Range Estimate::interval(double confidence) const {
    constexpr double kMost = 1e6;  // Student's t is the normal distribution by then
    const auto whole = static_cast<std::size_t>(std::clamp(std::floor(freedom + 1e-9), 1.0, kMost));
    const double reach = math::student_quantile(confidence, whole) * deviation;
    return {value - reach, value + reach};
}

Estimate sum(const std::vector<Share>& shares) {
    Estimate total;
    double variance = 0.0, fourth = 0.0;
    for (const auto& [factor, of] : shares) {
        const double square = factor * factor * of.deviation * of.deviation;
        total.value += factor * of.value;
        variance += square;
        fourth += square * square / of.freedom;
    }
    total.deviation = std::sqrt(variance);
    total.freedom = fourth > 0.0 ? variance * variance / fourth : std::numeric_limits<double>::infinity();
    return total;
}

Line fit_line(const std::vector<Row>& rows, double resolution) {
    const auto count = static_cast<double>(rows.size());
    const double mean = std::accumulate(rows.begin(), rows.end(), 0.0, [](double s, const Row& r) { return s + r.given; }) / count;
    math::LinearModel model;
    model.x.assign(2, {});
    double spread = 0.0;  // sum of (x - mean)^2: level and slope are independent at the mean
    for (const Row& row : rows) {
        model.x[0].push_back(1.0);
        model.x[1].push_back(row.given - mean);
        model.y.push_back(row.measured);
        spread += (row.given - mean) * (row.given - mean);
    }
    const math::LinearFit fit = math::fit_linear(model);
    const double scatter = std::max(fit.deviation, resolution / std::sqrt(12.0)), freedom = count - 2.0;
    const Estimate level{fit.coefficients[0], scatter / std::sqrt(count), freedom};
    const Estimate slope{fit.coefficients[1], scatter / std::sqrt(spread), freedom};
    Line line{slope, sum({{1.0, level}, {-mean, slope}})};
    line.at_0.freedom = freedom;  // both have the same scatter
    return line;
}

std::string readme(const Drawn& drawn, const std::string& provenance) {
    std::string text = fmt::format("# Coupons\n{}\n\n", provenance);
    text +=
        "Make them like the cams: same machine, material, settings and direction (z up). Print the files as they are: "
        "they\n"
        "are not compensated, and the scaling of the slicer must be off. Let them cool, deburr them, measure them and fill "
        "`COUPON.csv`.\n\n"
        "| file | content |\n|---|---|\n";
    text += fmt::format(
        "| `bores_and_lengths` | an L with a tower on its corner. Along x and y: {:.4g} mm (width of an arm) and {:.4g} mm (its length); "
        "heights {:.4g} and {:.4g} mm. Holes by the number of notches beside them, diameters in mm: {} |\n",
        drawn.x_mm.front(), drawn.x_mm.back(), drawn.z_mm.front(), drawn.z_mm.back(), counted(drawn.bores_mm, 0));
    text += fmt::format(
        "| `groove_ladder` | grooves for the cable of {:g} mm, counted from the wide foot; floor radius over cable diameter: {} |\n",
        drawn.cable_diameter_mm, counted(drawn.groove_ratios, 1));
    text += fmt::format(
        "| `disc` | the profile's groove on a floor of {:g} mm radius, {:g} turns; `disc.json` states its arm like that of any part |\n\n",
        drawn.disc_floor_mm, drawn.disc_turns);
    text += "| row of the sheet | given | fill in | how |\n|---|---|---|---|\n";
    for (const ItemKind& kind : item_kinds())
        text += fmt::format("| `{}` | {} | {} | {} |\n", kind.name, kind.given_unit, kind.unit, kind.how);
    text +=
        "\nThe disc: fix the cable in its hole, lay it into the groove and load it with the tension of the joint. `disc_pull`: turn it by "
        "the "
        "given\n"
        "turns from any start and note the length of moved cable; the first row is 0. `disc_torque`: a lever with a scale on its "
        "shaft.\n"
        "`series_spring`: the disc in place of the spool on K_SE's torsion spring, force by a scale in the cable.\n\n"
        "Rows that you cannot measure stay empty; `fusee calibrate` lists the unknown values.\n";
    return text;
}

}  // namespace fusee::coupon
