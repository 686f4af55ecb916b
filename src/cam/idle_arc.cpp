#include "idle_arc.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fusee/core/units.h"

namespace fusee::cam {

namespace {

constexpr int kInterior = 48;     // knots between the two ends: more change the outline by less than a micrometre
constexpr double kRunOut = 1e-3;  // arc length [m] of the change from the working arc's radius to the idle one
constexpr std::array kEvenness = {0.05, 0.2, 0.8, 3.2, 12.8};  // weights of rho'^2 beside rho^2, evaluated in turn: small outlines first
constexpr std::array kRoundness = {0.25, 0.5, 0.75, 1.0};  // of the ends' distance from the axis: radii aimed at where the axis is outside

/// (h, h') after `step` along a piece whose rho is linear from rho0 to rho1.
SupportState advance(const SupportState& from, double rho1, double step, double width) {
    const double a = from.rho, b = (rho1 - from.rho) / width;
    const double cosine = from.h - a, sine = from.slope - b;
    return {a + b * step + cosine * std::cos(step) + sine * std::sin(step), b - cosine * std::sin(step) + sine * std::cos(step),
            a + b * step};
}

/// Angle of the change from the working arc's radius, at most 0.05 rad.
double run_out_angle(double rho, double width) { return std::min({0.1 * width, 2.0 * kRunOut / rho, 0.05}); }

std::vector<double> knot_places(double begin_rho, double end_rho, double width) {
    const double first = run_out_angle(begin_rho, width), last = run_out_angle(end_rho, width);
    std::vector<double> x{0.0};
    for (int i = 0; i < kInterior; ++i) x.push_back(first + (width - first - last) * i / (kInterior - 1));
    x.push_back(width);
    return x;
}

/// End state as a linear function of the knots' radii: {h, h'} = base + influence * rho.
struct Closing {
    Eigen::Matrix<double, 2, Eigen::Dynamic> influence;
    Eigen::Vector2d base;
};

Closing closing_conditions(const SupportState& begin, const std::vector<double>& x, double end_rho) {
    const auto end_state = [&](const SupportState& from, const std::vector<double>& rho) {
        SupportState s = from;
        for (std::size_t i = 1; i < x.size(); ++i) s = advance(s, rho[i], x[i] - x[i - 1], x[i] - x[i - 1]);
        return Eigen::Vector2d(s.h, s.slope);
    };
    std::vector<double> rho(x.size(), 0.0);
    rho.back() = end_rho;
    Closing closing{Eigen::Matrix<double, 2, Eigen::Dynamic>(2, kInterior), end_state(begin, rho)};
    rho.back() = 0.0;
    for (int i = 0; i < kInterior; ++i) {
        const auto knot = static_cast<std::size_t>(i) + 1;
        rho[knot] = 1.0;
        closing.influence.col(i) = end_state({0.0, 0.0, 0.0}, rho);
        rho[knot] = 0.0;
    }
    return closing;
}

Eigen::MatrixXd cost_of(const std::vector<double>& x, double evenness) {
    Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(kInterior, kInterior);
    for (int i = 0; i < kInterior; ++i) {
        const auto knot = static_cast<std::size_t>(i) + 1;
        cost(i, i) += 0.5 * (x[knot + 1] - x[knot - 1]);
        if (i + 1 == kInterior) break;
        const double stiffness = evenness / (x[knot + 1] - x[knot]);
        cost(i, i) += stiffness;
        cost(i + 1, i + 1) += stiffness;
        cost(i, i + 1) -= stiffness;
        cost(i + 1, i) -= stiffness;
    }
    return cost;
}

/// min (rho - aim)' cost (rho - aim) with influence rho = target and rho >= least, by an active set: the lowest violations are fixed and
/// never released.
/// @param drawn the radii become a contour; else only whether there are any counts, and a cheaper solver tells it
std::optional<Eigen::VectorXd> evenest(const Eigen::MatrixXd& cost, const Closing& closing, const Eigen::Vector2d& target, double least,
                                       double aim = 0.0, bool drawn = true) {
    std::vector<bool> pinned(kInterior, false);
    for (int round = 0; round < kInterior; ++round) {
        Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(kInterior + 2, kInterior + 2);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(kInterior + 2);
        kkt.topLeftCorner(kInterior, kInterior) = cost;
        kkt.topRightCorner(kInterior, 2) = closing.influence.transpose();
        kkt.bottomLeftCorner(2, kInterior) = closing.influence;
        right.head(kInterior) = aim * cost.rowwise().sum();
        right.tail<2>() = target;
        for (int i = 0; i < kInterior; ++i) {
            if (!pinned[static_cast<std::size_t>(i)]) continue;
            kkt.row(i).setZero();
            kkt(i, i) = 1.0;
            right(i) = least;
        }
        const Eigen::VectorXd solution = drawn ? kkt.fullPivLu().solve(right).eval() : kkt.partialPivLu().solve(right).eval();
        const double missed = (closing.influence * solution.head(kInterior) - target).norm();
        if (!(missed <= 1e-9 * (target.norm() + 1e-3))) return std::nullopt;  // NaN where too many radii are fixed
        bool grew = false;
        for (int i = 0; i < kInterior; ++i)
            if (solution(i) < least * (1.0 - 1e-9)) pinned[static_cast<std::size_t>(i)] = grew = true;
        if (!grew) return solution.head(kInterior);
    }
    return std::nullopt;
}

core::Finding refusal(double width, double least_rho, double possible) {
    core::Finding f = core::error_finding("cam.idle_arc", "no convex idle arc with the least radius closes the contour",
                                          core::mm_from_m(possible), core::Bound::kAtLeast, core::mm_from_m(least_rho), "mm");
    f.where = fmt::format("idle arc of {:.1f} deg", core::deg_from_rad(width));
    f.suggestion = possible > 0.0
                       ? core::change("path.min_idle_radius_mm", fmt::format("{:.2f}", 0.95 * core::mm_from_m(possible)))
                       : core::change("path.kind", core::quoted("helix")).or_else("less wrap (another spring preload or a smaller travel)");
    f.source = "a convex closed curve needs rho > 0 everywhere";
    return f;
}

}  // namespace

core::Outcome<IdleArc> IdleArc::close(const SupportState& begin, const SupportState& end, double width, const Least& least) {
    const std::vector<double> x = knot_places(begin.rho, end.rho, width);
    const Closing closing = closing_conditions(begin, x, end.rho);
    const Eigen::Vector2d target = Eigen::Vector2d(end.h, end.slope) - closing.base;
    std::optional<IdleArc> best;
    const auto improve = [&](double evenness, double aim) {
        const auto rho = evenest(cost_of(x, evenness), closing, target, least.rho, aim);
        if (!rho) return false;
        IdleArc arc;
        arc.knots_.push_back({0.0, begin});
        for (std::size_t i = 1; i < x.size(); ++i) {
            const double next = i + 1 < x.size() ? (*rho)(static_cast<Eigen::Index>(i) - 1) : end.rho;
            const double step = x[i] - x[i - 1];
            arc.knots_.push_back({x[i], advance(arc.knots_.back().state, next, step, step)});
        }
        if (!best || arc.least_h() > best->least_h()) best = std::move(arc);
        return best->least_h() < least.h;
    };
    for (const double evenness : kEvenness)
        if (!improve(evenness, 0.0)) break;
    if (best && best->least_h() < 0.0)
        for (const double share : kRoundness)
            if (!improve(kEvenness.front(), share * std::max(begin.h, end.h))) break;
    if (best) return *std::move(best);
    double possible = 0.0;
    const Eigen::MatrixXd cost = cost_of(x, kEvenness.front());
    for (double share = 0.9; share > 0.005 && possible == 0.0; share *= 0.9)
        if (evenest(cost, closing, target, share * least.rho, 0.0, false)) possible = share * least.rho;
    return refusal(width, least.rho, possible);
}

double IdleArc::least_h() const {
    return std::min_element(knots_.begin(), knots_.end(), [](const Knot& a, const Knot& b) { return a.state.h < b.state.h; })->state.h;
}

IdleArc IdleArc::run_out(const SupportState& begin, double width, double final_rho, double ease) {
    const double wanted = std::max(ease, run_out_angle(begin.rho, width)), first = std::min(wanted, 0.9 * width);
    const double last_rho = std::lerp(begin.rho, final_rho, first / wanted);
    IdleArc arc;
    arc.knots_ = {{0.0, begin}, {first, advance(begin, last_rho, first, first)}};
    arc.knots_.push_back({width, advance(arc.knots_.back().state, last_rho, width - first, width - first)});
    return arc;
}

double IdleArc::length(double x) const {
    double sum = 0.0;
    for (std::size_t i = 1; i < knots_.size() && knots_[i - 1].x < x; ++i) {
        const bool last = i + 1 == knots_.size();
        const double to = last ? x : std::min(x, knots_[i].x);
        sum += 0.5 * (knots_[i - 1].state.rho + at(to).rho) * (to - knots_[i - 1].x);  // rho is linear between knots
    }
    return sum;
}

SupportState IdleArc::at(double x) const {
    auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, x, [](double value, const Knot& k) { return value < k.x; });
    const Knot& from = *(after - 1);
    return advance(from.state, after->state.rho, x - from.x, after->x - from.x);
}

}  // namespace fusee::cam
