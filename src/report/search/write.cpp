#include "data/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/report/search.h"

namespace fusee::report {

namespace fs = std::filesystem;

void write_search(const search::codesign::RunResult& result, const fs::path& folder) {
    for (const search::codesign::FoundProfile& profile : result.profiles) {
        core::make_folder((folder / profile.file).parent_path());
        core::write_file(folder / profile.file, profile.toml);
    }
    std::string summary;
    for (const std::string& line : result.summary) summary += line + "\n";
    if (const auto& search = result.search) {
        core::write_file(folder / "history.csv", history_csv(search->history));
        if (!search->costs.empty()) core::write_file(folder / "figure_9.csv", figure_9_csv(search->costs));
        core::write_file(folder / "design.json", search_json(*search));
        core::write_file(folder / "design.html", search_html(*search, summary));
    }
    if (const auto& pareto = result.pareto) {
        core::write_file(folder / "pareto.json", pareto_json(*pareto));
        core::write_file(folder / "pareto.csv", pareto_csv(*pareto));
        core::write_file(folder / "pareto.html", pareto_html(*pareto, summary));
    }
}

std::string figure_9_csv(const std::vector<CostCurve>& costs) {
    std::string csv = "variable,value,cost,feasible\n";
    for (const CostCurve& curve : costs)
        for (std::size_t i = 0; i < curve.value.size(); ++i)
            add_csv_row(csv, curve.variable, curve.value[i], curve.cost[i], curve.feasible[i] ? 1 : 0);
    return csv;
}

std::string history_csv(const std::vector<double>& history) {
    std::string csv = "generation,best_cost\n";
    for (std::size_t i = 0; i < history.size(); ++i) add_csv_row(csv, i, history[i]);
    return csv;
}

std::string pareto_csv(const ParetoReport& report) {
    std::string csv = "profile,figure_deg";
    for (const double torque : report.torques) csv += fmt::format(",dead_band_at_{:g}_Nm_deg", torque);
    csv += ",travel_rad,soft_Nm_per_rad,stiff_Nm_per_rad,radius_mm,capstan_radius_mm\n";
    for (const ParetoPoint& p : report.points) {
        csv += fmt::format("{},{:.17g}", p.file, core::deg_from_rad(p.figure));
        for (const double width : p.dead_band) csv += fmt::format(",{:.17g}", core::deg_from_rad(width));
        csv += ",";
        add_csv_row(csv, p.travel, p.stiffness.low, p.stiffness.high, core::mm_from_m(p.radius), core::mm_from_m(p.capstan_radius));
    }
    return csv;
}

}  // namespace fusee::report
