#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "by_load.h"
#include "fusee/core/error.h"
#include "fusee/math/roots.h"
#include "fusee/spring/enclosure.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "rules.h"

namespace fusee::spring {

namespace {

constexpr int kWalkSteps = 2000;  ///< over the common domain, to find where the loads are reached
constexpr int kScanSteps = 800;   ///< over the law's range, to find falling load

/// Both springs at one deflection.
struct Pair {
    PotentialPtr series, parallel;

    [[nodiscard]] core::Range domain() const {
        const core::Range a = series->domain(), b = parallel->domain();
        return {std::max(a.low, b.low), std::min(a.high, b.high)};
    }
    [[nodiscard]] double load(double x) const { return series->force(x) + parallel->force(x); }
    [[nodiscard]] double stiffness(double x) const { return series->stiffness(x) + parallel->stiffness(x); }
    /// @pre load(low) <= tau <= load(high)
    [[nodiscard]] double deflection(double tau, core::Range x) const {
        const double cap = 1e6 * tau;  // an exponential far out is infinite
        const auto root = math::bracketed_root([&](double at) { return std::min(load(at), cap) - tau; }, x.low, x.high);
        return root.value_or(load(x.low) >= tau ? x.low : x.high);
    }
};

class PairLaw : public SpringLaw, public EnclosedLaw {
public:
    PairLaw(Pair pair, core::Range x, core::Range loads) : pair_(std::move(pair)), x_(x), loads_(loads) {}

    [[nodiscard]] core::Range loads() const override { return loads_; }
    [[nodiscard]] core::Range angles() const override { return {0.0, x_.width()}; }
    [[nodiscard]] LawPoint at_load(double tau) const override {
        const double load = std::clamp(tau, loads_.low, loads_.high);
        LawPoint point = point_at(pair_.deflection(load, x_));
        point.tau = load;
        return point;
    }
    [[nodiscard]] LawPoint at_angle(double theta) const override { return point_at(x_.low + std::clamp(theta, 0.0, x_.width())); }
    /// The segments by the potentials' deflection.
    [[nodiscard]] std::vector<LawSegment> segments() const override {
        const auto* series = dynamic_cast<const EnclosedPotential*>(pair_.series.get());
        const auto* parallel = dynamic_cast<const EnclosedPotential*>(pair_.parallel.get());
        if (!series || !parallel) return {};
        std::vector<double> places = series->breaks();
        for (const double at : parallel->breaks()) places.push_back(at);
        places = cuts(x_, places);
        const auto over = [pair = pair_, series, parallel, low = x_.low](const math::Interval& x) {
            PotentialJet first = series->over(x), second = parallel->over(x);
            first.energy -= pair.series->energy(low);
            second.energy -= pair.parallel->energy(low);
            return joined<LawJet>(math::Jet::parameter(x) - low, first, second);
        };
        std::vector<LawSegment> result;
        for (std::size_t i = 0; i + 1 < places.size(); ++i) result.push_back({{places[i], places[i + 1]}, over});
        return result;
    }

private:
    /// One spring's figures at a deflection, the energy above that at the law's start.
    struct Figures {
        double energy, force, stiffness, slope;
    };
    [[nodiscard]] Figures figures(const Potential& spring, double x) const {
        return {spring.energy(x) - spring.energy(x_.low), spring.force(x), spring.stiffness(x), spring.slope(x)};
    }

    /// The point of the law where both springs have these figures: of numbers, or of boxes.
    template <class Point, class T, class SpringFigures>
    [[nodiscard]] static Point joined(const T& theta, const SpringFigures& series, const SpringFigures& parallel) {
        Point point;
        point.theta = theta;
        point.f_se = series.force;
        point.f_pe = parallel.force;
        point.tau = point.f_se + point.f_pe;
        point.s = series.stiffness;
        point.p = parallel.stiffness;
        point.s_slope = series.slope;
        point.p_slope = parallel.slope;
        point.u_se = series.energy;
        point.u_pe = parallel.energy;
        return point;
    }

    [[nodiscard]] LawPoint point_at(double x) const {
        return joined<LawPoint>(x - x_.low, figures(*pair_.series, x), figures(*pair_.parallel, x));
    }

    Pair pair_;
    core::Range x_, loads_;  ///< deflection of the potentials [rad], load [Nm]
};

class OneSpringLaw final : public PairLaw {
public:
    explicit OneSpringLaw(const PotentialPtr& spring) : PairLaw({spring, spring}, spring->domain(), {}) {}

