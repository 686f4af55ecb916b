#pragma once
#include <boost/numeric/interval.hpp>
#include <cmath>
#include <limits>

#include "fusee/core/units.h"

namespace fusee::math {

/// Outward rounding of interval bounds. The machine rounds to nearest, and the bound is then moved outwards: by one double for + - * / and
/// the square root, which IEEE 754 rounds correctly; by `kUlps` for the elementary functions, for which the C library promises 1 ulp (glibc
/// manual, "Known Maximum Errors in Math Functions"; 2 elsewhere). No rounding mode is switched, so that neither code motion by the
/// compiler nor threads matter.
struct OutwardRounding : boost::numeric::interval_lib::rounded_arith_exact<double> {
    using unprotected_rounding = OutwardRounding;
    static constexpr int kUlps = 4;

    /// |x| times 2^-52 is at least a unit in x's last place, exact unless it underflows; there the least double is enough. (std::nextafter
    /// would take half of a proof's time.) An infinite bound on the wrong side becomes NaN: it proves nothing.
    static double step(double x, int ulps) {
        return ulps * std::numeric_limits<double>::epsilon() * std::abs(x) + std::numeric_limits<double>::denorm_min();
    }
    static double below(double x) { return x - step(x, 1); }
    static double above(double x) { return x + step(x, 1); }
    static double well_below(double x) { return x - step(x, kUlps); }
    static double well_above(double x) { return x + step(x, kUlps); }

    double add_down(double x, double y) const { return below(x + y); }
    double add_up(double x, double y) const { return above(x + y); }
    double sub_down(double x, double y) const { return below(x - y); }
    double sub_up(double x, double y) const { return above(x - y); }
    double mul_down(double x, double y) const { return below(x * y); }
    double mul_up(double x, double y) const { return above(x * y); }
    double div_down(double x, double y) const { return below(x / y); }
    double div_up(double x, double y) const { return above(x / y); }
    double sqrt_down(double x) const { return below(std::sqrt(x)); }
    double sqrt_up(double x) const { return above(std::sqrt(x)); }
    double exp_down(double x) const { return well_below(std::exp(x)); }
    double exp_up(double x) const { return well_above(std::exp(x)); }
    double cos_down(double x) const { return well_below(std::cos(x)); }
    double cos_up(double x) const { return well_above(std::cos(x)); }
    double acos_down(double x) const { return well_below(std::acos(x)); }
    double acos_up(double x) const { return well_above(std::acos(x)); }
};

/// All numbers between two bounds. The result of a formula on intervals encloses its result for any numbers inside them.
/// An operation without a value (0/0) gives NaN bounds: they satisfy no comparison, so they prove nothing.
using Interval =
    boost::numeric::interval<double,
                             boost::numeric::interval_lib::policies<OutwardRounding, boost::numeric::interval_lib::checking_base<double>>>;

[[nodiscard]] inline Interval whole_line() { return Interval::whole(); }
[[nodiscard]] inline core::Range range_of(const Interval& x) { return {x.lower(), x.upper()}; }
[[nodiscard]] inline double middle(const Interval& x) { return 0.5 * (x.lower() + x.upper()); }
/// The intersection. @pre both enclose the same number, so they meet
[[nodiscard]] Interval common(const Interval& a, const Interval& b);
[[nodiscard]] Interval expm1(const Interval& x);
[[nodiscard]] Interval log1p(const Interval& x);

/// A function of one parameter over a box: value and first derivative, both enclosed. A formula written for any number type computes them
/// from Jet::parameter(box): differentiation by the chain rule.
struct Jet {
    Interval value, slope;

    Jet() = default;
    Jet(double constant) : value(constant), slope(0.0) {}  // NOLINT(google-explicit-constructor): a number is a constant function
    Jet(const Interval& v, const Interval& s) : value(v), slope(s) {}
    [[nodiscard]] static Jet parameter(const Interval& box) { return {box, Interval(1.0)}; }
    [[nodiscard]] static Jet anything() { return {whole_line(), whole_line()}; }

    friend Jet operator-(const Jet& a) { return {-a.value, -a.slope}; }
    friend Jet operator+(const Jet& a, const Jet& b) { return {a.value + b.value, a.slope + b.slope}; }
    friend Jet operator-(const Jet& a, const Jet& b) { return {a.value - b.value, a.slope - b.slope}; }
    friend Jet operator*(const Jet& a, const Jet& b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
    friend Jet operator/(const Jet& a, const Jet& b) {
        const Interval quotient = a.value / b.value;
        return {quotient, (a.slope - quotient * b.slope) / b.value};
    }
    Jet& operator+=(const Jet& b) { return *this = *this + b; }
    Jet& operator-=(const Jet& b) { return *this = *this - b; }
    Jet& operator/=(const Jet& b) { return *this = *this / b; }
};

[[nodiscard]] Jet sqrt(const Jet& x);
[[nodiscard]] Jet exp(const Jet& x);
[[nodiscard]] Jet expm1(const Jet& x);
[[nodiscard]] Jet log1p(const Jet& x);
[[nodiscard]] Jet acos(const Jet& x);
/// x^3; of a double it is std::pow's.
[[nodiscard]] Jet cube(const Jet& x);
[[nodiscard]] inline double cube(double x) { return std::pow(x, 3); }

}  // namespace fusee::math
