#include <utility>

#include "fusee/core/destination.h"
#include "fusee/core/file.h"
#include "fusee/pipeline/export.h"
#include "fusee/report/assembly.h"
#include "fusee/report/paper.h"
#include "fusee/report/pareto.h"
#include "fusee/report/report.h"
#include "fusee/report/search.h"
#include "fusee/report/simulation.h"

// The files of each result.
namespace fs = std::filesystem;

namespace fusee::report {

std::vector<FileRow> write_simulation(const Simulation& simulation, const fs::path& folder) {
    core::make_folder(folder);
    std::vector<FileRow> rows;
    const auto write = [&](const char* name, const std::string& bytes) {
        core::write_file(folder / name, bytes);
        rows.push_back(pipeline::file_row(folder / name));
    };
    write("simulation.json", simulation_json(simulation));
    write("dead_band.csv", dead_band_csv(simulation.levels));
    write("simulation.html", simulation_html(simulation));
    if (!simulation.wraps.empty()) write("wrap_hysteresis.csv", wrap_hysteresis_csv(simulation.wraps));
    return rows;
}

void write_design(const pipeline::MadeDesign& made, const fs::path& folder) {
    DesignReport design = made.report;
    std::vector<FileRow> files = write_simulation(made.simulation, folder);
    const fs::path springs = folder / "springs.csv";
    write_springs_csv(springs, *made.resolved.law(), static_cast<std::size_t>(made.resolved.profile.outputs.springs_rows));
    files.push_back(pipeline::file_row(springs));
    if (design.assembly) {
        const std::vector<FileRow> of_joint = write_assembly(design, folder);
        files.insert(files.end(), of_joint.begin(), of_joint.end());
    }
    design.files.insert(design.files.begin(), files.begin(), files.end());
    core::write_file(folder / "report.json", report_json(design));
    core::write_file(folder / "report.html", report_html(design));
}

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

void write_paper(const Paper& paper, const fs::path& folder) {
    const auto write = [&folder](const char* name, const std::string& bytes) { core::write_file(folder / name, bytes); };
    write("figure_1.csv", figure_1_csv(paper.figure_1));
    write("figure_2.csv", figure_2_csv(paper.figure_2));
    write("figure_2_passive.csv", figure_2_passive_csv(paper.figure_2));
    if (paper.table_1.simulation.path) write("figure_6.csv", figure_6_csv(*paper.table_1.simulation.path));
    write("figure_8.csv", figure_8_csv(paper.figure_8));
    write("figure_9.csv", figure_9_csv(paper.figure_9.costs));
    write("figure_9_springs.csv", figure_9_springs_csv(paper.figure_9.found));
    write("figure_9_arms.csv", figure_9_arms_csv(paper.figure_9.cams));
    write("table_1.csv", table_csv(paper.table_1));
    write("table_2.csv", table_csv(paper.table_2));
    write("relatives.csv", relatives_csv(paper.relatives));
    write("paper.json", paper_json(paper));
    write("paper.html", paper_html(paper));
}

}  // namespace fusee::report
