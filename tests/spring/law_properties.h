#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "fusee/spring/law.h"

namespace fusee::spring {

/// The energies are what the torques have done on the way, by Gauss's rule over the load: dU = F dtheta = F/(S + P) dtau. It shares no
/// line with any law's own integration.
inline void expect_energy_balance(const SpringLaw& law, double relative) {
    constexpr int kPieces = 400;  // of 5 points: kinks in a stiffness's curvature cost (1/400)^3
    double u_se = 0.0, u_pe = 0.0, theta = 0.0;
    const core::Range loads = law.loads();
    for (int i = 0; i < kPieces; ++i) {
        const double low = std::lerp(loads.low, loads.high, double(i) / kPieces),
                     high = std::lerp(loads.low, loads.high, (i + 1.0) / kPieces);
        using Gauss = boost::math::quadrature::gauss<double, 5>;
        const auto over = [&](auto f) { return Gauss::integrate([&](double tau) { return f(law.at_load(tau)); }, low, high); };
        theta += over([](const LawPoint& p) { return 1.0 / (p.s + p.p); });
        u_se += over([](const LawPoint& p) { return p.f_se / (p.s + p.p); });
        u_pe += over([](const LawPoint& p) { return p.f_pe / (p.s + p.p); });
    }
    const LawPoint end = law.at_load(loads.high);
    EXPECT_NEAR(theta, end.theta, 0.1 * relative * end.theta);
    EXPECT_NEAR(u_se, end.u_se, 0.1 * relative * end.u_se);
    EXPECT_NEAR(u_pe, end.u_pe, 0.1 * relative * end.u_pe);
}

/// Load, angle, torques and energies rise together, from the law's lower end to its upper one and to nowhere else.
inline void expect_rising(const SpringLaw& law) {
    const auto points = sample_by_load(law, 101);
    for (std::size_t i = 1; i < points.size(); ++i)
        for (const auto member : {&LawPoint::tau, &LawPoint::theta, &LawPoint::f_se, &LawPoint::f_pe, &LawPoint::u_se, &LawPoint::u_pe})
            EXPECT_GT(points[i].*member, points[i - 1].*member) << i;
    const core::Range loads = law.loads(), angles = law.angles();
    EXPECT_EQ(law.at_load(0.5 * loads.low).tau, loads.low);
    EXPECT_EQ(law.at_load(2.0 * loads.high).tau, loads.high);
    EXPECT_EQ(law.at_angle(-1.0).theta, 0.0);
    EXPECT_EQ(law.at_angle(2.0 * angles.high).theta, angles.high);
}

/// What holds for every law: forces are the slopes of the energies, stiffnesses those of the forces, load and angle name the same point.
/// Central differences over h err by h^2/6 of the third derivative and by rounding eps |f|/h; `relative` must cover both.
inline void expect_lawful(const SpringLaw& law, double relative) {
    const core::Range angles = law.angles();
    ASSERT_EQ(angles.low, 0.0);
    const LawPoint start = law.at_angle(0.0), end = law.at_angle(angles.high);
    // The inverse's last digit of the start load, which matters more for narrow laws: with a width of 5 % of its start, 3e-14.
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
    expect_energy_balance(law, relative);
    expect_rising(law);
}

/// A lead-in goes on from the law with the same forces, stiffnesses and slopes of these (U is C3), and both together are lawful.
inline void expect_smooth_lead_in(const SpringLawPtr& law, double travel) {
    const auto longer = with_lead_in(law, travel);
    ASSERT_TRUE(longer);
    const LawPoint start = law->at_angle(0.0), low = (*longer)->at_angle(0.0), at = (*longer)->at_angle(travel);
    const double d = 1e-9 * travel;
    const LawPoint below = (*longer)->at_angle(travel - d), above = (*longer)->at_angle(travel + d);
    for (const auto member : {&LawPoint::f_se, &LawPoint::f_pe, &LawPoint::s, &LawPoint::p, &LawPoint::s_slope, &LawPoint::p_slope}) {
        // A step of 2e-9 of the travel changes each by about as much of itself.
        const double size = std::abs(start.*member) + std::abs(low.*member);
        EXPECT_NEAR(at.*member, start.*member, 1e-13 * size);
        EXPECT_NEAR(below.*member, above.*member, 1e-7 * size);
    }
    EXPECT_EQ(low.s_slope, 0.0);
    EXPECT_EQ(low.p_slope, 0.0);
    EXPECT_TRUE(check_law(**longer).empty());
}

}  // namespace fusee::spring
