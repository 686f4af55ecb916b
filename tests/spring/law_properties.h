#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fusee/spring/law.h"

namespace fusee::spring {

/// What holds for every law: forces are the slopes of the energies, stiffnesses those of the forces, load and angle name the same point.
/// Central differences over h err by h^2/6 of the third derivative and by rounding eps |f|/h; `relative` must cover both.
inline void expect_lawful(const SpringLaw& law, double relative) {
    const core::Range angles = law.angles();
    ASSERT_EQ(angles.low, 0.0);
    const LawPoint start = law.at_angle(0.0), end = law.at_angle(angles.high);
    // The inverse's last digit of the start load, which weighs the more the narrower the law is: 5 % of its start gives 3e-14.
    EXPECT_NEAR(start.u_se, 0.0, 1e-12 * end.u_se);
    EXPECT_NEAR(start.u_pe, 0.0, 1e-12 * end.u_pe);
    EXPECT_NEAR(start.tau, law.loads().low, 1e-13 * end.tau);
    EXPECT_NEAR(end.tau, law.loads().high, 1e-13 * end.tau);
    const double h = 1e-5 * angles.width();
    for (int i = 1; i < 40; ++i) {
        const double theta = angles.low + angles.width() * i / 40.0;
        const LawPoint p = law.at_angle(theta), below = law.at_angle(theta - h), above = law.at_angle(theta + h);
        const auto slope = [&](auto member) { return (above.*member - below.*member) / (2.0 * h); };
        EXPECT_NEAR(slope(&LawPoint::u_se), p.f_se, relative * end.f_se) << theta;
        EXPECT_NEAR(slope(&LawPoint::u_pe), p.f_pe, relative * end.f_pe) << theta;
        EXPECT_NEAR(slope(&LawPoint::f_se), p.s, relative * std::abs(p.s)) << theta;
        EXPECT_NEAR(slope(&LawPoint::f_pe), p.p, relative * std::abs(p.p)) << theta;
        EXPECT_NEAR(slope(&LawPoint::s), p.s_slope, relative * (std::abs(p.s_slope) + p.s / angles.width())) << theta;
        EXPECT_NEAR(slope(&LawPoint::p), p.p_slope, relative * (std::abs(p.p_slope) + p.p / angles.width())) << theta;
        EXPECT_NEAR(p.tau, p.f_se + p.f_pe, 1e-13 * end.tau);
        const LawPoint same = law.at_load(p.tau);  // near an asymptote the angle knows little of the load: compared in load
        EXPECT_NEAR(same.theta, theta, 1e-12 * angles.width() + 1e-13 * end.tau / (p.s + p.p));
        EXPECT_NEAR(same.u_se, p.u_se, 1e-12 * end.u_se);
    }
}

}  // namespace fusee::spring
