#pragma once
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "fusee/design/algorithm_1.h"

/// Algorithm 1's cost the way the paper describes it, with Boost: what the closed form is compared with, in value and in time. Only what
/// the paper asks for is computed, each integral goes on from the last one, and each root begins where the last one was found.
namespace fusee::design {

/// U3 and U4 of one (k, u, C), known by their second derivatives over the capstan's angle: P(12), (16) and (17) inverted.
class NumericSprings {
public:
    struct Torques {
        double theta = 0.0, f_se = 0.0, f_pe = 0.0;
    };

    /// @param start load at theta = 0 [Nm]; F_SE is T(start) start there
    NumericSprings(double k, double a, double c, double start) : k_(k), a_(a), c_(c), start_(start), limit_(angle_below_asymptote(start)) {
        const double f_se = transmission(start) * start;
        base_ = {0.0, f_se, start - f_se};
    }

    [[nodiscard]] const Torques& base() const { return base_; }
    /// From here the next integrals go on.
    void move_to(const Torques& base) { base_ = base; }

    [[nodiscard]] double series_stiffness(double theta) const {
        const double tau = load(theta);
        return k_ * tau * tau;
    }
    [[nodiscard]] double parallel_stiffness(double theta) const {
        const double tau = load(theta);
        return (1.0 / transmission(tau) - 1.0) * k_ * tau * tau;
    }
    /// First integrals of U3'' and U4''.
    [[nodiscard]] Torques torques(double theta) const {
        return {theta, base_.f_se + integral([this](double at) { return series_stiffness(at); }, base_.theta, theta),
                base_.f_pe + integral([this](double at) { return parallel_stiffness(at); }, base_.theta, theta)};
    }
    /// Second integral of U3'' + U4'' from the base on, by Cauchy's formula: the energy that co-contraction stores.
    [[nodiscard]] double energy_gained(double theta) const {
        const double h = theta - base_.theta;
        return (base_.f_se + base_.f_pe) * h +
               integral([&](double at) { return (theta - at) * (series_stiffness(at) + parallel_stiffness(at)); }, base_.theta, theta);
    }

private:
    [[nodiscard]] double transmission(double tau) const { return (a_ / tau + c_) / tau; }
    /// P(17) with its sign: theta_inf - theta
    [[nodiscard]] double angle_below_asymptote(double tau) const { return (a_ / (3.0 * tau) + c_ / 2.0) / (k_ * tau * tau); }

    /// P(17) solved for the load by Newton's rule, from the start's side.
    [[nodiscard]] double load(double theta) const {
        double v = 1.0 / start_;
        for (int i = 0; i < 60; ++i) {
            const double step = (v * v * (a_ * v / 3.0 + c_ / 2.0) - k_ * (limit_ - theta)) / (v * (a_ * v + c_));
            v -= step;
            if (std::abs(step) < 1e-14 * v) break;
        }
        return 1.0 / v;
    }

    template <class F>
    [[nodiscard]] static double integral(const F& f, double from, double to) {
        // Over [0, 1]: Boost 1.74 compares the error per unit length with the whole integral, and would halve a short interval to no end.
        const double length = to - from;
        const auto over_unit = [&](double share) { return f(from + share * length); };
        return length * boost::math::quadrature::gauss_kronrod<double, 15>::integrate(over_unit, 0.0, 1.0, 10, 1e-10);
    }

    double k_, a_, c_, start_, limit_;
    Torques base_;
};

class NumericAlgorithm1 {
public:
    explicit NumericAlgorithm1(const Algorithm1& like) : options_(like.options()), rig_(like.rig()), loads_(like.loads()) {}

    struct Result {
        double cost = 0.0;
        double stored_energy = 0.0;  ///< of one side's springs at the peak torque [J]
    };
    [[nodiscard]] double operator()(std::span<const double> x) const { return measure(x).cost; }
    [[nodiscard]] Result measure(std::span<const double> x) const {
        const double k = x[0], a = x[1] * x[1] / rig_.mu, c = x[2];
        if (const double least = least_stiffness(k, a, c); !(least > 0.0)) return {std::abs(least), 0.0};
        NumericSprings springs(k, a, c, rig_.torques.low);
        const double initial = dead_band(springs, rig_.torques.low);
        double stored = 0.0;
        for (int level = 1; level < options_.torques; ++level) {  // the last one is the peak torque
            const auto next = cocontracted(springs, loads_[static_cast<std::size_t>(level)]);
            stored += springs.energy_gained(next.theta);
            springs.move_to(next);
        }
        const double final = dead_band(springs, rig_.torques.high);
        const double cost = options_.weight_travel * std::abs(springs.base().theta - options_.wanted_travel) +
                            options_.weight_dead_band * (final - initial) +
                            options_.weight_sensitivity * output_sensitivity(springs, rig_.torques.high);
        return {cost, stored};
    }

private:
    using Vector = std::array<double, 3>;

