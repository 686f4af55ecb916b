#pragma once
#include <string>

#include "fusee/diagnosis/diagnosis.h"

namespace fusee::pipeline {
struct DesignReport;
}  // namespace fusee::pipeline

/// A diagnosis of the gap between model and rig, for a person (docs/gap.md). diagnosis.json is written by diagnosis::diagnosis_json.
namespace fusee::report {

/// One page in one file that opens offline, in the order where, which, how far: its scripts inside, no request. Figures that are not known
/// show as a dash, and parts without content are left out. Long traces are thinned, so that the page stays below 2 MB.
/// @param extra_section_html HTML of a further section at the page's end, taken as it is; the caller escapes its texts
/// @param joint the rig's joint as designed: shown in 3D, the bodies in which the effects lie marked; null: a schematic alone
[[nodiscard]] std::string diagnosis_html(const diagnosis::Diagnosis& diagnosis, const std::string& extra_section_html = {},
                                         const pipeline::DesignReport* joint = nullptr);

inline constexpr int kMostDiagnosisLines = 15;
/// Verdict, effects, where, gap, next experiment and remarks for a terminal: at most kMostDiagnosisLines lines.
[[nodiscard]] std::string diagnosis_text(const diagnosis::Diagnosis& diagnosis);

}  // namespace fusee::report
