#include "figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/check.h"
#include "fusee/solid/mesh.h"

namespace fusee::batch {

namespace {

/// g/cm^3 of what shops use most: PLA, standard resin, PA12, EN AW-6082, steel.
double usual_density(checks::ProcessKind kind) {
    switch (kind) {
        case checks::ProcessKind::kFdm:
            return 1.24;
        case checks::ProcessKind::kSla:
            return 1.18;
        case checks::ProcessKind::kSls:
            return 1.01;
        case checks::ProcessKind::kMill:
        case checks::ProcessKind::kMill4:
            return 2.70;
        default:
            return 7.85;
    }
}

/// "dead_band_at_0_85_Nm_deg"
std::string dead_band_column(double torque) {
    std::string number = fmt::format("{:g}", torque);
    std::replace(number.begin(), number.end(), '.', '_');
    return "dead_band_at_" + number + "_Nm_deg";
}

constexpr const char* kEnds[] = {"least", "peak", "overdrive"};

struct Width {
    std::string column;
    double torque = 0.0;
};

std::vector<Width> widths(const std::vector<double>& torques, const std::array<double, 3>& ends) {
    std::vector<Width> all;
    for (const double torque : torques) all.push_back({dead_band_column(torque), torque});
    if (all.empty())
        for (std::size_t i = 0; i < ends.size(); ++i) all.push_back({fmt::format("dead_band_{}_deg", kEnds[i]), ends[i]});
    return all;
}

void add_dead_bands(Figures& to, const actuator::Actuator& joint, const std::vector<double>& torques) {
    const std::array<double, 3> ends{joint.least_torque, joint.peak_torque, joint.overdrive_torque};
    for (const Width& width : widths(torques, ends))
        to.emplace_back(width.column, core::deg_from_rad(actuator::dead_band(joint, width.torque).exact_width));
    const actuator::DeadBand least = actuator::dead_band(joint, joint.least_torque),
                             most = actuator::dead_band(joint, joint.overdrive_torque);
    to.emplace_back("stiffness_least_Nm_per_rad", least.joint_stiffness);
    to.emplace_back("stiffness_overdrive_Nm_per_rad", most.joint_stiffness);
}

void add_part(Figures& to, const pipeline::PartReport& part, const std::string& name) {
    const solid::Box box = solid::bounding_box(part.part->mesh);
    for (std::size_t axis = 0; axis < 3; ++axis)
        to.emplace_back(fmt::format("{}_{}_mm", name, "xyz"[axis]), box.high_mm[axis] - box.low_mm[axis]);
    double tension = 0.0;
    for (const cam::Contact& contact : part.part->cam.working) tension = std::max(tension, contact.arm.tension);
    to.emplace_back(name + "_tension_N", tension);
    to.emplace_back(name + "_triangles", static_cast<double>(part.part->mesh.triangles.size()));
}

/// The contour of a closed cam or the projection of a helix, in units of its largest radius: "x,y x,y ...".
std::string outline(const cam::Cam& cam) {
    constexpr int kPoints = 48;
    std::vector<cam::PathPoint> points;
    double largest = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        points.push_back(cam.path(cam.groove_psi.low + cam.groove_psi.width() * i / kPoints));
        largest = std::max(largest, std::hypot(points.back().x(), points.back().y()));
    }
    std::string text;
    for (const cam::PathPoint& p : points)
        text += fmt::format("{}{:.3f},{:.3f}", text.empty() ? "" : " ", p.x() / largest, p.y() / largest);
    return text;
}

void add_files(Figures& to, const pipeline::DesignReport& report) {
    std::size_t files = report.files.size();
    double bytes = 0.0;
    const auto count = [&](const pipeline::FileRow& row) { bytes += static_cast<double>(row.bytes); };
    std::for_each(report.files.begin(), report.files.end(), count);
    for (const pipeline::PartReport* side : report.sides()) {
        files += side->files.size();
        std::for_each(side->files.begin(), side->files.end(), count);
    }
    to.emplace_back("files", static_cast<double>(files));
    to.emplace_back("bytes", bytes);
    const pipeline::FileErrors errors = report.file_errors();
    to.emplace_back("arm_error_percent", 100.0 * errors.arm);
    to.emplace_back("dead_band_error_percent", 100.0 * errors.dead_band);
}

double shop_arm_error(const pipeline::Headline& headline) {
    double worst = std::nan("");
    for (const pipeline::MadeArm& arm : headline.arms) worst = std::fmax(worst, arm.worst_relative());
    return 100.0 * worst;
}

}  // namespace

