#include "design/as_exported.h"

#include <cmath>

#include "page/html.h"

namespace fusee::report {

namespace {

std::string degrees_text(double angle) { return deg(angle, 5) + (std::isnan(angle) ? "" : " deg"); }

/// File, worst error of the arm and of the torque.
void add_spring(std::vector<Cell>& row, const ExportedSpring& spring) {
    const auto error = [](double share) { return num(number(100.0 * share, 2) + " %"); };
    if (spring.file.empty())
        row.insert(row.end(), {faint("nominal"), plain(""), plain("")});
    else
        row.insert(row.end(), {code(spring.file), error(spring.worst_arm), error(spring.worst_law)});
}

std::vector<Cell> joint_row(const JointAsExported& joint) {
    std::vector<Cell> row{plain(joint.reader + (joint.binding ? "" : ", a print"))};
    add_spring(row, joint.series);
    add_spring(row, joint.parallel);
    for (const double width : joint.dead_band) row.push_back(num(degrees_text(width)));
    if (!joint.refusal.empty()) row.back() = faint(joint.refusal);
    return row;
}

}  // namespace

std::string as_exported_section(const AsExported& exported) {
    if (exported.joints.empty()) return "";
    std::vector<std::string> head{"reader", "K_SE", "arm error", "law error", "K_PE", "arm error", "law error"};
    const Cell designed = faint("as designed"), none = plain("");
    std::vector<Cell> nominal{plain("nominal"), designed, none, none, designed, none, none};
    for (std::size_t i = 0; i < exported.torques.size(); ++i) {
        head.push_back("at " + newton_metres(exported.torques[i]));
        nominal.push_back(num(degrees_text(exported.nominal[i])));
    }
    Rows rows{std::move(nominal)};
    for (const JointAsExported& joint : exported.joints) rows.push_back(joint_row(joint));
    return folded_section(
        "The joint as exported", counted(exported.joints.size(), "joint") + " of the files",
        paragraph("The last columns are the exact dead-band, edge to edge, at least, peak and overdrive torque. It is computed "
                  "from the springs whose arms were read back from the files. Arm and law error: the largest relative error over "
                  "the working range. A part without such a file has its nominal law.") +
            html_table("Dead-band of the joint with the springs of its files", head, rows));
}

}  // namespace fusee::report
