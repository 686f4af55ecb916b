#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "changed_law.h"
#include "fusee/cam/contact.h"
#include "fusee/math/curve.h"
#include "fusee/pipeline/evaluate.h"

namespace fusee::search::one_spring {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// At one angle: torque, its first two derivatives, the energy since the first angle [Nm, rad].
constexpr std::size_t kValues = 4;
using Place = std::array<double, kValues>;

/// What limits a contour at one angle, each at most its limit. Of a roller: curvature of its centre's curve, the same from below, pressure
/// angle, size. Of a cable: radius of curvature and arm from below, size.
constexpr std::size_t kFigures = 4;
using Limited = std::array<double, kFigures>;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A law that is known at one angle, the last one stated.
class OnePlace final : public spring::SpringLaw {
public:
    void state(const Place& place) {
        p_.tau = p_.f_se = p_.f_pe = place[0];
        p_.s = p_.p = place[1];
        p_.s_slope = p_.p_slope = place[2];
        p_.u_se = p_.u_pe = place[3];
    }
    [[nodiscard]] core::Range loads() const override { return {p_.tau, p_.tau}; }
    [[nodiscard]] core::Range angles() const override { return {0.0, 0.0}; }
    [[nodiscard]] spring::LawPoint at_load(double) const override { return p_; }
    [[nodiscard]] spring::LawPoint at_angle(double) const override { return p_; }

private:
    spring::LawPoint p_;
};

/// The step of least |residual + step|^2 in the metric whose inverse is given, with g + gradient step >= 0; by coordinates of the dual
/// (C. Hildreth, Naval Research Logistics Quarterly 4, 1957).
struct Step {
    VectorXd way, prices;
};
Step quadratic_step(const MatrixXd& inverse, const VectorXd& residual, const MatrixXd& gradient, const VectorXd& g) {
    constexpr int kSweeps = 300;
    constexpr double kSettled = 1e-7;
    const MatrixXd moved = inverse * gradient.transpose(), q = gradient * moved;
    const VectorXd c = g - gradient * residual;
    Step step{-residual, VectorXd::Zero(g.size())};
    double change = 1.0;
    for (int sweep = 0; sweep < kSweeps && change > kSettled; ++sweep) {
        change = 0.0;
        for (Eigen::Index i = 0; i < g.size(); ++i) {
            const double next = std::max(0.0, step.prices[i] - (q.col(i).dot(step.prices) + c[i]) / (q(i, i) + 1e-12));
            change = std::max(change, std::abs(next - step.prices[i]) / (1.0 + next));
            step.prices[i] = next;
        }
    }
    step.way += moved * step.prices;
    return step;
}

/// The problem of one part; torques over the largest wanted one.
class Nearest {
public:
    Nearest(const pipeline::AskedPart& part, cam::CamOptions options, const std::vector<double>& wanted)
        : place_(std::make_shared<OnePlace>()),
          arms_(part.kind, place_, part.design->spec(part.kind).spring, part.design->profile.rig.capstan_radius,
                part.design->spec(part.kind).allowance),
          options_(std::move(options)),
          wanted_(Eigen::Map<const VectorXd>(wanted.data(), static_cast<Eigen::Index>(wanted.size()))) {
        unit_ = wanted_.cwiseAbs().maxCoeff();
        wanted_ /= unit_;
        add_operators(part.design->law()->angles().width());
        inverse_ = (values_[0].transpose() * values_[0] / static_cast<double>(values_[0].rows())).inverse();
    }

    /// The size of each figure by its median over the angle of this law, in which margins are measured.
    void set_scales(const VectorXd& x) {
        const std::vector<Place> all = places(x);
        for (std::size_t k = 0; k < kFigures; ++k) {
            std::vector<double> sizes;
            for (const Place& place : all) sizes.push_back(std::abs(figures(place)[k]));
            std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
            scales_[k] = std::max(sizes[sizes.size() / 2], 1e-9);
        }
    }
    [[nodiscard]] double scale(std::size_t k) const { return scales_[k]; }
    [[nodiscard]] double distance(const VectorXd& x) const { return (values_[0] * (x - wanted_)).norm(); }

    [[nodiscard]] VectorXd relative(const std::vector<double>& points) const {
        return Eigen::Map<const VectorXd>(points.data(), static_cast<Eigen::Index>(points.size())) / unit_;
    }
    [[nodiscard]] std::vector<double> torques(const VectorXd& x) const {
        const VectorXd all = unit_ * x;
        return {all.data(), all.data() + all.size()};
    }
    /// The largest of each figure over the angle.
    [[nodiscard]] Limited largest(const VectorXd& x) const {
        Limited most;
        most.fill(-kNoLimit);
        for (const Place& place : places(x)) {
            const Limited at = figures(place);
            for (std::size_t k = 0; k < kFigures; ++k) most[k] = std::max(most[k], at[k]);
        }
        return most;
    }

