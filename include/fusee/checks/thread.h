#pragma once
#include "fusee/checks/limits.h"

namespace fusee::checks {

/// Safety where the material is good, springs bound the load, and the stress comes from a good analysis (Pugsley's table, caetool.com).
inline constexpr double kSafety = 1.45;

/// Pull that strips a thread out of a material [N]: 0.875 pi d L, along which a 60 deg thread shears, at half the strength (practice).
/// @param diameter d of the screw [m] @param length L in the thread [m]
[[nodiscard]] double thread_strength(double diameter, double length, const Material& material);

}  // namespace fusee::checks
