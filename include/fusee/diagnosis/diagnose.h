#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"
#include "fusee/gap_case/case_template.h"
#include "fusee/inference/model.h"
#include "fusee/joint_model/built_rig.h"

/// Example:
/// @code
/// const gap_case::Case monday = gap_case::read_case("bench/monday");
/// const diagnosis::Diagnosis found = diagnosis::diagnose(monday);
/// const gap_case::Rows tuesday = gap_case::read_inputs(monday, "bench/tuesday");
/// gap_case::write_rows(monday, diagnosis::predict(monday, found, tuesday), "predicted");  // measured columns as the rig should read
/// @endcode
namespace fusee::diagnosis {

struct DiagnoseOptions {
    unsigned jobs = 0;  ///< threads, 0: as many as cores; the result does not depend on it
    /// Called after each finished part: done, total, name. May throw to stop (core::Stopped).
    std::function<void(std::size_t, std::size_t, const std::string&)> progress;
};

/// The case that a diagnosis is of.
struct Subject {
    std::string name, sha256;
};

/// Where a model and its measurements differ, which effect causes it, and how far the gap shrinks with that effect in the model.
/// Deterministic for any number of threads. @pre every experiment has a measured value for each place
[[nodiscard]] Diagnosis diagnose_model(const inference::Model& model, const Subject& subject, const DiagnoseOptions& options = {});

/// Which causes of a diagnosis hold on another case of the same model, with its own diagnosis beside them.
/// @throws core::InvalidInput naming a cause or a build parameter that `other` does not have
[[nodiscard]] Against against(const inference::Model& other, const Subject& subject, const Diagnosis& found,
                              const DiagnoseOptions& options = {});
/// The same with a case of a joint. @throws core::InvalidInput if it has too few rows
[[nodiscard]] Against against(const gap_case::Case& other, const Diagnosis& found, const DiagnoseOptions& options = {});

/// The gap (docs/theory/diagnosis.md, eq. 17) of other rows of the rig that a diagnosis is of: of the model as stated, and as the diagnosis
/// predicts them. @throws core::InvalidInput as setting_of
struct CarriedGap {
    double before = kNoFigure, after = kNoFigure;  ///< [sigma]
};
[[nodiscard]] CarriedGap carried_gap(const inference::Model& other, const Diagnosis& found);

/// The setting of a model that a diagnosis from a file says: its build parameters and effects, each within its limits.
/// @param file the name used in messages. @throws core::InvalidInput naming what the model does not know or allow
[[nodiscard]] inference::Setting setting_of(const inference::Model& model, const Diagnosis& found, const std::string& file);

/// Where model and rig differ, which unmodelled effect causes it, and how far the gap shrinks with that effect in the
/// model (docs/gap.md). Deterministic for any number of threads. @throws core::InvalidInput if the case has too few rows
[[nodiscard]] Diagnosis diagnose(const gap_case::Case& gap_case, const DiagnoseOptions& options = {});

/// Checks a diagnosis from a file against the rig of a case: each effect is known, appears once per side, has a size (and further
/// parameters) within the range of its law, and its unit; each build parameter is known.
/// @param file the name used in messages. @throws core::InvalidInput naming the effect, its size and what is allowed
void require_possible(const gap_case::Case& nominal, const Diagnosis& found, const std::string& file);

/// The nominal rig with `found.effects`, `found.unknown_terms` and `found.build` (an empty Diagnosis: the nominal rig), its springs
/// tabulated.
/// @throws core::InvalidInput naming an effect or side that the library does not know, or a value that cannot be built (friction or arm
/// below 0)
[[nodiscard]] joint_model::BuiltRig built_rig(const gap_case::Case& nominal, const Diagnosis& found);

/// Predicts the measured columns at the inputs of `inputs`, row by row, by `built_rig`.
/// @throws core::InvalidInput as built_rig; naming an experiment without a finite prediction
[[nodiscard]] gap_case::Rows predict(const gap_case::Case& nominal, const Diagnosis& found, const gap_case::Rows& inputs);

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
