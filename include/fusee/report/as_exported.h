#pragma once
#include <string>
#include <vector>

namespace fusee::report {

/// The spring of one part as a file carries it.
struct ExportedSpring {
    std::string file;        ///< empty: the part has no such file, and its nominal law is taken
    double worst_arm = 0.0;  ///< largest |arm found/arm asked - 1| over the working range
    double worst_law = 0.0;  ///< largest |torque/nominal torque - 1| over the capstan's travel
};

/// The joint with the springs that the files of one format carry, as one reader finds them; both its sides alike.
struct JointAsExported {
    std::string reader;               ///< as in readback::ArmError, without the name of a cut: "rs274"
    ExportedSpring series, parallel;  ///< K_SE, K_PE
    std::vector<double> dead_band;    ///< exact, full width at the joint [rad], at each of AsExported::torques; NaN where the springs end
    bool binding = true;              ///< false: of a print, which no exported file can answer for
    std::string refusal;              ///< why there is no such joint; empty: there is
};

/// Nominal and as exported, side by side (docs/theory/read_back.md).
struct AsExported {
    std::vector<double> torques;  ///< co-contraction: least, peak and overdrive torque of the rig [Nm]
    std::vector<double> nominal;  ///< the dead-band of the law as designed, as JointAsExported::dead_band
    std::vector<JointAsExported> joints;

    /// Largest |as exported/nominal - 1| of a dead-band, prints left out; NaN if there is none, or one that a file has lost.
    [[nodiscard]] double worst_change() const;
};

}  // namespace fusee::report
