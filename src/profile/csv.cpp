#include "csv.h"

#include <fmt/format.h>

#include "fusee/core/csv.h"

namespace fusee::profile {

namespace {
const std::vector<core::CsvColumn> kColumns{{"angle_rad"}, {"series_Nm"}, {"parallel_Nm"}};
const core::CsvOptions kOptions{.extra_columns = false, .least_rows = 8};  // spring::make_tabulated needs as many
}  // namespace

void read_table(std::string_view csv, const std::string& file, TablePair& table) {
    const core::CsvTable rows = core::parse_csv(csv, file, kColumns, kOptions);
    table.angle = rows.numbers("angle_rad");
    table.series = rows.numbers("series_Nm");
    table.parallel = rows.numbers("parallel_Nm");
    for (std::size_t i = 1; i < rows.rows(); ++i)
        if (table.angle[i] <= table.angle[i - 1])
            throw rows.fault(i, "angle_rad", fmt::format("{:g}", table.angle[i]),
                             fmt::format("above the row before, {:g}", table.angle[i - 1]));
}

}  // namespace fusee::profile
