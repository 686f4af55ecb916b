#include "fusee/report/identification.h"

#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/provenance.h"
#include "fusee/core/units.h"
#include "identification/json.h"
#include "page/bundle.h"

namespace fusee::report {

namespace {

Json friction_line_json(const gap_case::FrictionLine& line) {
    return {{"group", line.group},
            {"rows", line.rows},
            {"mu", line.mu},
            {"mu_95", range_json(line.mu_95)},
            {"constant_Nm", line.constant},
            {"constant_95_Nm", range_json(line.constant_95)},
            {"scatter_Nm", line.scatter},
            {"r_squared", line.r_squared},
            {"through_zero_mu", line.through_zero_mu},
            {"through_zero_mu_95", range_json(line.through_zero_mu_95)},
            {"robust_mu", line.robust_mu},
            {"robust_constant_Nm", line.robust_constant},
            {"outlier_rows", line.outliers}};
}

Json motor_json(const gap_case::FrictionReport::Motor& m) {
    return {{"side", m.side},
            {"rows", m.rows},
            {"torque_scale", m.scale},
            {"torque_scale_95", range_json(m.scale_95)},
            {"mu", m.mu},
            {"mu_95", range_json(m.mu_95)},
            {"constant_Nm", m.constant},
            {"constant_95_Nm", range_json(m.constant_95)},
            {"p", m.p},
            {"differs", m.differs}};
}

Json one_way_json(const gap_case::FrictionReport::OneWay& m) {
    return {{"side", m.side},
            {"direction", m.backdrive ? "backdrive" : "drive"},
            {"rows", m.rows},
            {"if_torque_right", {{"mu", m.mu}, {"mu_95", range_json(m.mu_95)}}},
            {"if_no_friction", {{"torque_scale", m.scale}, {"torque_scale_95", range_json(m.scale_95)}}},
            {"to_measure",
             {{"direction", m.backdrive ? "drive" : "backdrive"},
              {"motor_torque_Nm", m.motor_torque},
              {"load_if_torque_right_Nm", m.load_by_friction},
              {"load_if_no_friction_Nm", m.load_by_scale}}}};
}

Json repeat_json(const gap_case::FrictionReport::Repeat& r) {
    return {{"side", r.side},
            {"direction", r.backdrive ? "backdrive" : "drive"},
            {"motor_torque_Nm", r.motor_torque},
            {"rows", r.rows},
            {"mean_load_Nm", r.mean_load},
            {"mean_friction_Nm", r.mean_friction},
            {"deviation_Nm", r.deviation}};
}

/// The trusted line over the load with its 95 % band, as the page draws it; friction is not negative.
Json line_curve_json(const gap_case::FrictionReport& friction) {
    constexpr int kSteps = 60;        // the band is a hyperbola
    constexpr double kBeyond = 1.04;  // the line extends past the last dot
    const gap_case::FrictionLine& line = friction.trusted();
    double most = 0.0;
    for (const gap_case::FrictionReport::Repeat& r : friction.repeats) most = std::max(most, r.mean_load);
    std::vector<double> load, fitted, low, high;
    for (int i = 0; i <= kSteps; ++i) {
        load.push_back(kBeyond * most * i / kSteps);
        const core::Range band = line.friction_95(load.back());
        const double on_line = line.constant + line.mu * load.back();
        fitted.push_back(on_line < 0.0 ? core::kNan : on_line);
        low.push_back(std::max(0.0, band.low));
        high.push_back(std::max(0.0, band.high));
    }
    return {{"load_Nm", load}, {"line_Nm", fitted}, {"low_Nm", low}, {"high_Nm", high}};
}

Json friction_remark_json(const gap_case::FrictionRemark& remark) { return {{"id", remark.id}, {"text", remark.text}, {"p", remark.p}}; }

}  // namespace

std::string identification_text(const Identification& identification) {
    const gap_case::FrictionReport& friction = identification.friction;
    constexpr std::size_t kMostLines = 40;
    std::size_t width = 7;
    for (const gap_case::FrictionLine& line : friction.lines) width = std::max(width, line.group.size());
    width = std::min<std::size_t>(width, 40);
    std::string out = fmt::format(
        "{:{}}  rows      mu   (95 %)              constant Nm   (95 %)               mu at 0  robust mu  scatter Nm\n", "rows of", width);
    for (std::size_t i = 0; i < std::min(kMostLines, friction.lines.size()); ++i) {
        const gap_case::FrictionLine& line = friction.lines[i];
        out += fmt::format("{:{}}  {:4}  {:6.4f}   {:7.4f} to {:7.4f}   {:+11.5f}   {:+9.5f} to {:+8.5f}   {:6.4f}     {:6.4f}  {:10.5f}\n",
                           line.group, width, line.rows, line.mu, line.mu_95.low, line.mu_95.high, line.constant, line.constant_95.low,
                           line.constant_95.high, line.through_zero_mu, line.robust_mu, line.scatter);
    }
    if (friction.lines.size() > kMostLines)
        out += fmt::format("... and {} more in identification.json\n", friction.lines.size() - kMostLines);
    for (const gap_case::FrictionRemark& remark : friction.remarks) out += "- " + remark.text + "\n";
    if (!friction.law && !friction.one_way.empty())
        out += "\nNo lines for a profile: no motor has rows of both directions, drive and backdrive.\n";
    if (friction.law) out += "\nFor a profile:\n" + friction.profile_lines();
    return out;
}

Json identification_object(const Identification& identification) {
    const gap_case::FrictionReport& friction = identification.friction;
    Json law;
    if (friction.law) law = {{"gear_friction", friction.law->mu}, {"gear_friction_constant_Nm", friction.law->constant}};
    return {{"fusee", core::version()},
            {"name", identification.name},
            {"file_sha256", identification.file_sha256},
            {"law", std::move(law)},
            {"profile_lines", friction.profile_lines()},
            {"remarks", json_list(friction.remarks, friction_remark_json)},
            {"motors", json_list(friction.motors, motor_json)},
            {"one_way", json_list(friction.one_way, one_way_json)},
            {"scatter_growth", friction.scatter_growth},
            {"lines", json_list(friction.lines, friction_line_json)},
            {"trusted", friction_line_json(friction.trusted())},
            {"line_curve", line_curve_json(friction)},
            {"repeats", json_list(friction.repeats, repeat_json)}};
}

std::string identification_json(const Identification& identification) { return json_text(identification_object(identification)); }

std::string identification_html(const Identification& identification) {
    return page_file(
        {"identification", identification.name, identification_text(identification), {{"result", identification_json(identification)}}});
}

}  // namespace fusee::report
