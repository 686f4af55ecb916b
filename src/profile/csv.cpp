#include "csv.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/csv.h"
#include "fusee/core/file.h"

namespace fusee::profile {

namespace {
const std::vector<core::CsvColumn> kColumns{{"angle_rad"}, {"series_Nm"}, {"parallel_Nm"}};
const core::CsvOptions kOptions{.extra_columns = false, .least_rows = 8};  // spring::make_tabulated needs as many
constexpr double kMostAngle = 1e4, kMostTorque = 1e4;                      // as of the keys
}  // namespace

void read_table(std::string_view csv, const std::string& file, TablePair& table) {
    const core::CsvTable rows = core::parse_csv(csv, file, kColumns, kOptions);
    table.angle = rows.numbers("angle_rad");
    table.series = rows.numbers("series_Nm");
    table.parallel = rows.numbers("parallel_Nm");
    core::CsvFaults faults(file);
    for (std::size_t i = 0; i < rows.rows(); ++i) {
        if (i > 0 && table.angle[i] <= table.angle[i - 1])
            faults.add(rows.fault(i, "angle_rad", fmt::format("{:g}", table.angle[i]),
                                  fmt::format("above the row before, {:g}", table.angle[i - 1])));
        for (const auto& [column, most] : {std::pair{"angle_rad", kMostAngle}, {"series_Nm", kMostTorque}, {"parallel_Nm", kMostTorque}})
            if (const double value = rows.numbers(column)[i]; std::abs(value) > most)
                faults.add(rows.fault(i, column, fmt::format("{:g}", value), fmt::format("{:g} to {:g}", -most, most)));
    }
    faults.throw_if_any();
}

TablePair read_measured_law(const std::filesystem::path& file) {
    TablePair table;
    table.file = file;
    read_table(core::read_file(file, kLargestFile), file.string(), table);
    return table;
}

}  // namespace fusee::profile
