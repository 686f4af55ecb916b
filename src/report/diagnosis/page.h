#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/report/report.h"

/// The sections of the diagnosis page, each a pure function of its data and "" without content.
namespace fusee::report {

[[nodiscard]] std::string where_section(const diagnosis::Diagnosis& diagnosis);        ///< contributions to the gap, map before and after
[[nodiscard]] std::string which_section(const diagnosis::Diagnosis& diagnosis);        ///< effects found, alternatives, ranking
[[nodiscard]] std::string isolability_section(const diagnosis::Diagnosis& diagnosis);  ///< similarities, classes, detectable sizes
/// What effects fitted on a part of the files do on the held-out file.
[[nodiscard]] std::string transfer_section(const diagnosis::Diagnosis& diagnosis);
/// The least size of each effect that a verdict without effects excludes.
[[nodiscard]] std::string power_section(const diagnosis::Diagnosis& diagnosis);
[[nodiscard]] std::string trace_section(const diagnosis::Diagnosis& diagnosis);  ///< measured against predicted, the most telling first
/// The generic terms that explain the gap of an unknown effect: sentence, law, values, curve.
[[nodiscard]] std::string form_section(const diagnosis::Diagnosis& diagnosis);
/// A schematic of the joint with the bodies in which the effects lie; "" for a subsystem case and without effects.
[[nodiscard]] std::string place_section(const diagnosis::Diagnosis& diagnosis);
/// The causes that a picture of the joint marks.
struct Marked {
    std::vector<effects::Cause> found, possible;  ///< possible: while the verdict names none
};
/// Without causes outside the joint, as an unknown one.
[[nodiscard]] Marked marked_causes(const diagnosis::Diagnosis& diagnosis);
/// The rig's joint in 3D with the bodies in which the effects lie; "" without effects. @pre joint.assembly or a finding that says why not
[[nodiscard]] std::string marked_joint_section(const diagnosis::Diagnosis& diagnosis, const DesignReport& joint);
/// The traces that the effects found explain most, or the worst predicted ones: indices, by falling reduction of the squared gap.
[[nodiscard]] std::vector<std::size_t> most_telling(const std::vector<diagnosis::Trace>& traces, std::size_t most);

inline constexpr std::size_t kMostPointsOfATrace = 400, kMostDotsOfATrace = 120;
inline constexpr std::size_t kMostPoints = 12000;  ///< of all traces together: at about 100 bytes each the page stays below 2 MB
/// How many points of each of `traces` traces are drawn.
[[nodiscard]] std::size_t drawn_points(std::size_t traces);

}  // namespace fusee::report
