#pragma once
#include <vector>

#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"

// Checks of options and points that several laws share.
namespace fusee::spring {

/// @throws InvalidInput naming law.start_torque_Nm or law.end_torque_Nm unless 0 < start < end
core::Range require_torques(double start, double end);

/// @throws InvalidInput as make_stiction_law
void validate(const StictionLawOptions& options);

/// The part of `check_law` that needs only loads and stiffnesses: 0 < T < 1 and S > 0 on points by rising load.
[[nodiscard]] core::Findings check_stiffnesses(const std::vector<LawPoint>& points);

/// The suggestion for a law that fails from point `first` to point `last`: end before the first, or start after the last one if it fails
/// at its start; words where less than a fifth of the loads would be left.
[[nodiscard]] core::Suggestion nearest_feasible(const std::vector<LawPoint>& points, std::size_t first, std::size_t last);

/// Loads for a scan of a whole range, both ends included.
[[nodiscard]] std::vector<double> scan_loads(core::Range loads);

}  // namespace fusee::spring
