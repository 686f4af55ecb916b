#pragma once
#include <string>
#include <vector>

namespace fusee::pipeline {

struct ResolvedDesign;
struct DesignReport;

/// The spring of one part as a file carries it.
struct ExportedSpring {
    std::string file;        ///< empty: the part has no such file, and its nominal law is taken
    double worst_arm = 0.0;  ///< largest |arm found/arm asked - 1| over the working range
    double worst_law = 0.0;  ///< largest |torque/nominal torque - 1| over the capstan's travel
};

/// The joint with the springs of the files of one format, as one reader finds them; both sides are equal.
struct JointAsExported {
    std::string reader;               ///< as in readback::ArmError, without the name of a cut: "rs274"
    ExportedSpring series, parallel;  ///< K_SE, K_PE
    std::vector<double> dead_band;    ///< exact, full width at the joint [rad], at each of AsExported::torques; NaN where the springs end
    bool binding = true;              ///< false: a print, for which no exported file can answer
    std::string refusal;              ///< why there is no such joint; empty: there is one
};

/// The nominal joint and the joints as exported (docs/theory/read_back.md).
struct AsExported {
    std::vector<double> torques;  ///< co-contraction: least, peak and overdrive torque of the rig [Nm]
    std::vector<double> nominal;  ///< the dead-band of the law as designed, as JointAsExported::dead_band
    std::vector<JointAsExported> joints;

    /// Largest |as exported/nominal - 1| of a dead-band, without prints; NaN if there is none, or if a file has lost one.
    [[nodiscard]] double worst_change() const;
};

/// The law and the dead-band of the joint as exported: for each format and reader, the springs that follow from the arms found and the base
/// springs. Both parts are taken together if both have that format; else the other part has its nominal law. Where two half plates share a
/// groove, the cable lies on the higher one. The result depends on the files only, not on findings.
/// @param parts with the arms of their files, and of the plate, as read back
[[nodiscard]] AsExported as_exported(const ResolvedDesign& design, const DesignReport& parts);

}  // namespace fusee::pipeline
