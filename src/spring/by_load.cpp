#include "by_load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/math/chebyshev.h"
#include "fusee/math/roots.h"
#include "fusee/spring/enclosure.h"
#include "rules.h"

namespace fusee::spring {

namespace {

using math::ChebyshevSeries;
using Values = ChebyshevSeries::Values;

/// The sums up to a load.
template <class T>
struct BasicSums {
    T theta = 0.0, f_se = 0.0, u_se = 0.0, u_pe = 0.0;
};
using Sums = BasicSums<double>;

/// A range of loads over which every figure is one series.
struct Piece {
    core::Range loads;
    Sums start;
    ChebyshevSeries compliance;               ///< dtheta/dtau = 1/(S + P)
    ChebyshevSeries theta, f_se, u_se, u_pe;  ///< above the piece's start
    [[nodiscard]] Sums at(double tau) const {
        return {start.theta + theta(tau), start.f_se + f_se(tau), start.u_se + u_se(tau), start.u_pe + u_pe(tau)};
    }
    [[nodiscard]] BasicSums<math::Jet> over(const math::Interval& tau) const {
        return {start.theta + theta.over(tau), start.f_se + f_se.over(tau), start.u_se + u_se.over(tau), start.u_pe + u_pe.over(tau)};
    }
};

class ByLoadLaw final : public SpringLaw, public EnclosedLaw {
public:
    ByLoadLaw(StiffnessesAt stiffnesses, std::vector<Piece> pieces) : stiffnesses_(std::move(stiffnesses)), pieces_(std::move(pieces)) {
        theta_end_ = pieces_.back().at(pieces_.back().loads.high).theta;
    }

    [[nodiscard]] core::Range loads() const override { return {pieces_.front().loads.low, pieces_.back().loads.high}; }
    [[nodiscard]] core::Range angles() const override { return {0.0, theta_end_}; }

    [[nodiscard]] LawPoint at_load(double tau) const override {
        const double load = std::clamp(tau, loads().low, loads().high);
        const Piece& piece = piece_where([load](const Piece& p) { return load < p.loads.low; });
        return point<LawPoint>(load, piece.at(load));
    }
    [[nodiscard]] LawPoint at_angle(double theta) const override {
        const double angle = std::clamp(theta, 0.0, theta_end_);
        const Piece& piece = piece_where([angle](const Piece& p) { return angle < p.start.theta; });
        const double load = load_in(piece, angle - piece.start.theta);
        Sums sums = piece.at(load);
        sums.theta = angle;
        return point<LawPoint>(load, sums);
    }
    /// The segments by the load: every piece, divided where the stiffnesses are.
    [[nodiscard]] std::vector<LawSegment> segments() const override {
        std::vector<LawSegment> result;
        const auto self = std::make_shared<const ByLoadLaw>(*this);
        for (const Piece& piece : self->pieces_) {
            const std::vector<double> places = cuts(piece.loads, stiffnesses_.breaks());
            for (std::size_t i = 0; i + 1 < places.size(); ++i)
                result.push_back({{places[i], places[i + 1]}, [self, &piece](const math::Interval& tau) {
                                      return self->point<LawJet>(math::Jet::parameter(tau), piece.over(tau));
                                  }});
        }
        return result;
    }

private:
    /// The last piece that does not begin above, or the first one.
    template <class Above>
    [[nodiscard]] const Piece& piece_where(Above above) const {
        return *std::prev(std::partition_point(pieces_.begin() + 1, pieces_.end(), [&](const Piece& p) { return !above(p); }));
    }

    /// The load at which the piece's angle is `theta`.
    [[nodiscard]] static double load_in(const Piece& piece, double theta) {
        const double guess = std::lerp(piece.loads.low, piece.loads.high, theta / piece.theta(piece.loads.high));
        const auto excess = [&](double load) { return math::Tangent{piece.theta(load) - theta, piece.compliance(load)}; };
        return math::rising_root(excess, piece.loads.low, piece.loads.high, guess);
    }

    template <class Point, class T>
    [[nodiscard]] Point point(const T& tau, const BasicSums<T>& sums) const {
        const BasicStiffnesses<T> at = stiffnesses_(tau);
        const T rise = at.s + at.p;  // dtau/dtheta
        Point p;
        p.tau = tau;
        p.theta = sums.theta;
        p.f_se = sums.f_se;
        p.f_pe = tau - sums.f_se;
        p.s = at.s;
        p.p = at.p;
        p.s_slope = at.s_rate * rise;
        p.p_slope = at.p_rate * rise;
        p.u_se = sums.u_se;
        p.u_pe = sums.u_pe;
        return p;
    }

    StiffnessesAt stiffnesses_;
    std::vector<Piece> pieces_;
    double theta_end_ = 0.0;
};

/// Divides the range until every integrand is a converged series.
class Quadrature {
public:
    explicit Quadrature(const StiffnessesAt& stiffnesses) : stiffnesses_(stiffnesses) {}

