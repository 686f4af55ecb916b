#include "fusee/report/as_exported.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "design/as_exported.h"
#include "fusee/core/units.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

Json spring_json(const ExportedSpring& spring) {
    if (spring.file.empty()) return {{"file", nullptr}};
    return {{"file", spring.file}, {"worst_arm_relative", spring.worst_arm}, {"worst_law_relative", spring.worst_law}};
}

std::string percent(double share) { return number(100.0 * share, 2) + " %"; }
std::string degrees(double angle) { return number(core::deg_from_rad(angle), 5) + (std::isnan(angle) ? "" : " deg"); }

/// File, worst error of the arm and of the torque.
void add_spring(std::vector<Cell>& row, const ExportedSpring& spring) {
    if (spring.file.empty()) {
        row.insert(row.end(), {{"nominal", "faint"}, {"", ""}, {"", ""}});
        return;
    }
    row.push_back({escape(spring.file), "code"});
    row.push_back({percent(spring.worst_arm), "num"});
    row.push_back({percent(spring.worst_law), "num"});
}

std::vector<Cell> joint_row(const JointAsExported& joint) {
    std::vector<Cell> row{{escape(joint.reader) + (joint.binding ? "" : ", a print"), ""}};
    add_spring(row, joint.series);
    add_spring(row, joint.parallel);
    for (const double width : joint.dead_band) row.push_back({degrees(width), "num"});
    if (!joint.refusal.empty()) row.back() = {escape(joint.refusal), "faint"};
    return row;
}

}  // namespace

double AsExported::worst_change() const {
    double worst = std::numeric_limits<double>::quiet_NaN();
    for (const JointAsExported& joint : joints)
        for (std::size_t i = 0; joint.binding && i < torques.size(); ++i) {
            if (std::isnan(nominal[i])) continue;  // the law as designed does not reach there either
            const double change = std::abs(joint.dead_band[i] / nominal[i] - 1.0);
            if (std::isnan(change)) return change;
            worst = std::fmax(worst, change);
        }
    return worst;
}

Json as_exported_json(const AsExported& exported) {
    Json joints = Json::array();
    for (const JointAsExported& joint : exported.joints)
        joints.push_back({{"reader", joint.reader},
                          {"k_se", spring_json(joint.series)},
                          {"k_pe", spring_json(joint.parallel)},
                          {"dead_band_rad", joint.dead_band},
                          {"binding", joint.binding},
                          {"refusal", joint.refusal}});
    return {{"tau_Nm", exported.torques}, {"nominal_dead_band_rad", exported.nominal}, {"joints", joints}};
}

std::string as_exported_section(const AsExported& exported) {
    if (exported.joints.empty()) return "";
    std::vector<std::string> head{"reader", "K_SE", "arm", "law", "K_PE", "arm", "law"};
    std::vector<Cell> nominal{{"nominal", ""}, {"as designed", "faint"}, {"", ""}, {"", ""}, {"as designed", "faint"}, {"", ""}, {"", ""}};
    for (std::size_t i = 0; i < exported.torques.size(); ++i) {
        head.push_back("at " + number(exported.torques[i], 3) + " Nm");
        nominal.push_back({degrees(exported.nominal[i]), "num"});
    }
    std::vector<std::vector<Cell>> rows{std::move(nominal)};
    for (const JointAsExported& joint : exported.joints) rows.push_back(joint_row(joint));
    return "<section><h2>The joint as exported</h2><p>From the arms found in its files each joint's springs, and from these its exact "
           "dead-band, edge to edge, at least, peak and overdrive torque: the last columns. Arm and law: the worst departure from what was "
           "asked for, over the working range. Where one part has no such file, its nominal law stands in.</p>" +
           html_table(head, rows) + "</section>\n";
}

}  // namespace fusee::report
