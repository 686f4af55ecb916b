#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "fusee/cam/arm.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"

namespace fusee::cam::test {

inline constexpr double kCapstan = 0.03;  // [m]

/// The paper's kind of law with base springs for possible arms.
inline spring::SpringLawPtr stiction_law() { return spring::make_stiction_law({0.225, 0.0012, 0.265, 0.28, 0.6, 2.09}).value(); }
inline spring::BaseSpring torsion(double rate = 0.0183, double preload = 4.0) {
    spring::BaseSpring s;
    s.kind = spring::BaseKind::kTorsion;
    s.rate = rate;
    s.preload = preload;
    return s;
}
inline spring::BaseSpring compression(double rate = 7460.0, double preload = 0.0148) {
    spring::BaseSpring s;
    s.kind = spring::BaseKind::kCompression;
    s.rate = rate;
    s.preload = preload;
    return s;
}
inline ArmFunction series_arm() { return {PartKind::kSeries, stiction_law(), torsion(), kCapstan}; }
inline ArmFunction parallel_arm() { return {PartKind::kParallel, stiction_law(), compression(), kCapstan}; }

/// Soft springs over more than a turn and a half of capstan, for cams that must be helical.
inline spring::SpringLawPtr long_law() {
    return spring::make_pair_law(spring::make_polynomial({0.02, 0.01, 0.003}), spring::make_polynomial({0.05, 0.02, 0.006}), 0.1, 1.5)
        .value();
}
inline ArmFunction long_parallel_arm() { return {PartKind::kParallel, long_law(), compression(1500.0, 0.008), kCapstan}; }

/// Slope and second derivative against central differences over a load step, by the cam's own angle; their error is O(step^2).
inline void expect_derivatives(const ArmFunction& arm, std::initializer_list<double> loads) {
    for (const double tau : loads) {
        const double h = 2e-4;
        const ArmPoint low = arm.at_load(tau - h), mid = arm.at_load(tau), high = arm.at_load(tau + h);
        const double width = high.angle - low.angle;
        EXPECT_NEAR((high.arm - low.arm) / width, mid.slope, 2e-5 * std::abs(mid.slope) + 1e-7) << tau;
        EXPECT_NEAR((high.slope - low.slope) / width, mid.second_derivative, 2e-5 * std::abs(mid.second_derivative) + 1e-6) << tau;
    }
}

}  // namespace fusee::cam::test
