#pragma once
#include <string>
#include <vector>

#include "fusee/spring/law.h"
#include "fusee/spring/stiction_law.h"

// What several makers of laws ask of their options and points.
namespace fusee::spring {

/// @throws InvalidInput naming law.start_torque_Nm or law.end_torque_Nm unless 0 < start < end
core::Range require_torques(double start, double end);

/// @throws InvalidInput as make_stiction_law
void validate(const StictionLawOptions& options);

/// The part of `check_law` that needs only loads and stiffnesses: 0 < T < 1 and S > 0 on points by rising load.
[[nodiscard]] core::Findings check_stiffnesses(const std::vector<LawPoint>& points);

/// The longest way out for a law that breaks from point `first` to point `last`: end before the first, or start after the last one if it
/// breaks at its start.
[[nodiscard]] std::string nearest_feasible(const std::vector<LawPoint>& points, std::size_t first, std::size_t last);

/// Loads at which a whole range is looked over, both ends included.
[[nodiscard]] std::vector<double> scan_loads(core::Range loads);

}  // namespace fusee::spring