std::vector<study::Column> index_columns(const study::Plan& plan) {
    std::vector<study::Column> columns{{"outcome", "made, or refused because a limit cannot be kept", true}};
    for (const study::Variation& v : plan.study().vary) {
        const bool is_text = !v.values.empty() && v.values.front().starts_with('"');
        columns.push_back({study::column_name(v.key), "key " + v.key + " of the profile", is_text});
    }
    for (const Width& width : widths(plan.study().torques, {}))
        columns.push_back({width.column, "exact dead-band, full width at the joint, at this equal co-contraction [deg]"});
    const std::vector<study::Column> others{
        {"dead_band_built_low_deg", "at overdrive torque: 5 % of joints as a shop builds them are below [deg]"},
        {"dead_band_built_high_deg", "at overdrive torque: 95 % of joints as a shop builds them are below [deg]"},
        {"stiffness_least_Nm_per_rad", "joint stiffness at least torque, capstans at rest [Nm/rad]"},
        {"stiffness_overdrive_Nm_per_rad", "joint stiffness at overdrive torque, capstans at rest [Nm/rad]"},
        {"joint_torque_Nm", "greatest joint torque at which every spring stays inside its law [Nm]"},
        {"condition_6", "condition (6), d(T tau_f)/dtau < 0: holds, fails, holds in part, within rounding, not known", true},
        {"shop_arm_error_percent", "largest arm error by the process's contour tolerance, either side [%]"},
        {"mass_g", "mass of K_SE and K_PE, full, in the process's usual material [g]"},
        {"k_se_x_mm", "size of the series cam [mm]"},
        {"k_se_y_mm", "size of the series cam [mm]"},
        {"k_se_z_mm", "size of the series cam [mm]"},
        {"k_se_tension_N", "greatest tension of the series cam's cable [N]"},
        {"k_se_triangles", "triangles of the series cam's mesh"},
        {"k_pe_x_mm", "size of the parallel cam [mm]"},
        {"k_pe_y_mm", "size of the parallel cam [mm]"},
        {"k_pe_z_mm", "size of the parallel cam [mm]"},
        {"k_pe_tension_N", "greatest tension of the parallel cam's cable [N]"},
        {"k_pe_triangles", "triangles of the parallel cam's mesh"},
        {"arm_error_percent", "largest arm error of the files as read back [%]"},
        {"dead_band_error_percent", "largest change of the dead-band by the files [%]"},
        {"files", "files written"},
        {"bytes", "size of the files"},
        {"errors", "rules that are broken"},
        {"warnings", "rules that ask for a review"},
        {"not_judged", "rules that the profile gives too little data for"},
        {"worst_rule", "the binding rule of the highest severity", true},
        {"worst_finding", "its finding in one line", true}};
    columns.insert(columns.end(), others.begin(), others.end());
    return columns;
}

Figures varied_figures(const study::Plan& plan, const study::Planned& planned) {
    Figures figures;
    for (std::size_t i = 0; i < planned.values.size(); ++i) {
        const std::string& text = planned.values[i];
        double number = std::nan("");
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        study::Figure figure = number;
        if (!is_number) figure = text.size() >= 2 && text.front() == '"' ? text.substr(1, text.size() - 2) : text;
        figures.emplace_back(study::column_name(plan.study().vary[i].key), std::move(figure));
    }
    return figures;
}

Figures finding_figures(const core::Findings& findings) {
    Figures figures{{"errors", static_cast<double>(core::count(findings, core::Severity::kError))},
                    {"warnings", static_cast<double>(core::count(findings, core::Severity::kWarning))},
                    {"not_judged", static_cast<double>(core::count(findings, core::Severity::kNotJudged))}};
    if (const core::Finding* worst = pipeline::binding(findings)) {
        figures.emplace_back("worst_rule", worst->rule);
        figures.emplace_back("worst_finding", core::to_line(*worst));
    }
    return figures;
}

Figures design_figures(const pipeline::MadeDesign& made, const std::vector<double>& torques) {
    const pipeline::DesignReport& report = made.report;
    Figures figures;
    add_dead_bands(figures, made.resolved.actuator, torques);
    figures.emplace_back("dead_band_built_low_deg", core::deg_from_rad(report.headline.overdrive.built.low));
    figures.emplace_back("dead_band_built_high_deg", core::deg_from_rad(report.headline.overdrive.built.high));
    figures.emplace_back("joint_torque_Nm", report.headline.joint_torque);
    figures.emplace_back("condition_6", std::string(to_string(pipeline::condition_verdict(report.headline.condition))));
    figures.emplace_back("shop_arm_error_percent", shop_arm_error(report.headline));
    double volume = 0.0;
    for (const pipeline::PartReport& part : report.parts) {
        add_part(figures, part, to_string(part.part->cam.kind));
        volume += solid::volume_mm3(part.part->mesh);
    }
    figures.emplace_back("mass_g", 1e-3 * volume * usual_density(made.resolved.profile.process.kind));
    add_files(figures, report);
    for (const pipeline::PartReport& part : report.parts)
        figures.emplace_back(std::string(to_string(part.part->cam.kind)) + "_outline", outline(part.part->cam));
    const Figures worst = finding_figures(report.all_findings());
    figures.insert(figures.end(), worst.begin(), worst.end());
    return figures;
}

}  // namespace fusee::batch
