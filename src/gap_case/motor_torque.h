#pragma once
#include "friction_line.h"

/// Friction and an error of the motor's torque constant: distinguished where a motor has both directions, and nowhere else.
namespace fusee::gap_case {

/// The motors with both directions, by name; not those with too few rows for an interval.
/// @param left_out rows that do not count, ascending @param weights of all rows
[[nodiscard]] std::vector<FrictionReport::Motor> motors_of(const std::vector<BreakAway>& rows, const std::vector<std::size_t>& left_out,
                                                           const std::vector<double>& weights);

/// The motors with one direction only, by name.
[[nodiscard]] std::vector<FrictionReport::OneWay> one_way_motors(const std::vector<BreakAway>& rows,
                                                                 const std::vector<std::size_t>& left_out,
                                                                 const std::vector<double>& weights);

/// The rows with the torque that the motors give: times `scale` of those that differ.
[[nodiscard]] std::vector<BreakAway> with_true_torques(std::vector<BreakAway> rows, const std::vector<FrictionReport::Motor>& motors);

[[nodiscard]] FrictionRemark remark_on(const std::vector<FrictionReport::Motor>& motors);
[[nodiscard]] FrictionRemark remark_on(const FrictionReport::OneWay& motor);

}  // namespace fusee::gap_case
