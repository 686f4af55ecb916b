#include "fusee/inference/fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "fusee/core/module.h"
#include "refine.h"
#include "solver/least_squares.h"

namespace fusee::inference {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Weight of a residual under the loss, 1 at 0.
double cut(double r) { return 1.0 / (1.0 + r * r / (kCauchy * kCauchy)); }

/// A residual and its x.
struct Seen {
    Eigen::VectorXd x, residual;
    [[nodiscard]] bool is_at(const Eigen::VectorXd& other) const { return residual.size() > 0 && x.size() == other.size() && x == other; }
};

/// All residuals and all priors: Ceres's own loss acts on blocks, so that each row's loss is taken here, as its square root.
/// Build tolerances act nearly linearly: their columns are handed in and held, those of the effects are taken anew at every step.
class Rows {
public:
    /// @param taken where Ceres last took a step from; at first that of `fit`
    Rows(const Problem& problem, const Fit& fit, const Scales& scales, HeldSlopes& held, Seen& taken, unsigned jobs)
        : problem_(problem),
          causes_(fit.causes),
          held_(held),
          taken_(taken),
          tried_{fit.x, fit.residual},
          mean_(problem.prior_mean(fit.causes)),
          scale_(fit.spread),
          jobs_(jobs) {
        for (int i = 0; i < scale_.size(); ++i) scale_[i] *= scales[problem.experiment_of(i)];
        size_ = problem.dimension(causes_);
    }
    void operator()(const double* at, double* residuals, double* slopes) {
        const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(at, size_);
        if (!tried_.is_at(x)) tried_ = {x, problem_.residual(causes_, x)};
        const Eigen::VectorXd raw = tried_.residual.cwiseQuotient(scale_);
        const int rows = problem_.residual_count();
        Eigen::VectorXd slope(rows);
        for (int i = 0; i < rows; ++i) {
            const double root = std::sqrt(loss(raw[i])), w = problem_.root_weight()[i];
            residuals[i] = w * std::copysign(root, raw[i]);
            slope[i] = w / scale_[i] * (root > 1e-6 ? std::abs(raw[i]) * cut(raw[i]) / root : 1.0);
        }
        for (int k = 0; k < size_; ++k) residuals[rows + k] = (x[k] - mean_[k]) / problem_.prior_sigma(causes_, k);
        if (slopes == nullptr) return;
        taken_ = tried_;
        Eigen::Map<RowMajor> matrix(slopes, rows + size_, size_);
        const auto build = static_cast<int>(held_.at.size());
        problem_.renew(held_, causes_, x, jobs_);
        matrix.topLeftCorner(rows, build) = slope.asDiagonal() * held_.slopes;
        matrix.topRightCorner(rows, size_ - build) = slope.asDiagonal() * problem_.slopes(causes_, x, build, size_, jobs_);
        matrix.bottomRows(size_).setZero();
        for (int k = 0; k < size_; ++k) matrix(rows + k, k) = 1.0 / problem_.prior_sigma(causes_, k);
    }

private:
    const Problem& problem_;
    const Causes& causes_;
    HeldSlopes& held_;
    Seen& taken_;
    Seen tried_;
    Eigen::VectorXd mean_, scale_;
    unsigned jobs_;
    int size_ = 0;
};

Eigen::VectorXd prior_precision(const Problem& problem, const Causes& causes) {
    Eigen::VectorXd precision(problem.dimension(causes));
    for (int k = 0; k < precision.size(); ++k) precision[k] = 1.0 / std::pow(problem.prior_sigma(causes, k), 2);
    return precision;
}

/// Laplace: log Z = -cost/2 - log det(H)/2 + log det(prior)/2.
void weigh(const Problem& problem, Fit& fit) {
    const Eigen::LLT<Eigen::MatrixXd> root(information(problem, fit, fit.seen()));
    fit.covariance = root.solve(Eigen::MatrixXd::Identity(fit.x.size(), fit.x.size()));
    const double log_det = 2.0 * Eigen::MatrixXd(root.matrixL()).diagonal().array().log().sum();
    fit.log_evidence = -0.5 * fit.cost - 0.5 * log_det + 0.5 * prior_precision(problem, fit.causes).array().log().sum();
}

/// Size of a draw.
double reach_of(Problem::Role role, double x) {
    switch (role) {
        case Problem::Role::kBuild:
            return kBuildDraw;
        case Problem::Role::kFurther:
            return kFurtherDraw * std::abs(x);
        case Problem::Role::kPhase:
            return kEffectDraw;  // where a phase is 0 says nothing about its accuracy
        case Problem::Role::kSize:
        case Problem::Role::kCount:
            break;
    }
    return kEffectDraw * std::abs(x);
}

/// A sign for draw `i` of parameter `k`, the same in every run: bits of a multiplicative hash.
double sign_of(int i, int k) {
    const auto hash = (static_cast<std::uint32_t>(i) * 40503U + static_cast<std::uint32_t>(k) + 1U) * 2654435761U;
    return ((hash >> 17U) & 1U) != 0U ? 1.0 : -1.0;
}

}  // namespace

