#pragma once
#include <string>

#include "fusee/design/budget.h"

/// The error budget of a joint as text and as JSON (docs/guides/budget.md).
namespace fusee::report {

/// What a budget belongs to.
struct BudgetTitle {
    std::string name;  ///< of the design
    std::string process;
};

/// Writes the budget for a terminal: bands of torque and dead-band, the share of each source, and the tolerances for a band of +-`wanted`
/// (relative).
[[nodiscard]] std::string budget_text(const BudgetTitle& title, const design::budget::Budget& budget, double wanted);
/// The same as JSON, lengths in mm, angles in deg.
[[nodiscard]] std::string budget_json(const BudgetTitle& title, const design::budget::Budget& budget, double wanted);

/// "0.3 mm", "10 %", "0.5 deg"
[[nodiscard]] std::string limit_text(const design::budget::PartBudget& part, design::budget::Source source, double limit);

}  // namespace fusee::report
