#pragma once
#include "fusee/gap_case/break_away.h"

namespace fusee::gap_case {

/// Rows of one line: indices into all rows.
struct Group {
    std::string name;
    std::vector<std::size_t> rows;
};

/// Friction over load with the load that the motor torque alone explains as instrument (docs/theory/identification.md, eq. 3).
/// @param weights of all rows. Columns: constant, load.
[[nodiscard]] math::LinearModel line_model(const std::vector<BreakAway>& rows, const Group& group, const std::vector<double>& weights);

/// True for at least 3 rows whose loads differ by more than rounding.
[[nodiscard]] bool has_line(const math::LinearModel& model);

/// The group's rows beyond 4 robust deviations, in the group's order; none of fewer than 8 rows.
[[nodiscard]] std::vector<std::size_t> outliers_of(const Group& group, const math::RobustFit& robust);

/// @pre has_line(model)
[[nodiscard]] FrictionLine fit_line(const Group& group, const math::LinearModel& model);

/// How the scatter of the rows depends on the friction: variance = s^2 ((1 - growth) typical^2 + growth friction^2).
struct Scatter {
    double growth = 0.0;
    double typical = 1.0;  ///< root mean square of the frictions [Nm]
    [[nodiscard]] double weight(double friction) const;
};
/// The most likely growth for normal scatter. @param frictions on the line; of one length with residuals
[[nodiscard]] Scatter most_likely_scatter(const std::vector<double>& frictions, const std::vector<double>& residuals);

}  // namespace fusee::gap_case
