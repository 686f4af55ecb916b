#pragma once
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case_template.h"

namespace fusee::diagnosis {

/// The measurement that a diagnosis asks for next, on the rig of its case.
struct NextCase {
    gap_case::CaseTemplate empty;  ///< rig, tolerances, sensors and protocol of the case
    gap_case::Rows set_points;     ///< of that measurement alone, repeats included; what is measured is NaN
    NextExperiment experiment;
};

/// The first of `found.next` (docs/theory/isolability.md). @param file the name of the diagnosis in messages
/// @throws core::InvalidInput if `found` asks for nothing, is of another case, or of another version of fusee
[[nodiscard]] NextCase next_case(const gap_case::Case& measured, const Diagnosis& found, const std::string& file);

}  // namespace fusee::diagnosis