    /// The pieces between the edges; empty if the stiffnesses are not a pair of springs somewhere.
    [[nodiscard]] std::vector<Piece> over(const std::vector<double>& edges) {
        const Stiffnesses first = stiffnesses_(edges.front());
        sums_.f_se = first.s / (first.s + first.p) * edges.front();  // F_0 = T tau: torques begin in the ratio of their stiffnesses
        for (std::size_t i = 0; i + 1 < edges.size(); ++i)
            if (!add({edges[i], edges[i + 1]}, 0)) return {};
        return std::move(pieces_);
    }
    /// The load at which `over` found no pair of springs.
    [[nodiscard]] double broken_at() const { return broken_at_; }

private:
    static constexpr int kDeepest = 40;  ///< halvings: a kink is then narrower than rounding

    bool add(core::Range range, int depth) {
        const Values tau = ChebyshevSeries::points(range);
        Values share{}, compliance{}, series_power{}, parallel_power{};
        for (std::size_t i = 0; i < tau.size(); ++i) {
            const Stiffnesses at = stiffnesses_(tau[i]);
            if (!(at.s > 0.0 && at.p > 0.0 && std::isfinite(at.s + at.p))) {
                broken_at_ = tau[i];
                return false;
            }
            compliance[i] = 1.0 / (at.s + at.p);
            share[i] = at.s * compliance[i];
        }
        const ChebyshevSeries transmission(range, share), turning(range, compliance);
        const ChebyshevSeries f_se = transmission.integral(), theta = turning.integral();
        for (std::size_t i = 0; i < tau.size(); ++i) {  // dU/dtau = F dtheta/dtau
            const double force = sums_.f_se + f_se(tau[i]);
            series_power[i] = compliance[i] * force;
            parallel_power[i] = compliance[i] * (tau[i] - force);
        }
        const ChebyshevSeries u_se(range, series_power), u_pe(range, parallel_power);
        const double turned = sums_.theta + theta(range.high);
        const bool converged = fine(transmission, range, sums_.f_se) && fine(turning, range, turned) &&
                               fine(u_se, range, turned * sums_.f_se) && fine(u_pe, range, turned * tau.front());
        if (!converged && depth < kDeepest) {
            const double middle = 0.5 * (range.low + range.high);
            return add({range.low, middle}, depth + 1) && add({middle, range.high}, depth + 1);
        }
        pieces_.push_back({range, sums_, turning, theta, f_se, u_se.integral(), u_pe.integral()});
        sums_ = pieces_.back().at(range.high);
        return true;
    }

    /// Is the truncation of the series negligible in the sums? It is for smooth stiffnesses; near a kink only shorter pieces help.
    static bool fine(const ChebyshevSeries& series, core::Range range, double sum) {
        constexpr double kShare = 5e-14;
        return series.tail() * range.width() <= kShare * sum;
    }

    const StiffnessesAt& stiffnesses_;
    std::vector<Piece> pieces_;
    Sums sums_;
    double broken_at_ = 0.0;
};

core::Findings look_over(const StiffnessesAt& stiffnesses, const std::vector<double>& loads) {
    std::vector<LawPoint> points;
    for (const double tau : loads) {
        const Stiffnesses at = stiffnesses(tau);
        points.push_back({.tau = tau, .s = at.s, .p = at.p});
    }
    return check_stiffnesses(points);
}

}  // namespace

void require_reach(const char* field, const math::Curve& curve, core::Range loads) {
    const core::Range reach = curve.domain();
    if (!reach.holds(loads.low) || !reach.holds(loads.high))
        throw core::InvalidInput(field, fmt::format("given from {:g} to {:g} Nm", reach.low, reach.high),
                                 fmt::format("given over the whole law, {:g} to {:g} Nm", loads.low, loads.high));
}

void require_friction(const FrictionLaw& friction, core::Range loads) {
    for (const double tau : {loads.low, loads.high})
        if (!(friction.at_rest(tau) > 0.0))
            throw core::InvalidInput("rig.gear_friction", fmt::format("{:g} Nm at {:g} Nm", friction.at_rest(tau), tau),
                                     "above 0: without stiction there is no dead-band to shape");
}

core::Outcome<SpringLawPtr> integrate_by_load(StiffnessesAt stiffnesses, const std::vector<double>& edges, bool looked_over) {
    const core::Range range{edges.front(), edges.back()};
    if (!looked_over)
        if (core::Findings broken = look_over(stiffnesses, scan_loads(range)); !broken.empty()) return broken;
    Quadrature quadrature(stiffnesses);
    std::vector<Piece> pieces = quadrature.over(edges);
    if (pieces.empty()) {
        std::vector<double> loads = scan_loads(range);
        loads.insert(std::upper_bound(loads.begin(), loads.end(), quadrature.broken_at()), quadrature.broken_at());
        return look_over(stiffnesses, loads);
    }
    return SpringLawPtr(std::make_shared<ByLoadLaw>(std::move(stiffnesses), std::move(pieces)));
}

}  // namespace fusee::spring