    /// From a law within the limits to the nearest one.
    [[nodiscard]] VectorXd solve(VectorXd x, const Limited& limits) const {
        constexpr int kSteps = 20;
        constexpr double kSettled = 1e-3, kLeastShare = 1e-3;  // of the merit, of a step
        double price = 1.0;
        for (int i = 0; i < kSteps; ++i) {
            const auto [g, gradient] = margins(x, limits);
            const Step step = quadratic_step(inverse_, x - wanted_, gradient, g);
            if (step.prices.size() > 0) price = std::max(price, 2.0 * step.prices.maxCoeff());
            const double before = merit(x, limits, price);
            double share = 1.0;
            while (share > kLeastShare && !(merit(x + share * step.way, limits, price) < before)) share *= 0.5;
            if (share <= kLeastShare) break;
            x += share * step.way;
            if (merit(x, limits, price) > (1.0 - kSettled) * before) break;
        }
        return x;
    }

private:
    /// Matrices that give torque, derivatives and energy, at the points and between them, of the curve through the points.
    void add_operators(double travel) {
        const auto n = static_cast<std::size_t>(wanted_.size()), rows = 2 * n - 1;
        for (MatrixXd& m : values_) m = MatrixXd::Zero(static_cast<Eigen::Index>(rows), wanted_.size());
        std::vector<double> angles;
        for (std::size_t i = 0; i < n; ++i) angles.push_back(travel * static_cast<double>(i) / static_cast<double>(n - 1));
        const double step = travel / static_cast<double>(rows - 1);
        for (std::size_t k = 0; k < n; ++k) {
            std::vector<double> one(n, 0.0);
            one[k] = 1.0;
            const math::CurvePtr curve = math::make_interpolant(angles, one);
            const auto col = static_cast<Eigen::Index>(k);
            for (Eigen::Index i = 0; i < values_[0].rows(); ++i) {
                const double at = step * static_cast<double>(i);
                values_[0](i, col) = curve->value(at);
                values_[1](i, col) = curve->derivative(at, 1);
                values_[2](i, col) = curve->derivative(at, 2);
                if (i > 0) values_[3](i, col) = values_[3](i - 1, col) + 0.5 * step * (values_[0](i, col) + values_[0](i - 1, col));
            }
        }
    }
    [[nodiscard]] std::vector<Place> places(const VectorXd& x) const {
        std::vector<Place> all(static_cast<std::size_t>(values_[0].rows()));
        for (std::size_t v = 0; v < kValues; ++v) {
            const VectorXd at = unit_ * (values_[v] * x);
            for (std::size_t i = 0; i < all.size(); ++i) all[i][v] = at[static_cast<Eigen::Index>(i)];
        }
        return all;
    }
    /// Infinite where there is no contour.
    [[nodiscard]] Limited figures(const Place& place) const {
        place_->state(place);
        const cam::Contact c = cam::touch(arms_.kind(), arms_.at_load(place[0]), options_);
        const double size = std::hypot(c.path.h, c.path.slope);
        Limited all = {-c.path.rho, -kNoLimit, -c.arm.arm, size};
        if (options_.family == cam::Family::kRoller) {
            const double curvature = 1.0 / cam::pitch_radius(c.arm, options_);
            all = {curvature, -curvature, std::abs(cam::pressure_angle(c.arm, options_)), size};
        }
        for (double& figure : all)
            if (std::isnan(figure)) figure = kNoLimit;
        return all;
    }
    [[nodiscard]] double margin(std::size_t k, const Limited& at, const Limited& limits) const {
        constexpr double kMostMargin = 1e3;
        return std::clamp((limits[k] - at[k]) / scales_[k], -kMostMargin, kMostMargin);
    }
    /// Half of the mean square of the change, and a price for what is beyond a limit.
    [[nodiscard]] double merit(const VectorXd& x, const Limited& limits, double price) const {
        double sum = 0.5 * (values_[0] * (x - wanted_)).squaredNorm() / static_cast<double>(values_[0].rows());
        for (const Place& place : places(x)) {
            const Limited at = figures(place);
            for (std::size_t k = 0; k < kFigures; ++k)
                if (limits[k] < kNoLimit) sum += price * std::max(0.0, -margin(k, at, limits));
        }
        return sum;
    }
    /// Margins that are small, and their derivatives by the points.
    [[nodiscard]] std::pair<VectorXd, MatrixXd> margins(const VectorXd& x, const Limited& limits) const {
        constexpr double kNear = 0.3, kStep = 1e-6;
        std::vector<std::pair<double, VectorXd>> near;
        const std::vector<Place> all = places(x);
        Place scale{};
        for (const Place& place : all)
            for (std::size_t v = 0; v < kValues; ++v) scale[v] = std::max(scale[v], std::abs(place[v]));
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Limited at = figures(all[i]);
            std::array<Limited, kValues> moved;
            for (std::size_t v = 0; v < kValues; ++v) {
                Place other = all[i];
                other[v] += kStep * scale[v];
                moved[v] = figures(other);
            }
            for (std::size_t k = 0; k < kFigures; ++k) {
                if (limits[k] == kNoLimit || margin(k, at, limits) > kNear) continue;
                VectorXd gradient = VectorXd::Zero(x.size());
                for (std::size_t v = 0; v < kValues; ++v) {
                    const double slope = (margin(k, moved[v], limits) - margin(k, at, limits)) / (kStep * scale[v]);
                    if (std::isfinite(slope)) gradient += unit_ * slope * values_[v].row(static_cast<Eigen::Index>(i)).transpose();
                }
                near.emplace_back(margin(k, at, limits), std::move(gradient));
            }
        }
        VectorXd g(static_cast<Eigen::Index>(near.size()));
        MatrixXd gradient(g.size(), x.size());
        for (Eigen::Index i = 0; i < g.size(); ++i)
            g[i] = near[static_cast<std::size_t>(i)].first, gradient.row(i) = near[static_cast<std::size_t>(i)].second;
        return {g, gradient};
    }

