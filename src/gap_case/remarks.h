#pragma once
#include "friction_line.h"

namespace fusee::gap_case {

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
