#pragma once
#include <optional>

#include "bindings.h"
#include "fusee/gap_case/case.h"
#include "fusee/gap_case/case_template.h"

namespace fusee::python {

/// The empty case of a profile's joint, or the law's refusal.
struct EmptyCase {
    std::optional<gap_case::CaseTemplate> value;
    core::Findings findings;
};
/// The case without measurements, for predictions. @throws InvalidInput if there is none
[[nodiscard]] gap_case::Case nominal_of(const EmptyCase& empty);

/// Columns by name as the text of a CSV file. @throws InvalidInput naming the column whose length differs
[[nodiscard]] std::string csv_of(const std::string& file, const py::dict& columns);
/// Inputs of experiments as columns by experiment and column: measured columns may be missing. @throws as gap_case::read_inputs
[[nodiscard]] gap_case::Rows inputs_of(const gap_case::Case& nominal, const py::dict& experiments);
/// The rows of each experiment as columns, named as in its file.
[[nodiscard]] py::dict arrays_of(const gap_case::Rows& rows);

}  // namespace fusee::python
