#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/spring/enclosure.h"
#include "fusee/spring/laws.h"
#include "rules.h"

// Equation numbers: docs/theory/springs.md.
namespace fusee::spring {

namespace {

/// How far inside the feasible range a suggested torque lies.
constexpr double kMargin = 0.02;

/// theta_inf of eq. 6
double asymptote(const StictionLawOptions& o) {
    const double a = o.u * o.u / o.mu, start = o.start_torque;
    return (a / (3.0 * start * start * start) + o.c / (2.0 * start * start)) / o.k;
}

class StictionLaw final : public SpringLaw, public EnclosedLaw {
public:
    explicit StictionLaw(const StictionLawOptions& options)
        : k_(options.k), a_(options.u * options.u / options.mu), c_(options.c), start_(options.start_torque), end_(options.end_torque) {
        for (std::size_t n = 0; n < start_powers_.size(); ++n) start_powers_[n] = std::pow(start_, 1 - static_cast<int>(n));
        f_start_ = transmission(start_) * start_;
        theta_inf_ = asymptote(options);
        theta_end_ = theta(powers(std::log(end_ / start_)));
    }

    [[nodiscard]] core::Range loads() const override { return {start_, end_}; }
    [[nodiscard]] core::Range angles() const override { return {0.0, theta_end_}; }

    [[nodiscard]] LawPoint at_load(double tau) const override {
        const double load = std::clamp(tau, start_, end_);
        return point<LawPoint>(load, powers(std::log1p((load - start_) / start_)));
    }

    [[nodiscard]] LawPoint at_angle(double theta) const override {
        const double angle = std::clamp(theta, 0.0, theta_end_), load = load_at(angle);
        LawPoint p = point<LawPoint>(load, powers(std::log1p((load - start_) / start_)));
        p.theta = angle;
        return p;
    }
    /// One segment by the load.
    [[nodiscard]] std::vector<LawSegment> segments() const override {
        return {{loads(), [*this](const math::Interval& box) {
                     const math::Jet tau = math::Jet::parameter(box);
                     return point<LawJet>(tau, powers(log1p((tau - start_) / start_)));
                 }}};
    }

private:
    template <class T>
    [[nodiscard]] T transmission(const T& tau) const {
        return (a_ / tau + c_) / tau;
    }

    /// ln(tau/start) and, over n, the integrals of tau^-n from the start to that load; exact to the last digits near the start too.
    template <class T>
    struct Powers {
        T log;
        std::array<T, 6> integral;  ///< n from 2 on
    };
    template <class T>
    [[nodiscard]] Powers<T> powers(const T& log) const {
        using std::expm1;
        Powers<T> all{log, {}};
        for (std::size_t n = 2; n < all.integral.size(); ++n) {
            const double one_less = static_cast<double>(n) - 1.0;
            all.integral[n] = -expm1(-one_less * log) * start_powers_[n] / one_less;
        }
        return all;
    }
    /// Integral of ln(tau/start) tau^-n, by parts.
    template <class T>
    [[nodiscard]] T log_integral(std::size_t n, const Powers<T>& to) const {
        using std::exp;
        const double one_less = static_cast<double>(n) - 1.0;
        return (to.integral[n] - to.log * start_powers_[n] * exp(-one_less * to.log)) / one_less;
    }

    /// eq. 5
    template <class T>
    [[nodiscard]] T theta(const Powers<T>& to) const {
        return (a_ * to.integral[4] + c_ * to.integral[3]) / k_;
    }

    /// Root of eq. 6 in v = 1/tau: a v^3/3 + c v^2/2 = k (theta_inf - theta). The left side rises and is convex wherever T > 0, so Newton's
    /// steps from the start torque's side come down to the root without passing it.
    [[nodiscard]] double load_at(double theta) const {
        const double level = k_ * (theta_inf_ - theta);
        double v = 1.0 / start_;
        for (double next = v;; v = next) {
            next = v - (v * v * (a_ * v / 3.0 + c_ / 2.0) - level) / (v * (a_ * v + c_));
            if (!(next < v)) break;
        }
        return std::clamp(1.0 / v, start_, end_);
    }

    template <class Point, class T>
    [[nodiscard]] Point point(const T& tau, const Powers<T>& to) const {
        const T t = transmission(tau);
        Point p;
        p.tau = tau;
        p.theta = theta(to);
        p.f_se = f_start_ + c_ * to.log + a_ * (tau - start_) / (tau * start_);  // eq. 7
        p.f_pe = tau - p.f_se;
        p.s = k_ * tau * tau;
        p.p = (1.0 / t - 1.0) * p.s;
        const T rise = p.s / t;  // dtau/dtheta = S + P
        p.s_slope = 2.0 * k_ * tau * rise;
        const T down = a_ + c_ * tau;
        const T rise_slope = k_ * tau * tau * tau * (4.0 * a_ + 3.0 * c_ * tau) / (down * down) * rise;  // eq. 9
        p.p_slope = rise_slope - p.s_slope;
        p.u_se = series_energy(to);
        p.u_pe = (a_ * to.integral[3] + c_ * to.integral[2]) / k_ - p.u_se;  // eq. 11
        return p;
    }

