#include "fusee/identification/break_away.h"

#include <fmt/format.h>

#include "fusee/core/csv.h"
#include "fusee/core/file.h"

namespace fusee::identification {

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

}  // namespace

std::vector<BreakAway> parse_break_away(std::string_view csv, const std::string& file) {
    const core::CsvTable table = core::parse_csv(csv, file, kColumns);
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
    return rows;
}

std::vector<BreakAway> read_break_away(const std::filesystem::path& path) {
    return parse_break_away(core::read_file(path, kLargestBreakAwayFile), path.string());
}

}  // namespace fusee::identification