Eigen::MatrixXd information(const Problem& problem, const Fit& fit, const Eigen::VectorXd& seen, const std::vector<bool>* kept) {
    const Eigen::VectorXd w = robust_weights(problem, seen, kept).cwiseQuotient(fit.spread);
    const Eigen::MatrixXd weighted = w.asDiagonal() * fit.jacobian;
    Eigen::MatrixXd hessian = weighted.transpose() * weighted;
    hessian.diagonal() += prior_precision(problem, fit.causes);
    return hessian;
}

Eigen::VectorXd spread_of(const Problem& problem, const Causes& causes, const Eigen::VectorXd& x, unsigned jobs) {
    std::vector<Eigen::VectorXd> places(2 * kPairsOfDraws, x);
    const auto build = static_cast<int>(problem.build().size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        Eigen::VectorXd& near = places[i];
        for (int k = 0; k < near.size(); ++k) {
            // A log tells the figures of a simulator far closer than their tolerances: draws of those would hold what is only curved for a
            // slip, and a figure that is freed as a cause, with a smaller draw, would win by that alone.
            const bool stated = k >= build || (problem.build()[static_cast<std::size_t>(k)].stated && !problem.has_figures());
            const double reach = stated ? reach_of(problem.role(causes, k), x[k]) : kEffectDraw;
            near[k] += (i % 2 == 0 ? 1.0 : -1.0) * sign_of(static_cast<int>(i / 2), k) * reach;
        }
    }
    places.push_back(x);
    const std::vector<Eigen::VectorXd> seen = problem.thin_residuals(causes, places, jobs);
    Eigen::VectorXd square = Eigen::VectorXd::Zero(problem.residual_count());
    for (std::size_t i = 0; i + 1 < seen.size(); i += 2)
        square += (0.5 * (seen[i] + seen[i + 1]) - seen.back()).cwiseAbs2() / static_cast<double>(kPairsOfDraws);
    return (square.array() + 1.0).sqrt();
}

WorstNuisancePull worst_nuisance_pull(const Problem& problem, const Fit& fit) {
    WorstNuisancePull most;
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        if (const double x = fit.x[static_cast<Eigen::Index>(k)];
            problem.build()[k].of_workshop && problem.build()[k].stated && std::abs(x) > std::abs(most.sigmas))
            most = {k, x};
    return most;
}

double loss(double r) { return kCauchy * kCauchy * std::log1p(r * r / (kCauchy * kCauchy)); }

