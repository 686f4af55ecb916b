#include "fusee/math/curve.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <thread>

#include "fusee/core/error.h"
#include "refused.h"

namespace fusee::math {
namespace {

struct Table {
    std::vector<double> x, y;
};
/// Rows at uneven places of [0.5, 2.5].
template <class F>
Table table(std::size_t rows, F f) {
    Table t;
    for (std::size_t i = 0; i < rows; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(rows - 1);
        t.x.push_back(0.5 + 2.0 * share + 0.1 * std::sin(2.0 * core::kPi * share));
        t.y.push_back(f(t.x.back()));
    }
    return t;
}
double quintic(double x) { return 1.0 + x * (-2.0 + x * (0.5 + x * (0.3 + x * (-0.2 + 0.04 * x)))); }

TEST(Interpolant, ReproducesAQuinticWithItsDerivatives) {
    for (const std::size_t rows : {6u, 7u, 12u, 40u}) {
        const Table t = table(rows, quintic);
        const CurvePtr curve = make_interpolant(t.x, t.y);
        EXPECT_EQ(curve->domain().low, 0.5);
        EXPECT_EQ(curve->domain().high, t.x.back());
        for (double x = 0.5; x <= 2.5; x += 0.013) {  // values of order 1; each derivative loses a factor of the rows' number
            EXPECT_NEAR(curve->value(x), quintic(x), 1e-13);
            EXPECT_NEAR(curve->derivative(x, 1), -2.0 + x * (1.0 + x * (0.9 + x * (-0.8 + 0.2 * x))), 1e-11);
            EXPECT_NEAR(curve->derivative(x, 2), 1.0 + x * (1.8 + x * (-2.4 + 0.8 * x)), 1e-9);
            EXPECT_NEAR(curve->derivative(x, 3), 1.8 + x * (-4.8 + 2.4 * x), 1e-7);
        }
    }
}

TEST(Interpolant, FewRowsGiveTheirPolynomial) {
    const auto cubic = [](double x) { return 0.3 + x * (0.2 + x * (-0.5 + 0.25 * x)); };
    for (const std::size_t rows : {4u, 5u}) {
        const Table t = table(rows, cubic);
        const CurvePtr curve = make_interpolant(t.x, t.y);
        for (double x = 0.5; x <= 2.5; x += 0.05) EXPECT_NEAR(curve->value(x), cubic(x), 1e-14);
        EXPECT_NEAR(curve->derivative(1.0, 3), 1.5, 1e-12);
    }
}

/// Error of the value and of the first derivative over the whole range, ends included.
std::pair<double, double> errors(std::size_t rows) {
    const Table t = table(rows, [](double x) { return std::exp(-x); });
    const CurvePtr curve = make_interpolant(t.x, t.y);
    std::pair<double, double> worst;
    for (double x = 0.5; x <= 2.5; x += 0.001) {
        worst.first = std::max(worst.first, std::abs(curve->value(x) - std::exp(-x)));
        worst.second = std::max(worst.second, std::abs(curve->derivative(x, 1) + std::exp(-x)));
    }
    return worst;
}

TEST(Interpolant, ConvergesWithTheSixthPowerOfTheStep) {
    const auto coarse = errors(16), fine = errors(31);  // half the step
    EXPECT_GT(coarse.first / fine.first, 45.0);         // 2^6 = 64 once the step is small
    EXPECT_GT(coarse.second / fine.second, 22.0);       // 2^5 = 32
    EXPECT_LT(fine.first, 5e-9);                        // step^6 = 9e-8 times the end's constant
}

TEST(Interpolant, PassesThroughManyRowsAndIsC4) {
    const Table t = table(3000, [](double x) { return std::sin(5.0 * x); });
    const CurvePtr curve = make_interpolant(t.x, t.y);
    for (std::size_t i = 0; i < t.x.size(); i += 37) EXPECT_NEAR(curve->value(t.x[i]), t.y[i], 1e-14);
    const Table few = table(12, [](double x) { return std::sin(5.0 * x); });
    const CurvePtr rough = make_interpolant(few.x, few.y);
    const double d = 1e-9;  // a step of 2 d across a knot changes the third derivative by 2 d times the fourth (about 5^4)
    for (std::size_t i = 3; i < 9; ++i)
        for (int order = 0; order <= 3; ++order)
            EXPECT_NEAR(rough->derivative(few.x[i] - d, order), rough->derivative(few.x[i] + d, order), 1e-5);
}

TEST(Formula, HasItsValuesAndDerivatives) {
    const CurvePtr curve = make_formula("law.dead_band", "0.9*exp(-2*tau) + 0.05/tau", "tau", {0.1, 2.5});
    for (double x = 0.1; x <= 2.5; x += 0.01) {
        const double e = 0.9 * std::exp(-2.0 * x), r = 0.05 / x;
        EXPECT_NEAR(curve->value(x), e + r, 1e-12 * (e + r));
        const double first = -2.0 * e - r / x, second = 4.0 * e + 2.0 * r / (x * x), third = -8.0 * e - 6.0 * r / (x * x * x);
        EXPECT_NEAR(curve->derivative(x, 1), first, 1e-9 * std::abs(first));
        EXPECT_NEAR(curve->derivative(x, 2), second, 1e-9 * std::abs(second));
        EXPECT_NEAR(curve->derivative(x, 3), third, 1e-7 * std::abs(third));
    }
    EXPECT_NEAR(make_formula("f", "0.35", "tau", {0.1, 2.5})->value(1.0), 0.35, 1e-16);
}

std::string refusal(const std::string& formula, core::Range domain = {0.2, 2.0}) {
    try {
        (void)make_formula("law.dead_band", formula, "tau", domain);
    } catch (const core::InvalidInput& error) {
        EXPECT_EQ(error.field(), "law.dead_band");
        return error.value();
    }
    return "accepted";
}

TEST(FormulaRefusal, SaysWhatIsWrongAndWhere) {
    const auto holds = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
    EXPECT_PRED2(holds, refusal("0.9*exp(-t)"), "\"0.9*exp(-t)\", at character 10: ");
    EXPECT_PRED2(holds, refusal("0.9*"), "\"0.9*\": ");
    EXPECT_PRED2(holds, refusal(""), "\"\": ");
    EXPECT_EQ(refusal("1/(tau - 0.2)"), "\"1/(tau - 0.2)\" is inf at tau = 0.2");
    EXPECT_PRED2(holds, refusal("sqrt(1 - tau)"), " at tau = ");
    EXPECT_PRED2(holds, refusal("1, tau"), "\"1, tau\"");
    for (const char* rough : {"abs(tau - 0.5)", "tau < 1 ? 0.5 : 0.4", "max(0.3, 1 - tau)", "0.5 + 0.1*abs(tau - 1.1)*(tau - 1.1)"})
        EXPECT_PRED2(holds, refusal(rough), "has a step or kink at tau = ");
    EXPECT_EQ(refusal("0.3 + 0.1*abs(tau - 1.1)^3"), "accepted");
    EXPECT_EQ(refusal("0.5", {1.0, 1.0}), "over 1 .. 1");
}

TEST(Formula, SteepButSmoothIsAccepted) {
    for (const char* formula : {"0.05/tau", "0.5 - 0.4*tanh(30*(tau - 1))", "0.1 + exp(-((tau - 1)/0.03)^2)", "tau^2.5", "ln(tau) + 5",
                                "sqrt(tau - 0.045)", "exp(-40*tau)", "1e-9 + 1e-12*tau", "0.3 + 0.1*sin(60*tau)"}) {
        const CurvePtr curve = make_formula("f", formula, "tau", {0.05, 2.5});
        EXPECT_GT(curve->value(1.3), 0.0) << formula;
    }
    // A thousandth of the largest value still has 12 digits.
    EXPECT_NEAR(make_formula("f", "exp(-5*tau)", "tau", {0.05, 2.5})->value(1.43), std::exp(-7.15), 1e-12 * std::exp(-7.15));
}

/// muParser evaluates into its own variable; what make_formula returns does not, and making takes place on any thread.
TEST(Formula, IsTheSameFromEveryThread) {
    const auto sample = [](double& sum) {
        const CurvePtr curve = make_formula("f", "sin(3*tau) + 1.2*exp(-tau)", "tau", {0.1, 2.5});
        for (int i = 0; i <= 2000; ++i) sum += curve->value(0.1 + 0.0012 * i) * curve->derivative(0.1 + 0.0012 * i, 1);
    };
    std::array<double, 8> sums{};
    std::vector<std::thread> threads;
    for (double& sum : sums) threads.emplace_back(sample, std::ref(sum));
    for (std::thread& thread : threads) thread.join();
    for (const double sum : sums) EXPECT_EQ(sum, sums[0]);
}

/// A kink at any place, of the value or of the first two derivatives, is seen; a jump of the third derivative passes.
TEST(Formula, KinksAreSeenWhereverTheyLie) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0.25, 1.95);
    for (int i = 0; i < 200; ++i) {
        const double kink = place(random);
        const auto about = [&](const char* text) { return fmt::format(fmt::runtime(text), kink); };
        for (const char* rough : {"1 + (tau < {0} ? 0 : 0.1)", "1 + 0.1*abs(tau - {0})", "1 + 0.1*abs(tau - {0})*(tau - {0})"})
            EXPECT_NE(refusal(about(rough)), "accepted") << about(rough);
        EXPECT_EQ(refusal(about("1 + 0.1*abs(tau - {0})^3")), "accepted") << kink;
    }
}

TEST(TableRefusal, NamesColumnAndRow) {
    const auto field = [](const std::vector<double>& x, const std::vector<double>& y) {
        return field_refused([&] { return make_interpolant(x, y); });
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(field({0, 1, 2}, {0, 1, 2}), "x");
    EXPECT_EQ(field({0, 1, 2, 3}, {0, 1, 2}), "y");
    EXPECT_EQ(field({0, 1, 1, 3}, {0, 1, 2, 3}), "x[2]");
    EXPECT_EQ(field({0, 1, nan, 3}, {0, 1, 2, 3}), "x[2]");
    EXPECT_EQ(field({0, 1, 2, 3}, {0, 1, 2, nan}), "y[3]");
}

}  // namespace
}  // namespace fusee::math
