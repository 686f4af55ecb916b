#pragma once
#include <algorithm>
#include <cmath>

#include "fusee/gap_case/case_template.h"
#include "joint_model/fixture.h"
#include "pipeline/fixture.h"

namespace fusee::fixtures {

/// A small rig with straight springs, so that every figure is known by hand: F_SE = 0.3 x, F_PE = 0.2 theta.
inline gap_case::CaseTemplate small_template() {
    gap_case::CaseTemplate t;
    t.name = "small";
    t.rig = straight_rig();
    t.torques = {0.1, 1.5};
    return t;
}

/// The set points with what a rig without inertia and joint friction would show: plausible, not exact.
inline gap_case::Rows measured(const gap_case::CaseTemplate& t) {
    gap_case::Rows rows = set_points(t);
    const double mu = t.rig.gear_load_friction;
    for (gap_case::BreakAway& row : rows.breakaway) row.load_torque = row.motor_torque / (row.backdrive ? 1.0 - mu : 1.0 + mu);
    for (gap_case::SpringPull& row : rows.spring_pull) row.torque = (row.series ? 0.3 : 0.2) * row.deflection;
    for (gap_case::DeadBandRow& row : rows.dead_band) {
        row.q_low = -0.3;
        row.q_high = 0.3125;
        row.width = row.q_high - row.q_low;
    }
    for (gap_case::StiffnessRow& row : rows.joint_stiffness) row.q = row.joint_torque;
    for (gap_case::CocontractionRow& row : rows.cocontraction) {
        row.theta_agonist = row.theta_antagonist = row.motor_torque / 0.5;
        row.q = 0.001;
    }
    for (gap_case::LogRow& row : rows.log) {
        row.theta_agonist = row.torque_agonist / 0.5;
        row.theta_antagonist = row.torque_antagonist / 0.5;
        row.q = 0.1 * (row.theta_antagonist - row.theta_agonist) + 0.05 * row.joint_torque;
    }
    return rows;
}

/// A folder with a complete case, to change and to read.
class CaseFolder : public fusee::fixtures::TempFolder {
protected:
    void SetUp() override {
        TempFolder::SetUp();
        folder_ /= "small";
        gap_case::write_case_template(template_, folder_);
        for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
            files_.files[experiment] = {std::string(to_string(experiment)) + ".csv"};
        gap_case::write_rows(files_, measured(template_), folder_);
    }
    void TearDown() override {
        folder_ = folder_.parent_path();
        TempFolder::TearDown();
    }
    [[nodiscard]] std::string text(const std::string& file) const { return core::read_file(folder_ / file); }
    /// Replaces the first `from` of a file.
    void edit(const std::string& file, const std::string& from, const std::string& to) const {
        std::string all = text(file);
        const std::size_t at = all.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write(file, all.replace(at, from.size(), to));
    }
    /// The case with other rows of its experiments.
    void put(const gap_case::Rows& rows) const { gap_case::write_rows(files_, rows, folder_); }
    [[nodiscard]] std::string refusal() const {
        try {
            (void)gap_case::read_case(folder_);
        } catch (const std::exception& e) {
            return e.what();
        }
        return "accepted";
    }
    [[nodiscard]] bool remarked(const std::string& words) const {
        const std::vector<std::string> remarks = gap_case::read_case(folder_).remarks;
        return std::any_of(remarks.begin(), remarks.end(), [&](const std::string& r) { return r.find(words) != std::string::npos; });
    }

    gap_case::CaseTemplate template_ = small_template();
    gap_case::Case files_;
};

}  // namespace fusee::fixtures
