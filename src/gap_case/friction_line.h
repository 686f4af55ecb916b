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

/// Input of all tests.
struct Fitted {
    const std::vector<BreakAway>& rows;
    const std::vector<double>& weights;
    FrictionLine trusted;                         ///< all rows but the outliers
    std::vector<FrictionLine> directions, sides;  ///< empty if there is only one
    std::vector<Group> finest;                    ///< each side and direction that has a line; "all" if none has
    std::vector<std::size_t> outliers;            ///< of the finest groups, ascending
    Scatter scatter;
};

inline constexpr double kChance = 0.01;     ///< significance level of a remark
inline constexpr double kRounding = 1e-20;  ///< variance of a coefficient due to rounding, for rows without scatter

/// "0.280 (0.275 to 0.285)"
[[nodiscard]] std::string with_interval(double value, const core::Range& range);

[[nodiscard]] std::vector<FrictionRemark> remarks_on(const Fitted& fitted);

}  // namespace fusee::gap_case
