#include "data/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/report/paper.h"
#include "fusee/report/simulation.h"

namespace fusee::report {

namespace fs = std::filesystem;

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

std::string figure_1_csv(const std::vector<NoiseCurve>& curves) {
    std::string csv = "noise,c_Nm_per_rad,motor_variance_rad2,joint_variance_rad2,joint_slope_rad3_per_Nm\n";
    for (const NoiseCurve& curve : curves)
        for (std::size_t i = 0; i < curve.c.size(); ++i)
            add_csv_row(csv, curve.name, curve.c[i], curve.motor[i], curve.joint[i], curve.slope[i]);
    return csv;
}

std::string figure_2_csv(const HillFigure& figure) {
    std::string csv = "active_Nm,length_rad,series_Nm,parallel_Nm\n";
    for (const HillFigure::Row& row : figure.rows) add_csv_row(csv, row.active, row.length, row.series, row.parallel);
    return csv;
}

std::string figure_2_passive_csv(const HillFigure& figure) {
    std::string csv = "length_rad,force_Nm\n";
    for (const HillFigure::Passive& p : figure.passive) add_csv_row(csv, p.length, p.force);
    return csv;
}

std::string figure_6_csv(const ReleasePath& path) {
    std::string csv = "push,joint_torque_Nm,q_rad,load_1_Nm,load_2_Nm\n";
    const auto add = [&csv](const char* push, const std::vector<PathPoint>& points) {
        for (const PathPoint& p : points) add_csv_row(csv, push, p.joint_torque, p.q, p.load_1, p.load_2);
    };
    add("up", path.up);
    add("down", path.down);
    return csv;
}

std::string figure_8_csv(const Identification& identification) {
    std::string csv = "side,direction,motor_torque_Nm,rows,mean_load_Nm,mean_friction_Nm,deviation_Nm\n";
    for (const gap_case::FrictionReport::Repeat& r : identification.friction.repeats)
        add_csv_row(csv, r.side, r.backdrive ? "backdrive" : "drive", r.motor_torque, r.rows, r.mean_load, r.mean_friction, r.deviation);
    return csv;
}

std::string figure_9_springs_csv(const LawCurves& law) {
    std::string csv = "tau_Nm,theta_rad,f_se_Nm,f_pe_Nm,s_Nm_per_rad,p_Nm_per_rad\n";
    for (const spring::LawPoint& p : law.samples) add_csv_row(csv, p.tau, p.theta, p.f_se, p.f_pe, p.s, p.p);
    return csv;
}

std::string figure_9_arms_csv(const std::vector<CamCurve>& cams) {
    std::string csv = "part,cam_angle_rad,arm_m\n";
    for (const CamCurve& cam : cams)
        for (const cam::ArmPoint& p : cam.arms) add_csv_row(csv, cam::to_string(cam.kind), p.angle, p.arm);
    return csv;
}

std::string table_csv(const PaperTable& table) {
    std::string csv =
        "tau_Nm,paper_deg,linear_deg,extreme_deg,protocol_deg,linear_less_paper_deg,extreme_less_paper_deg,protocol_less_paper_deg,"
        "implied_parallel_Nm_per_rad\n";
    for (std::size_t i = 0; i < table.simulation.measured.size(); ++i) {
        const MeasuredRow& row = table.simulation.measured[i];
        const SimulatedDeadBand& d = row.computed;
        add_csv_row(csv, row.tau, core::deg_from_rad(row.measured), core::deg_from_rad(d.linear), core::deg_from_rad(d.exact_width),
                    core::deg_from_rad(d.measured_width), core::deg_from_rad(d.linear - row.measured),
                    core::deg_from_rad(d.exact_width - row.measured), core::deg_from_rad(d.measured_width - row.measured),
                    table.parallel[i]);
    }
    return csv;
}

}  // namespace fusee::report
