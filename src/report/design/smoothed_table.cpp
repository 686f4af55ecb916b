#include <fmt/format.h>

#include "design/page.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

double series_residual(const TableRow& row) { return row.series_smooth - row.series; }
double parallel_residual(const TableRow& row) { return row.parallel_smooth - row.parallel; }

constexpr double kMilli = 1e3;

std::string misfit_text(const SmoothedTable& table, const SmoothedTable::Misfit& misfit) {
    return fmt::format("rms {} mNm, largest {} mNm in row {} at {} rad", number(kMilli * misfit.rms, 3), number(kMilli * misfit.largest, 3),
                       misfit.row, number(table.rows[misfit.row - 1].angle));
}

}  // namespace

std::string table_section(const LawReport& law) {
    if (!law.table) return "";
    const SmoothedTable& table = *law.table;
    const auto of = [&table](const auto& get) { return column(table.rows, get); };
    const auto angle = of(&TableRow::angle);
    Plot torques("Rows of the table and smoothed springs", "capstan angle in the file [rad]", "torque [Nm]");
    torques.points("F_SE, measured", angle, of(&TableRow::series), "se").points("F_PE, measured", angle, of(&TableRow::parallel), "pe");
    torques.curve("F_SE, smoothed", angle, of(&TableRow::series_smooth), "se");
    torques.curve("F_PE, smoothed", angle, of(&TableRow::parallel_smooth), "pe").from_zero();
    Plot residuals("Residuals: smoothed minus measured", "capstan angle in the file [rad]", "residual [mNm]");
    residuals.points("F_SE", angle, of([](const TableRow& r) { return kMilli * series_residual(r); }), "se");
    residuals.points("F_PE", angle, of([](const TableRow& r) { return kMilli * parallel_residual(r); }), "pe").from_zero();
    return section("Measured table and smoothed law", grid(torques.svg() + residuals.svg() + "<div class=\"card wide\">" +
                                                           html_facts({{"file", fmt::format("{}, {} rows", table.file, table.rows.size())},
                                                                       {"F_SE", misfit_text(table, table.series())},
                                                                       {"F_PE", misfit_text(table, table.parallel())}}) +
                                                           "</div>"));
}

}  // namespace fusee::report
