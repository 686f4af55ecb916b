#pragma once
#include <string>
#include <vector>

#include "fusee/gap_case/case_template.h"
#include "fusee/inference/model.h"

namespace fusee::effects {

/// A measurement to propose.
struct SheetMeasurement {
    gap_case::Experiment experiment = gap_case::Experiment::kBreakAway;
    std::size_t sheet = 0;          ///< of the menu
    std::vector<std::size_t> rows;  ///< of the experiment's in that sheet
    int repeats = 1;                ///< of each row
    std::string what;               ///< instruction without a full stop
    std::string variable;
    std::vector<double> set_points;
    double cost = 0.0;  ///< [min] (docs/theory/isolability.md, "What a measurement costs")
    /// Gives the measurement as the engine sees it, without the places of its values.
    [[nodiscard]] inference::Measurement offer() const { return {to_string(experiment), what, variable, set_points, cost, repeats, {}}; }
};

/// Rows to predict once, and measurements made of some of them: the rows of a sheet are independent.
struct MeasurementMenu {
    std::vector<gap_case::Rows> sheets;
    std::vector<SheetMeasurement> measurements;
};

/// Every experiment with the set points of a case template, and its parts: one side, one spring, the lowest and the highest level alone, a
/// stronger push, a faster and a slower log. Torques stay within the range of the case.
[[nodiscard]] MeasurementMenu measurement_menu(const gap_case::Case& gap_case);
/// The empty template of the rig of a case: motor torques and stops as its rows have them.
[[nodiscard]] gap_case::CaseTemplate template_of(const gap_case::Case& gap_case);

}  // namespace fusee::effects
