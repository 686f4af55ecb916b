#pragma once
#include <string>
#include <vector>

#include "fusee/gap_case/case_template.h"

namespace fusee::diagnosis {

/// A measurement to propose.
struct Measurement {
    gap_case::Experiment experiment = gap_case::Experiment::kBreakAway;
    std::size_t sheet = 0;          ///< of the menu
    std::vector<std::size_t> rows;  ///< of the experiment's in that sheet
    int repeats = 1;                ///< of each row
    std::string what;               ///< instruction without a full stop
    std::string variable;
    std::vector<double> set_points;
    double cost = 0.0;  ///< [min] (docs/theory/isolability.md, "What a measurement costs")
};

/// Rows to predict once, and measurements made of some of them: the rows of a sheet are independent.
struct Menu {
    std::vector<gap_case::Rows> sheets;
    std::vector<Measurement> measurements;
};

/// Every experiment with the set points of a case template, and its parts: one side, one spring, the lowest and the highest level alone, a
/// stronger push, a faster and a slower log. Torques stay within the range of the case.
[[nodiscard]] Menu measurement_menu(const gap_case::Case& gap_case);
/// The empty template of the rig of a case: motor torques and stops as its rows have them.
[[nodiscard]] gap_case::CaseTemplate template_of(const gap_case::Case& gap_case);
/// Instruction, expected information [bit] and cost as one sentence.
[[nodiscard]] std::string sentence_of(const Measurement& measurement, double bits);

}  // namespace fusee::diagnosis
