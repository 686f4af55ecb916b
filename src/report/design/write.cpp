#include <fmt/format.h>

#include "data/csv.h"
#include "design/parts.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/report/assembly.h"
#include "fusee/report/report.h"
#include "fusee/report/simulation.h"

namespace fusee::report {

namespace {

constexpr std::size_t kLeastRows = 200;
constexpr const char* kHeader = "tau_Nm,theta_rad,f_se_Nm,f_pe_Nm,s_Nm_per_rad,p_Nm_per_rad,u_se_J,u_pe_J,t\n";

}  // namespace

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
    std::vector<FileRow> files;
    if (made.simulation) files = write_simulation(*made.simulation, folder);
    const fs::path springs = folder / (made.simulation ? "springs.csv" : "law.csv");
    const auto rows = static_cast<std::size_t>(made.resolved.profile.outputs.springs_rows);
    if (made.simulation)
        write_springs_csv(springs, *made.resolved.law(), rows);
    else
        write_law_csv(springs, *made.resolved.law(), design.headline.spring->angles.low, rows);
    files.push_back(pipeline::file_row(springs));
    if (design.assembly) {
        const std::vector<FileRow> of_joint = write_assembly(design, folder);
        files.insert(files.end(), of_joint.begin(), of_joint.end());
    }
    design.files.insert(design.files.begin(), files.begin(), files.end());
    std::string json = report_json(design);
    core::write_file(folder / "report.json", json);
    core::write_file(folder / "report.html", report_page(design, std::move(json)));
}

void write_springs_csv(const std::filesystem::path& path, const spring::SpringLaw& law, std::size_t rows) {
    if (rows < kLeastRows) throw core::InvalidInput("rows", fmt::format("{}", rows), fmt::format("at least {}", kLeastRows));
    std::string csv = kHeader;
    for (const spring::LawPoint& p : spring::sample_by_load(law, rows))
        add_csv_row(csv, p.tau, p.theta, p.f_se, p.f_pe, p.s, p.p, p.u_se, p.u_pe, p.transmission());
    core::write_file(path, csv);
}

void write_law_csv(const std::filesystem::path& path, const spring::SpringLaw& law, double first_angle, std::size_t rows) {
    std::string csv = "angle_rad,torque_Nm,stiffness_Nm_per_rad,energy_J\n";
    for (const spring::LawPoint& p : spring::sample_by_load(law, rows)) add_csv_row(csv, first_angle + p.theta, p.tau, p.p, p.u_pe);
    core::write_file(path, csv);
}

}  // namespace fusee::report
