#pragma once
#include <string>

#include "fusee/checks/check.h"

/// The nearest feasible base spring, in the words of the profile. All of it keeps the law: the energy that the spring takes up stays.
namespace fusee::checks {

/// Largest deflection of the base spring over the working range, preload counted [rad or m].
double largest_state(const Design& design);

/// Rate and preload with which every arm is `factor` times as long. K_SE: r = sqrt((k_t phi0)^2 + 2 k_t U)/U', so k_t f^2 and phi0/f;
/// K_PE: r = U'/sqrt((k y0)^2 + 2 k U), so k/f^2 and y0 f.
std::string scale_arms(const Design& design, double factor);

/// A preload, or a rate, or both in the proportion of `scale_arms`, with which the largest state is `state` [rad or m].
std::string limit_state(const Design& design, double state);

/// A preload, or a rate, with which the largest load is `load` [Nm or N].
std::string limit_load(const Design& design, double load);

}  // namespace fusee::checks
