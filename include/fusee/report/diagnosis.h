#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"

namespace fusee::pipeline {
struct DesignReport;
}  // namespace fusee::pipeline

/// A diagnosis of the gap between model and rig as files for programs (JSON) and people (a page, text) (docs/gap.md).
namespace fusee::report {

/// diagnosis.json: the keys of diagnosis::diagnosis_json and what the page draws beside them. Long traces are thinned.
[[nodiscard]] std::string full_diagnosis_json(const diagnosis::Diagnosis& diagnosis);

/// The joint of a rig as designed, for the page: JSON of the drawing along the axis and of the 3D view.
struct JointScene {
    std::string plan, scene;
};
/// @pre joint.assembly
[[nodiscard]] JointScene joint_scene(const pipeline::DesignReport& joint);

/// One page in one file that opens offline, in the order where, which, how far. @param redesign redesign.json, or "": the page has its
/// section @param joint shown in 3D, the bodies in which the effects lie marked; without it a schematic alone
[[nodiscard]] std::string diagnosis_html(const diagnosis::Diagnosis& diagnosis, const std::string& redesign = {},
                                         const std::optional<JointScene>& joint = {});

enum class Theme;
/// The gap map before and after, one above the other (picture.h). @throws InvalidInput naming --view: the diagnosis has none
[[nodiscard]] std::string gap_map_picture(const diagnosis::Diagnosis& diagnosis, Theme theme);

/// An effect of a joint or of a subsystem case in a sentence; "" for an unknown id.
[[nodiscard]] std::string meaning(std::string_view effect_id);
/// Ids of the effects of subsystem cases.
[[nodiscard]] std::vector<std::string_view> subsystem_effects();

/// What a fit of all parameters would have claimed, and what it costs; "" without Diagnosis::absorption.
[[nodiscard]] std::string absorption_sentence(const diagnosis::Diagnosis& diagnosis);

inline constexpr int kMostDiagnosisLines = 15;
/// Verdict, effects, where, gap, next experiment and remarks for a terminal: at most kMostDiagnosisLines lines.
[[nodiscard]] std::string diagnosis_text(const diagnosis::Diagnosis& diagnosis);

}  // namespace fusee::report
