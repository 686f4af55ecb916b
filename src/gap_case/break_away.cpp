#include "fusee/gap_case/break_away.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fusee::gap_case {

namespace {

const std::vector<core::CsvColumn> kColumns{
    {"side", core::CsvColumn::Kind::kText}, {"direction", core::CsvColumn::Kind::kText}, {"motor_torque_Nm"}, {"load_torque_Nm"}};

constexpr double kLargestTorque = 1e6;  // [Nm]; larger values are in another unit

double torque_of(const core::CsvTable& table, std::size_t row, const char* column) {
    const double torque = table.numbers(column)[row];
    if (torque < 0.0 || torque > kLargestTorque)
        throw table.fault(row, column, fmt::format("{:g}", torque), fmt::format("0 to {:g} Nm", kLargestTorque));
    return torque;
}

/// A torque of hundreds of Nm at the capstan, or loads of another size than the motor torques, are asked about.
void ask_about_units(const core::CsvTable& table) {
    constexpr double kMostTorque = 300.0;  // [Nm]: a gear of 30 kg; in mNm it is the torque of a hobby servo
    constexpr double kMostRatio = 100.0;   // of load and motor torque: gears that lock themselves aside, a thousand is milli
    const auto& motor = table.numbers("motor_torque_Nm");
    const auto& load = table.numbers("load_torque_Nm");
    for (const char* column : {"motor_torque_Nm", "load_torque_Nm"}) {
        if (table.unit_is_told(column)) continue;
        const auto& own = table.numbers(column);
        const auto& other = &own == &motor ? load : motor;
        const auto most = std::max_element(own.begin(), own.end()) - own.begin();
        const double ratio = own[most] / *std::max_element(other.begin(), other.end());
        if (std::isfinite(ratio) && ratio > kMostRatio)
            throw table.question(most, column, "mNm", fmt::format("{:.3g} times the other torque", ratio));
        if (own[most] > kMostTorque) throw table.question(most, column, "mNm", "a large torque for a capstan");
    }
}

}  // namespace

std::vector<BreakAway> parse_break_away(std::string_view csv, const std::string& file, const core::CsvMapping& mapping) {
    const core::CsvTable table = core::parse_csv(csv, file, kColumns, {.mapping = mapping});
    std::vector<BreakAway> rows;
    rows.reserve(table.rows());
    core::CsvFaults faults(file);
    const auto take = [&](std::size_t i) {
        const std::string& direction = table.texts("direction")[i];
        if (direction != "drive" && direction != "backdrive")
            throw table.fault(i, "direction", "'" + direction + "'", "drive or backdrive");
        rows.push_back({table.texts("side")[i], direction == "backdrive", torque_of(table, i, "motor_torque_Nm"),
                        torque_of(table, i, "load_torque_Nm"), table.line(i)});
    };
    for (std::size_t i = 0; i < table.rows(); ++i) faults.collect([&] { take(i); });
    faults.throw_if_any();
    ask_about_units(table);
    return rows;
}

}  // namespace fusee::gap_case
