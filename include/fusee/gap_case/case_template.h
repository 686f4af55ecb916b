#pragma once
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/gap_case/case.h"

namespace fusee::gap_case {

/// How hard the joint is pushed in a dead-band test [Nm].
struct Push {
    double torque = 0.0;
    /// The strongest push that keeps every spring within its law; NaN: unknown.
    double within_laws = std::numeric_limits<double>::quiet_NaN();
};

/// Input of an empty case.
struct CaseTemplate {
    std::string name;
    NominalRig rig;
    Tolerance tolerance;
    Sensors sensors;
    Protocol protocol;
    core::Range torques{0.0, 0.0};  ///< co-contractions in use [Nm], low >= 0
    /// Deflection of the springs on their stops without motor torque [rad]; 0: no stops (docs/gap.md, "Springs with
    /// stops").
    double rest_deflection = 0.0;
    /// Push of the dead-band test at a co-contraction [Nm]; none: limited by the curve of K_SE, which may read less than a full push.
    std::function<Push(double cocontraction)> push = {};
    std::string purpose = {};  ///< what the measurements are for, a paragraph of BENCH.md; "": the whole rig
};

/// Fills `folder` with an empty case: case.toml, nominal_springs.csv, each experiment's CSV with its set points and empty cells for what is
/// measured, and BENCH.md, the sheets that say how to measure. `read_case` names cells that are still empty.
/// @throws core::InvalidInput if the torques are no range above 0 or a figure is none that read_case takes; core::IoError
void write_case_template(const CaseTemplate& empty, const std::filesystem::path& folder);
/// The same with these set points; experiments without a row are left out.
void write_case_template(const CaseTemplate& empty, const Rows& set_points, const std::filesystem::path& folder);
/// The same files as texts. @throws core::InvalidInput as write_case_template
[[nodiscard]] CaseTexts case_template_texts(const CaseTemplate& empty);
[[nodiscard]] CaseTexts case_template_texts(const CaseTemplate& empty, const Rows& set_points);

/// The names of its files, which the user fills in or corrects.
[[nodiscard]] std::vector<std::string> case_template_files();

/// The set points of every experiment; what is measured is NaN. @throws core::InvalidInput without springs or a range of torques
[[nodiscard]] Rows set_points(const CaseTemplate& empty);

}  // namespace fusee::gap_case