    [[nodiscard]] core::Range loads() const override { return angles(); }
    [[nodiscard]] LawPoint at_load(double theta) const override { return at_angle(theta); }
    [[nodiscard]] LawPoint at_angle(double theta) const override {
        LawPoint point = PairLaw::at_angle(theta);
        point.tau = point.f_pe;
        return point;
    }
};

core::Finding refuse(const char* rule, const char* what, double measured, core::Bound bound, double allowed, const char* unit) {
    core::Finding finding = core::error_finding(rule, what, measured, bound, allowed, unit);
    finding.source = "docs/theory/springs.md, eq. 1";
    return finding;
}

core::Finding out_of_range(const char* end, double torque, core::Bound bound, double reached, double x) {
    core::Finding finding = refuse("law.range", "the potentials do not reach the law's load", torque, bound, reached, "Nm");
    finding.where = fmt::format("law at its {} torque, potentials at {:.4g} rad", end, x);
    const double nearest = bound == core::Bound::kAtMost ? 0.999 * reached : 1.001 * reached;
    finding.suggestion = nearest > 0.0 ? core::change(fmt::format("law.{}_torque_Nm", end), core::number(nearest))
                                       : fmt::format("potentials whose torque rises to {:.4g} Nm", torque);
    return finding;
}

/// The highest load between `start` and deflection x up to which both springs are stiff, which is stricter than a rising load.
double stiff_up_to(const Pair& pair, double x, double start) {
    const double low = pair.domain().low;
    double highest = 0.0;
    for (int i = 0; i <= kScanSteps; ++i) {
        const double at = low + (x - low) * i / kScanSteps, load = pair.load(at);
        if (load >= start && !(std::min(pair.series->stiffness(at), pair.parallel->stiffness(at)) > 0.0)) break;
        highest = std::max(highest, load);
    }
    return highest;
}

core::Finding falling(const Pair& pair, double x, double start) {
    const double stiffness = pair.stiffness(x);
    core::Finding finding =
        refuse("law.stiffness", "load must rise with the capstan's angle: S + P > 0", stiffness, core::Bound::kAtLeast, 0.0, "Nm/rad");
    finding.where = fmt::format("law at {:.4g} Nm, potentials at {:.4g} rad", pair.load(x), x);
    const double end = 0.98 * stiff_up_to(pair, x, start);
    finding.suggestion = end > start ? core::change("law.end_torque_Nm", core::number(end, 4))
                                     : fmt::format("a stiffness higher by {:.4g} Nm/rad there", std::abs(stiffness));
    return finding;
}

/// Deflections where the load first reaches `start` and then `end`.
core::Outcome<core::Range> find_range(const Pair& pair, double start, double end) {
    using core::Bound;
    const core::Range domain = pair.domain();
    if (!(domain.width() > 0.0))
        return refuse("law.range", "the potentials share no deflection", domain.width(), Bound::kAtLeast, 0.0, "rad");
    double x = domain.low, load = pair.load(x), highest = load;
    if (load > start) return out_of_range("start", start, Bound::kAtLeast, load, x);
    std::optional<double> x_start;
    if (load == start) x_start = x;
    for (int i = 1; i <= kWalkSteps; ++i) {
        const double next = domain.low + domain.width() * i / kWalkSteps, next_load = pair.load(next);
        if (!x_start && next_load >= start) x_start = pair.deflection(start, {x, next});
        if (x_start && next_load >= end) return core::Range{*x_start, pair.deflection(end, {x, next})};
        if (x_start && !(next_load >= std::max(load, start))) return falling(pair, next, start);
        x = next;
        load = next_load;
        highest = std::max(highest, load);
    }
    return out_of_range(x_start ? "end" : "start", x_start ? end : start, Bound::kAtMost, highest, x);
}

/// The first place where load falls, if any.
std::optional<core::Finding> find_fall(const Pair& pair, core::Range x, double start) {
    for (int i = 0; i <= kScanSteps; ++i) {
        const double at = x.low + x.width() * i / kScanSteps;
        if (!(pair.stiffness(at) > 0.0)) return falling(pair, at, start);
    }
    return std::nullopt;
}

void require_knots(const FreeCurveOptions& options) {
    const auto& [loads, stiffness, transmission] = options;
    math::require_table(loads, stiffness, 4, "law.loads_Nm", "law.series_Nm_per_rad");
    math::require_table(loads, transmission, 4, "law.loads_Nm", "law.transmission");
    require_torques(loads.front(), loads.back());
    for (std::size_t i = 0; i < loads.size(); ++i) {
        core::require_positive(fmt::format("law.series_Nm_per_rad[{}]", i), stiffness[i], "Nm/rad");
        if (!(transmission[i] > 0.0 && transmission[i] < 1.0))
            throw core::InvalidInput(fmt::format("law.transmission[{}]", i), fmt::format("{:g}", transmission[i]), "above 0 and below 1");
    }
}

}  // namespace

SpringLawPtr make_one_spring_law(PotentialPtr spring) { return std::make_shared<OneSpringLaw>(spring); }

core::Outcome<SpringLawPtr> make_pair_law(PotentialPtr series, PotentialPtr parallel, double start_torque, double end_torque) {
    const core::Range loads = require_torques(start_torque, end_torque);
    Pair pair{std::move(series), std::move(parallel)};
    const auto x = find_range(pair, start_torque, end_torque);
    if (!x) return x.refusal();
    if (auto fall = find_fall(pair, *x, start_torque)) return *std::move(fall);
    return SpringLawPtr(std::make_shared<PairLaw>(std::move(pair), *x, loads));
}

core::Outcome<SpringLawPtr> make_general_stiction_law(const GeneralStictionOptions& options) {
    const FrictionLaw friction = options.friction;
    validate({.k = options.k,
              .u = options.u,
              .c = options.c,
              .mu = friction.mu(),
              .start_torque = options.start_torque,
              .end_torque = options.end_torque});
    require_friction(friction, {options.start_torque, options.end_torque});
    const double k = options.k, reduced = options.u * options.u, constant = options.c * friction.mu();
    const auto at = [=]<class T>(const T& tau) {
        const T tau_f = friction.at_rest(tau);
        const T t = (constant + reduced / tau) / tau_f;  // T tau_f = mu C + u^2/tau
        const T t_rate = -reduced / (tau * tau * tau_f) - t * friction.slope(tau) / tau_f;
        return from_transmission<T>(k * tau * tau, 2.0 * k * tau, t, t_rate);
    };
    return integrate_by_load({at, friction.rows()}, {options.start_torque, options.end_torque});
}

core::Outcome<SpringLawPtr> make_transmission_law(math::CurvePtr series_stiffness, math::CurvePtr transmission, double start_torque,
                                                  double end_torque) {
    const core::Range loads = require_torques(start_torque, end_torque);
    require_reach("law.series_stiffness_Nm_per_rad", *series_stiffness, loads);
    require_reach("law.transmission", *transmission, loads);
    std::vector<double> places = math::breaks(*series_stiffness);
    for (const double place : math::breaks(*transmission)) places.push_back(place);
    const auto at = [s = std::move(series_stiffness), t = std::move(transmission)](const auto& tau) {
        using math::derivative;
        return from_transmission(derivative(*s, tau, 0), derivative(*s, tau, 1), derivative(*t, tau, 0), derivative(*t, tau, 1));
    };
    return integrate_by_load({at, std::move(places)}, {loads.low, loads.high});
}

core::Outcome<SpringLawPtr> make_free_curve(const FreeCurveOptions& options) {
    require_knots(options);
    std::vector<double> log_s, log_ratio;  // ln S, ln(S/P)
    for (const double s : options.series_stiffness) log_s.push_back(std::log(s));
    for (const double t : options.transmission) log_ratio.push_back(std::log(t / (1.0 - t)));
    const auto at = [s_curve = math::make_interpolant(options.loads, log_s),
                     ratio_curve = math::make_interpolant(options.loads, log_ratio)]<class T>(const T& tau) {
        using math::derivative, std::exp;
        const T s = exp(derivative(*s_curve, tau, 0)), p = s * exp(-derivative(*ratio_curve, tau, 0));
        const T s_growth = derivative(*s_curve, tau, 1);
        return BasicStiffnesses<T>{s, p, s * s_growth, p * (s_growth - derivative(*ratio_curve, tau, 1))};
    };
    constexpr bool kPositive = true;  // for any knots
    return integrate_by_load({at, options.loads}, options.loads, kPositive);
}

}  // namespace fusee::spring