    std::shared_ptr<OnePlace> place_;
    cam::ArmFunction arms_;
    cam::CamOptions options_;
    double unit_ = 1.0;  ///< [Nm]
    VectorXd wanted_;
    Limited scales_{};
    std::array<MatrixXd, kValues> values_;
    MatrixXd inverse_;  ///< of the metric: the mean square over the angle
};

/// Each limit is given up as far as the rules allow, one after the other: what they judge is theirs alone.
class Relaxation {
public:
    using Holds = std::function<bool(const std::vector<double>&)>;
    Relaxation(const Nearest& problem, VectorXd start, const Holds& holds)
        : problem_(problem), holds_(holds), best_(std::move(start)), limits_(problem.largest(best_)) {}

    VectorXd run() {
        constexpr int kRounds = 2;
        failing_.fill(kNoLimit);
        if (!find_limits()) return best_;
        for (int round = 0; round < kRounds; ++round)
            for (std::size_t k = 0; k < kFigures; ++k) relax(k);
        return best_;
    }

private:
    /// The nearest law within the figures of the first one, or a little less.
    bool find_limits() {
        const Limited first = limits_;
        for (const double less : {0.0, 0.003, 0.02}) {
            for (std::size_t k = 0; k < kFigures; ++k) {
                limits_[k] = first[k] - less * problem_.scale(k);
                if (!std::isfinite(limits_[k])) limits_[k] = kNoLimit;
            }
            if (holds()) return true;
        }
        return false;
    }
    /// Without a limit, or, if a rule breaks then, with one half-way to where it breaks, again and again.
    void relax(std::size_t k) {
        constexpr int kSteps = 6;
        if (limits_[k] == kNoLimit) return;
        double holding = std::exchange(limits_[k], kNoLimit);
        if (failing_[k] == kNoLimit) {
            if (holds()) return;
            const double free = problem_.largest(problem_.solve(best_, limits_))[k];
            failing_[k] = std::isfinite(free) && free > holding ? free : holding + problem_.scale(k);
        }
        for (int i = 0; i < kSteps; ++i) {
            limits_[k] = 0.5 * (holding + failing_[k]);
            (holds() ? holding : failing_[k]) = limits_[k];
        }
        limits_[k] = holding;
    }
    /// Does the nearest law within the limits break no rule?
    bool holds() {
        const VectorXd x = problem_.solve(best_, limits_);
        if (!holds_(problem_.torques(x))) return false;
        if (problem_.distance(x) < problem_.distance(best_)) best_ = x;
        return true;
    }

    const Nearest& problem_;
    const Holds& holds_;
    VectorXd best_;
    Limited limits_, failing_{};
};

}  // namespace

std::vector<double> nearest_points(const profile::Profile& part, const std::vector<double>& wanted,
                                   const std::function<bool(const std::vector<double>&)>& holds) {
    const std::vector<double>& now = std::get<profile::OneSpring>(part.law.curves).rows.y;
    if (part.has_two_cables()) return now;
    const pipeline::Evaluation seen = pipeline::evaluate(part, pipeline::Depth::kCam);
    if (seen.parts.empty() || !seen.parts.front().cam) return now;
    Nearest problem(pipeline::parts_of(*seen.design).front(), seen.parts.front().cam->options, wanted);
    problem.set_scales(problem.relative(now));
    return problem.torques(Relaxation(problem, problem.relative(now), holds).run());
}

}  // namespace fusee::search::one_spring
