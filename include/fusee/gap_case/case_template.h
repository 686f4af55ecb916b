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
    /// The strongest one on whose way no spring goes beyond the end of its law; NaN: not known.
    double within_laws = std::numeric_limits<double>::quiet_NaN();
};

/// What an empty case is made for.
struct CaseTemplate {
    std::string name;
    NominalRig rig;
    Tolerance tolerance;
    Sensors sensors;
    Protocol protocol;
    core::Range torques{0.0, 0.0};  ///< co-contraction at which the joint is used [Nm], low >= 0
    /// Deflection at which the springs rest on their stops without a motor torque [rad]; 0: they have none (docs/gap.md, "Springs with
    /// stops").
    double rest_deflection = 0.0;
    /// Of the dead-band test at a co-contraction [Nm]; none: as far as K_SE's curve carries it, which may read less than a full push.
    std::function<Push(double cocontraction)> push = {};
};

/// Fills `folder` with an empty case: case.toml, nominal_springs.csv, each experiment's CSV with its set points and empty cells for what is
/// measured, and BENCH.md, the sheets that say how to measure. As long as a cell is empty `read_case` names it.
/// @throws core::InvalidInput if the torques are no range above 0 or a figure is none that read_case takes; core::IoError
void write_case_template(const CaseTemplate& empty, const std::filesystem::path& folder);

/// The names of its files: all are to be filled in or put right by the user.
[[nodiscard]] std::vector<std::string> case_template_files();

/// The set points of every experiment; what is measured is NaN.
[[nodiscard]] Rows set_points(const CaseTemplate& empty);

}  // namespace fusee::gap_case
