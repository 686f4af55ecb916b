#include "fusee/math/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "fusee/math/curve.h"
#include "math/callable.h"

namespace fusee::math {
namespace {

using Wide = long double;  // 64 bits of mantissa: tells on which side of a double the truth lies

struct Operation {
    const char* name;
    std::function<Jet(const Jet&)> on_boxes;
    std::function<Wide(Wide)> truth, slope;
};

const std::array kOperations{
    Operation{"sum", [](const Jet& x) { return x + 0.3; }, [](Wide x) { return x + Wide(0.3); }, [](Wide) { return 1.0L; }},
    Operation{"difference", [](const Jet& x) { return 0.3 - x; }, [](Wide x) { return Wide(0.3) - x; }, [](Wide) { return -1.0L; }},
    Operation{"product", [](const Jet& x) { return x * x; }, [](Wide x) { return x * x; }, [](Wide x) { return 2 * x; }},
    Operation{"quotient", [](const Jet& x) { return 1.0 / x; }, [](Wide x) { return 1 / x; }, [](Wide x) { return -1 / (x * x); }},
    Operation{"sqrt", [](const Jet& x) { return sqrt(x); }, [](Wide x) { return std::sqrt(x); },
              [](Wide x) { return 0.5L / std::sqrt(x); }},
    Operation{"exp", [](const Jet& x) { return exp(x); }, [](Wide x) { return std::exp(x); }, [](Wide x) { return std::exp(x); }},
    Operation{"expm1", [](const Jet& x) { return expm1(x); }, [](Wide x) { return std::expm1(x); }, [](Wide x) { return std::exp(x); }},
    Operation{"log1p", [](const Jet& x) { return log1p(x); }, [](Wide x) { return std::log1p(x); }, [](Wide x) { return 1 / (1 + x); }},
    Operation{"acos", [](const Jet& x) { return acos(x); }, [](Wide x) { return std::acos(x); },
              [](Wide x) { return -1 / std::sqrt(1 - x * x); }},
    Operation{"cube", [](const Jet& x) { return cube(x); }, [](Wide x) { return x * x * x; }, [](Wide x) { return 3 * x * x; }},
};

bool encloses(const Interval& bounds, Wide truth) { return Wide(bounds.lower()) <= truth && truth <= Wide(bounds.upper()); }

TEST(Interval, EnclosesWhatAWiderTypeFinds) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inside(0.001, 0.999);
    for (const Operation& op : kOperations)
        for (int i = 0; i < 2000; ++i) {
            const double a = inside(random), b = i % 2 == 0 ? a : inside(random);  // points and boxes
            const Interval box(std::min(a, b), std::max(a, b));
            const Jet got = op.on_boxes(Jet::parameter(box));
            const Wide x = std::clamp(Wide(std::lerp(a, b, inside(random))), Wide(box.lower()), Wide(box.upper()));
            ASSERT_TRUE(encloses(got.value, op.truth(x))) << op.name << " at " << a;
            ASSERT_TRUE(encloses(got.slope, op.slope(x))) << op.name << "' at " << a;
            if (a == b) {
                ASSERT_LT(boost::numeric::width(got.value), 4e-15 * std::abs(middle(got.value)) + 1e-15) << op.name;
            }
        }
}

TEST(Interval, ClaimsNothingOutsideADomain) {
    const Interval box(-0.5, 2.0);
    for (const Jet& lost : {sqrt(Jet::parameter(box)), acos(Jet::parameter(box)), 1.0 / Jet::parameter(box)}) {
        EXPECT_FALSE(lost.value.lower() > -1e300);
        EXPECT_FALSE(lost.value.upper() < 1e300);
    }
    const Interval nothing = Interval(0.0) / Interval(0.0);
    EXPECT_FALSE(nothing.lower() > 0.0);  // and it satisfies no other comparison
    EXPECT_FALSE(nothing.upper() <= 0.0);
}

std::vector<double> rows(double from, double step, int count) {
    std::vector<double> x;
    for (int i = 0; i < count; ++i) x.push_back(from + step * i);
    return x;
}

TEST(EnclosedCurve, BoundsItsPointsAndItsDerivatives) {
    const std::vector<double> x = rows(0.5, 0.1, 21);
    std::vector<double> y;
    for (const double at : x) y.push_back(std::sin(3.0 * at) + 2.0);
    const std::vector<CurvePtr> curves{make_interpolant(x, y), make_formula("f", "exp(-tau)+tau^3", "tau", {0.5, 2.5}),
                                       make_scaled(make_formula("f", "48*tau^-2.2", "tau", {0.5, 2.5}), 0.0174532925)};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const CurvePtr& curve : curves) {
        const std::vector<double> places = breaks(*curve);
        ASSERT_GE(places.size(), 2u);
        EXPECT_EQ(places.front(), 0.5);
        EXPECT_EQ(places.back(), 2.5);
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
            for (int order = 0; order <= 2; ++order) {
                const double a = std::lerp(places[i], places[i + 1], share(random)), b = std::lerp(places[i], places[i + 1], share(random));
                const Jet bounds = derivative(*curve, Jet::parameter({std::min(a, b), std::max(a, b)}), order);
                const double at = std::lerp(a, b, share(random)), value = curve->derivative(at, order),
                             next = curve->derivative(at, order + 1);
                // The points carry the rounding of their evaluation, and a series' next derivative that of its coefficients.
                EXPECT_TRUE(boost::numeric::in(value, bounds.value + 1e-9 * Interval(-1.0, 1.0))) << order << ": " << at;
                EXPECT_TRUE(boost::numeric::in(next, bounds.slope + 1e-7 * Interval(-1.0, 1.0))) << order << ": " << at;
                const Jet point = derivative(*curve, Jet::parameter(Interval(at)), order);
                EXPECT_NEAR(middle(point.value), value, 1e-10 * (1.0 + std::abs(value)));
                EXPECT_LT(boost::numeric::width(point.value), 1e-9);
            }
    }
}

TEST(EnclosedCurve, IsAnythingWhereOnlyPointsAreKnown) {
    const CurvePtr curve = fixtures::make_curve([](double x, int order) { return order == 0 ? x : 1.0; }, {0.0, 1.0});
    EXPECT_EQ(breaks(*curve), (std::vector{0.0, 1.0}));
    EXPECT_TRUE(std::isinf(derivative(*curve, Jet::parameter({0.2, 0.3}), 0).value.upper()));
}

}  // namespace
}  // namespace fusee::math
