#include "csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"

namespace fusee::profile {

namespace {
const std::vector<core::CsvColumn> kColumns{{"angle_rad"}, {"series_Nm"}, {"parallel_Nm"}}, kOneSpring{{"angle_rad"}, {"torque_Nm"}};
constexpr std::size_t kLeastRows = 8;                  // spring::make_tabulated needs as many
constexpr double kMostAngle = 1e4, kMostTorque = 1e4;  // as of the keys

/// Angles of more than two turns may be degrees, torques far above those of the law mNm.
void ask_about_units(const core::CsvTable& rows, const std::vector<core::CsvColumn>& columns, double torque) {
    constexpr double kTurns = 4.0 * core::kPi, kTimes = 50.0, kMostOfAny = 300.0;  // [rad], [1], [Nm]
    const auto greatest = [&rows](const char* column) {
        const std::vector<double>& all = rows.numbers(column);
        const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
        return static_cast<std::size_t>(std::max_element(all.begin(), all.end(), less) - all.begin());
    };
    if (const std::size_t row = greatest("angle_rad"); !rows.unit_is_told("angle_rad") && rows.numbers("angle_rad")[row] > kTurns)
        throw rows.question(row, "angle_rad", "deg", "more than two turns of a capstan");
    const double most = torque > 0.0 ? kTimes * torque : kMostOfAny;
    for (std::size_t i = 1; i < columns.size(); ++i)
        if (const char* column = columns[i].name.c_str();
            !rows.unit_is_told(column) && std::abs(rows.numbers(column)[greatest(column)]) > most)
            throw rows.question(greatest(column), column, "mNm",
                                torque > 0.0 ? fmt::format("the law ends at {:g} Nm", torque) : std::string("a large torque for a spring"));
}

/// The rows of a measured law, the first column its angle. @throws as read_table
core::CsvTable read_law(std::string_view csv, const std::string& file, const std::vector<core::CsvColumn>& columns,
                        const core::CsvMapping& mapping, double torque) {
    core::CsvTable rows = core::parse_csv(csv, file, columns, {.least_rows = kLeastRows, .mapping = mapping});
    const std::vector<double>& angle = rows.numbers("angle_rad");
    core::CsvFaults faults(file);
    for (std::size_t i = 0; i < rows.rows(); ++i) {
        if (i > 0 && angle[i] <= angle[i - 1])
            faults.add(rows.fault(i, "angle_rad", fmt::format("{:g}", angle[i]), fmt::format("above the row before, {:g}", angle[i - 1])));
        for (const core::CsvColumn& column : columns) {
            const double most = column.name == "angle_rad" ? kMostAngle : kMostTorque;
            if (const double value = rows.numbers(column.name)[i]; std::abs(value) > most)
                faults.add(rows.fault(i, column.name, fmt::format("{:g}", value), fmt::format("{:g} to {:g}", -most, most)));
        }
    }
    faults.throw_if_any();
    ask_about_units(rows, columns, torque);
    return rows;
}
}  // namespace

void read_table(std::string_view csv, const std::string& file, TablePair& table, const core::CsvMapping& mapping, double torque) {
    const core::CsvTable rows = read_law(csv, file, kColumns, mapping, torque);
    table.angle = rows.numbers("angle_rad");
    table.series = rows.numbers("series_Nm");
    table.parallel = rows.numbers("parallel_Nm");
}

void read_one_spring(std::string_view csv, const std::string& file, Rows& law, const core::CsvMapping& mapping) {
    const core::CsvTable rows = read_law(csv, file, kOneSpring, mapping, 0.0);
    law.x = rows.numbers("angle_rad");
    law.y = rows.numbers("torque_Nm");
}

TablePair read_measured_law(const std::filesystem::path& file, const core::CsvMapping& mapping) {
    TablePair table;
    table.file = file;
    read_table(core::read_file(file, kLargestFile), file.string(), table, mapping);
    return table;
}

}  // namespace fusee::profile