    [[nodiscard]] double least_stiffness(double k, double a, double c) const {
        double least = std::numeric_limits<double>::infinity();
        for (const double tau : loads_) {
            const double t = (a / tau + c) / tau, series = k * tau * tau;
            least = std::min({least, series, (1.0 / t - 1.0) * series});
        }
        return least;
    }

    /// Footnote 5: tau = U'_PE + U'_SE.
    [[nodiscard]] static NumericSprings::Torques cocontracted(const NumericSprings& springs, double tau) {
        const double from = springs.base().theta;
        const auto excess = [&](double theta) {
            const NumericSprings::Torques at = springs.torques(theta);
            return at.f_se + at.f_pe - tau;
        };
        const double rise = springs.series_stiffness(from) + springs.parallel_stiffness(from);
        const double to = from + (tau - at_base(springs)) / rise;  // stiffness rises: the root lies before it
        boost::uintmax_t steps = 60;
        const auto root = boost::math::tools::toms748_solve(excess, from, to, at_base(springs) - tau, excess(to),
                                                            boost::math::tools::eps_tolerance<double>(48), steps);
        return springs.torques(0.5 * (root.first + root.second));
    }
    [[nodiscard]] static double at_base(const NumericSprings& springs) { return springs.base().f_se + springs.base().f_pe; }

    /// P(1) under any three torques, solved by Newton's rule from the co-contraction at the base. All angles positive when they stretch.
    [[nodiscard]] Vector equilibrium(const NumericSprings& springs, const Vector& torque) const {
        const double g = rig_.ratio;
        Vector z{springs.base().theta, springs.base().theta, 0.0};
        for (int i = 0; i < 30; ++i) {
            const double x1 = z[0] + g * z[2], x2 = z[1] - g * z[2];
            const double f1 = springs.torques(x1).f_se, f2 = springs.torques(x2).f_se;
            const Vector r{torque[0] - f1 - springs.torques(z[0]).f_pe, torque[1] - f2 - springs.torques(z[1]).f_pe,
                           torque[2] - g * (f1 - f2)};
            const double s1 = springs.series_stiffness(x1), s2 = springs.series_stiffness(x2);
            const double p1 = springs.parallel_stiffness(z[0]), p2 = springs.parallel_stiffness(z[1]);
            // The capstans eliminated: [s1 + p1, 0, g s1; 0, s2 + p2, -g s2; g s1, -g s2, g^2 (s1 + s2)] dz = r
            const double t1 = s1 / (s1 + p1), t2 = s2 / (s2 + p2);
            const double dq = (r[2] - g * t1 * r[0] + g * t2 * r[1]) / (g * g * (t1 * p1 + t2 * p2));
            const double d1 = (r[0] - g * s1 * dq) / (s1 + p1), d2 = (r[1] + g * s2 * dq) / (s2 + p2);
            z = {z[0] + d1, z[1] + d2, z[2] + dq};
            if (std::abs(dq) + std::abs(d1) + std::abs(d2) < 1e-11) break;
        }
        return z;
    }

    /// How far q turns for a small torque more on one body, by central differences [rad/Nm].
    [[nodiscard]] double sensitivity(const NumericSprings& springs, double tau, std::size_t body) const {
        const double h = 1e-5 * tau;
        Vector more{tau, tau, 0.0}, less = more;
        more[body] += h;
        less[body] -= h;
        return (equilibrium(springs, more)[2] - equilibrium(springs, less)[2]) / (2.0 * h);
    }
    [[nodiscard]] double output_sensitivity(const NumericSprings& springs, double tau) const { return sensitivity(springs, tau, 2); }

    /// P(3): each side's stiction moves the joint both ways by dq/dtau tau_f; both sides are equal, so that the full width is four times
    /// that of one side's one way.
    [[nodiscard]] double dead_band(const NumericSprings& springs, double tau) const {
        const double width = 4.0 * std::abs(sensitivity(springs, tau, 0)) * rig_.mu * tau;
        return std::min(options_.joint_range, width);
    }

    Algorithm1Options options_;
    Algorithm1Rig rig_;
    std::vector<double> loads_;
};

}  // namespace fusee::design
