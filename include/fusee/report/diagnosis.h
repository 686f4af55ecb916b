#pragma once
#include <string>

#include "fusee/diagnosis/diagnosis.h"

namespace fusee::pipeline {
struct DesignReport;
}  // namespace fusee::pipeline

/// A diagnosis of the gap between model and rig as files for programs (JSON) and people (HTML, text) (docs/gap.md).
namespace fusee::report {

/// diagnosis.json: the keys of diagnosis::diagnosis_json and what the page draws beside them. Long traces are thinned.
[[nodiscard]] std::string full_diagnosis_json(const diagnosis::Diagnosis& diagnosis);
/// One page in one file that opens offline, in the order where, which, how far. @param redesign redesign.json, or "": the page has its
/// section @param joint the rig's joint as designed: shown in 3D, the bodies in which the effects lie marked; null: a schematic alone
[[nodiscard]] std::string diagnosis_html(const diagnosis::Diagnosis& diagnosis, const std::string& redesign = {},
                                         const pipeline::DesignReport* joint = nullptr);

inline constexpr int kMostDiagnosisLines = 15;
/// Verdict, effects, where, gap, next experiment and remarks for a terminal: at most kMostDiagnosisLines lines.
[[nodiscard]] std::string diagnosis_text(const diagnosis::Diagnosis& diagnosis);

}  // namespace fusee::report