    /// eq. 10: integral of F_SE dtheta with F_SE = base + c ln(tau/start) - a/tau
    template <class T>
    [[nodiscard]] T series_energy(const Powers<T>& to) const {
        const double base = f_start_ + a_ / start_;
        const T &i3 = to.integral[3], &i4 = to.integral[4], &i5 = to.integral[5];
        return (base * (a_ * i4 + c_ * i3) + c_ * (a_ * log_integral(4, to) + c_ * log_integral(3, to)) - a_ * (a_ * i5 + c_ * i4)) / k_;
    }

    double k_, a_, c_, start_, end_;  // a = u^2/mu
    double f_start_ = 0.0, theta_inf_ = 0.0, theta_end_ = 0.0;
    std::array<double, 6> start_powers_{};  ///< start^(1 - n) over n
};

void require_finite(const char* field, double value, const char* unit) {
    constexpr double kLargest = std::numeric_limits<double>::max();
    core::require_within(field, value, -kLargest, kLargest, unit);
}

core::Finding transmission_finding(double measured, core::Bound bound, double allowed, const char* what, const char* end) {
    core::Finding finding = core::error_finding("law.transmission", what, measured, bound, allowed, "Nm");
    finding.where = fmt::format("law at its {} torque", end);
    finding.source = "docs/theory/springs.md, eq. 3 and 4";
    return finding;
}

/// T >= 1 at the start: the least feasible start torque, or the constant C that puts it below the given one.
core::Finding start_too_low(const StictionLawOptions& options, double least) {
    core::Finding finding = transmission_finding(options.start_torque, core::Bound::kAtLeast, least,
                                                 "the transmission reaches 1 at the start torque: no K_PE is that soft", "start");
    const double safe = options.start_torque * (1.0 - kMargin);
    const double start = least * (1.0 + kMargin);
    if (start < options.end_torque) finding.suggestion = core::change("law.start_torque_Nm", core::number(start, 4));
    finding.suggestion.or_else(core::change("law.c_Nm", core::number(safe - options.u * options.u / (options.mu * safe), 4)));
    return finding;
}

/// T <= 0 at the end (C < 0): the highest feasible end torque, or the constant C that puts it above the given one.
core::Finding end_too_high(const StictionLawOptions& options, double highest) {
    core::Finding finding = transmission_finding(options.end_torque, core::Bound::kAtMost, highest,
                                                 "the transmission reaches 0 at the end torque: no K_PE is that stiff", "end");
    const double a = options.u * options.u / options.mu;
    const double c = a > 0.0 ? -a / (options.end_torque * (1.0 + kMargin)) : options.start_torque * (1.0 - kMargin);
    const double end = highest * (1.0 - kMargin);
    if (end > options.start_torque) finding.suggestion = core::change("law.end_torque_Nm", core::number(end, 4));
    finding.suggestion.or_else(core::change("law.c_Nm", core::number(c, 4)));
    return finding;
}

}  // namespace

void validate(const StictionLawOptions& options) {
    core::require_positive("law.k_per_Nm_rad", options.k, "1/(Nm rad)");
    require_finite("law.u_Nm", options.u, "Nm");
    require_finite("law.c_Nm", options.c, "Nm");
    if (options.u == 0.0 && options.c == 0.0)
        throw core::InvalidInput("law.c_Nm", "0, and law.u_Nm too", "not both 0: the transmission would be 0");
    core::require_positive("rig.gear_friction", options.mu);
    require_torques(options.start_torque, options.end_torque);
}

double least_feasible_load(const StictionLawOptions& options) {
    return 0.5 * (options.c + std::sqrt(options.c * options.c + 4.0 * options.u * options.u / options.mu));  // eq. 4: T(least) = 1
}

core::Outcome<SpringLawPtr> make_stiction_law(const StictionLawOptions& options) {
    validate(options);
    const double a = options.u * options.u / options.mu;
    const double least = least_feasible_load(options);
    core::Findings refusal;
    if (options.start_torque <= least) refusal.push_back(start_too_low(options, least));
    if (options.c < 0.0 && options.end_torque >= a / -options.c) refusal.push_back(end_too_high(options, a / -options.c));
    if (!refusal.empty()) return refusal;
    return SpringLawPtr(std::make_shared<StictionLaw>(options));
}

}  // namespace fusee::spring