namespace {

/// T^2 of each experiment, and its number of rows.
struct Misfit {
    std::vector<double> square, rows;
};
Misfit misfit(const Problem& problem, const Eigen::VectorXd& residual, const std::vector<bool>* kept) {
    const std::size_t experiments = problem.experiments().size();
    Misfit m{std::vector<double>(experiments), std::vector<double>(experiments)};
    for (int i = 0; i < residual.size(); ++i) {
        if (kept != nullptr && !(*kept)[static_cast<std::size_t>(i)]) continue;
        const std::size_t e = problem.experiment_of(i);
        m.square[e] += loss(residual[i]);
        m.rows[e] += 1.0;
    }
    for (std::size_t e = 0; e < experiments; ++e) m.square[e] /= std::max(1.0, m.rows[e]);
    return m;
}

/// rho of T^2 (eq. 11).
double fair(double square) { return square <= kFair * kFair ? square : kFair * kFair * (1.0 + std::log(square / (kFair * kFair))); }

}  // namespace

std::vector<double> misfits(const Problem& problem, const Eigen::VectorXd& residual) {
    std::vector<double> roots = misfit(problem, residual, nullptr).square;
    for (double& root : roots) root = std::sqrt(root);
    return roots;
}

double evidence_left(const Problem& problem, const Eigen::VectorXd& residual) {
    const Misfit m = misfit(problem, residual, nullptr);
    double left = 0.0;
    for (std::size_t e = 0; e < m.square.size(); ++e)
        left += 0.5 * problem.experiments()[e].weight * m.rows[e] * std::max(0.0, fair(m.square[e]) - 1.0);
    return left;
}

Scales scales_of(const Problem& problem, const Eigen::VectorXd& residual, const std::vector<bool>* kept) {
    const Misfit m = misfit(problem, residual, kept);
    Scales scales;
    for (const double square : m.square) scales.push_back(std::max(1.0, std::sqrt(square) / kFair));
    return scales;
}

Eigen::VectorXd robust_weights(const Problem& problem, const Eigen::VectorXd& residual, const std::vector<bool>* kept) {
    const Scales scales = scales_of(problem, residual, kept);
    Eigen::VectorXd w = problem.root_weight();
    for (int i = 0; i < w.size(); ++i) {
        const double scale = scales[problem.experiment_of(i)], size = std::abs(residual[i]) / scale;
        w[i] /= scale;
        if (kept != nullptr && !(*kept)[static_cast<std::size_t>(i)]) w[i] = 0.0;
        w[i] *= std::sqrt(cut(size));
    }
    return w;
}

double cost_of(const Problem& problem, const Causes& causes, const Eigen::VectorXd& residual, const Eigen::VectorXd& x,
               const std::vector<bool>* kept) {
    const Misfit m = misfit(problem, residual, kept);
    double cost = 0.0;
    for (std::size_t e = 0; e < m.square.size(); ++e) cost += problem.experiments()[e].weight * m.rows[e] * fair(m.square[e]);
    const Eigen::VectorXd off = x - problem.prior_mean(causes);
    for (int k = 0; k < x.size(); ++k) cost += std::pow(off[k] / problem.prior_sigma(causes, k), 2);
    return cost;
}

Eigen::VectorXd linear_step(const Problem& problem, const Causes& causes, const Eigen::VectorXd& x, const Eigen::VectorXd& residual,
                            const Eigen::MatrixXd& jacobian, const std::vector<bool>* kept) {
    const Eigen::VectorXd precision = prior_precision(problem, causes);
    std::vector<Eigen::Index> rows;  // those with a weight
    for (Eigen::Index i = 0; i < residual.size(); ++i)
        if (kept == nullptr || (*kept)[static_cast<std::size_t>(i)]) rows.push_back(i);
    const Eigen::MatrixXd seen = jacobian(rows, Eigen::all);
    Eigen::VectorXd next = x, left = residual;
    for (int round = 0; round < 2; ++round) {  // the second with the weights of what is then left
        if (round > 0) left(rows) = residual(rows) + seen * (next - x);
        const Eigen::VectorXd w = robust_weights(problem, left, kept)(rows);
        const Eigen::MatrixXd weighted = w.asDiagonal() * seen;
        Eigen::MatrixXd hessian(x.size(), x.size());
        hessian.setZero();
        hessian.selfadjointView<Eigen::Lower>().rankUpdate(weighted.transpose());
        hessian.diagonal() += precision;
        const Eigen::VectorXd gradient =
            weighted.transpose() * w.cwiseProduct(residual(rows)) + precision.cwiseProduct(x - problem.prior_mean(causes));
        next = x - hessian.selfadjointView<Eigen::Lower>().llt().solve(gradient);
        for (int k = 0; k < next.size(); ++k) {
            const core::Range range = problem.allowed(causes, k);
            next[k] = std::clamp(next[k], range.low, range.high);
        }
    }
    return next;
}

