#pragma once
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "fusee/joint_model/built_rig.h"

namespace fusee::fixtures {

/// A rig with straight springs, F_SE = kSeries x and F_PE = kParallel theta, so that its motion is known in closed form.
inline constexpr double kSeries = 0.3, kParallel = 0.2;  // [Nm/rad]
inline gap_case::NominalRig straight_rig() {
    gap_case::NominalRig rig{.capstan_radius = 0.015,
                             .joint_radius = 0.03,
                             .gear_load_friction = 0.25,
                             .motor_inertia = 2e-3,
                             .joint_inertia = 6e-3,
                             .motor_viscous = 4e-3,
                             .joint_viscous = 2e-3,
                             .se_torsion_rate = 0.4,
                             .pe_compression_rate = 2000.0,
                             .springs = {}};
    for (int i = 0; i <= 20; ++i) rig.springs.push_back({0.2 * i, 0.2 * i * kSeries, 0.2 * i * kParallel});
    return rig;
}

/// The same rig with springs that stiffen: F = a x + b x^2.
struct Stiffening {
    double a, b;
    [[nodiscard]] double torque(double x) const { return x * (a + b * x); }
    [[nodiscard]] double energy(double x) const { return x * x * (a / 2.0 + b * x / 3.0); }
};
inline constexpr Stiffening kSe{0.25, 0.05}, kPe{0.15, 0.06};
inline constexpr double kEnd = 4.0;  // [rad]
inline gap_case::NominalRig stiffening_rig() {
    gap_case::NominalRig rig = straight_rig();
    rig.springs.clear();
    for (int i = 0; i <= 80; ++i) {
        const double x = kEnd * i / 80.0;
        rig.springs.push_back({x, kSe.torque(x), kPe.torque(x)});
    }
    return rig;
}

/// As built without any fault, or with what `change` does to it.
template <typename Change>
joint_model::BuiltRig built(const gap_case::NominalRig& nominal, const Change& change) {
    joint_model::BuiltRig rig(nominal);
    change(rig);
    rig.assemble(joint_model::NominalCams(nominal));
    return rig;
}
inline joint_model::BuiltRig faultless(const gap_case::NominalRig& nominal) {
    return built(nominal, [](joint_model::BuiltRig&) {});
}

/// Spans of what was compared, for messages and limits.
inline double farthest(const std::vector<double>& a, const std::vector<double>& b) {
    double most = a.size() == b.size() ? 0.0 : 1e300;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

}  // namespace fusee::fixtures
