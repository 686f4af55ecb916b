#include <fmt/format.h>

#include "data/csv.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/report/report.h"

namespace fusee::report {

namespace {
constexpr std::size_t kLeastRows = 200;
constexpr const char* kHeader = "tau_Nm,theta_rad,f_se_Nm,f_pe_Nm,s_Nm_per_rad,p_Nm_per_rad,u_se_J,u_pe_J,t\n";
}  // namespace

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