namespace {

/// @param held is left as it was last
/// @return a residual that was seen, mostly the one at the end
Seen solve(const Problem& problem, Fit& fit, const Scales& scales, HeldSlopes& held, const FitOptions& options) {
    // Ceres brings LAPACK, whose threads wait busily at the start: it is loaded when a fit asks for it.
    static const auto least_squares =
        reinterpret_cast<decltype(&fusee_least_squares)>(core::loaded_function("fusee_ceres.so", "fusee_least_squares"));
    Seen taken;
    Rows rows(problem, fit, scales, held, taken, options.jobs);
    LeastSquares squares{problem.residual_count() + static_cast<int>(fit.x.size()), std::ref(rows), {}, options.steps};
    for (int k = static_cast<int>(problem.build().size()); k < fit.x.size(); ++k) squares.last.push_back(problem.allowed(fit.causes, k));
    least_squares(squares, fit.x);
    return taken;
}

/// Residual, spread and cost at x.
void evaluate(const Problem& problem, Fit& fit, const FitOptions& options, const Seen& known = {}) {
    fit.x = problem.with_positive_ripples(fit.causes, fit.x);
    fit.residual = known.is_at(fit.x) ? known.residual : problem.residual(fit.causes, fit.x);
    fit.spread = spread_of(problem, fit.causes, fit.x, options.jobs);
    const Eigen::VectorXd weight = problem.root_weight().cwiseAbs2();
    fit.cost = cost_of(problem, fit.causes, fit.seen(), fit.x) + 2.0 * weight.dot(fit.spread.array().log().matrix());
}

}  // namespace

Fit fit(const Problem& problem, const Causes& causes, const Eigen::VectorXd& start, const FitOptions& options) {
    Fit fit;
    fit.causes = causes;
    fit.x = start;
    const auto build = static_cast<int>(problem.build().size());
    evaluate(problem, fit, options);
    Fit now = fit;
    HeldSlopes held;
    Eigen::VectorXd held_at;  // all of x, of the slopes that are held
    const auto hold = [&](const Eigen::VectorXd& x) {
        if (problem.slopes_hold_between(causes, held_at, x)) return;
        held = {problem.slopes(causes, x, 0, build, options.jobs), x.head(build)};
        held_at = x;
    };
    const int rounds = fit.x.size() > 0 ? kMostRounds : 0;  // Ceres takes no block without a parameter
    for (int round = 1; round <= rounds; ++round) {
        const double before = now.cost;
        if (round == 1 || !problem.has_figures()) hold(now.x);
        const Seen taken = solve(problem, now, scales_of(problem, now.seen()), held, options);
        evaluate(problem, now, options, taken);
        if (now.cost < fit.cost) fit = now;
        if (round >= kLeastRounds && std::abs(before - now.cost) < kSettled) break;
    }
    if (problem.has_figures()) held_at = {};  // the last solve may have renewed them elsewhere
    hold(fit.x);
    fit.jacobian = joined(held.slopes, problem.slopes(causes, fit.x, build, fit.x.size(), options.jobs));
    weigh(problem, fit);
    return fit;
}

}  // namespace fusee::inference
