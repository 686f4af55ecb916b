#include "fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fusee/math/statistics.h"

namespace fusee::subsystem {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The rows of the kept blocks, as one column after the other.
class FitRows {
public:
    FitRows(const Law& law, const std::vector<std::size_t>& kept) : law_(law), of_record_(law.targets.size()) {
        for (const std::size_t b : kept) {
            auto& rows = of_record_[law.blocks[b].record];
            rows.insert(rows.end(), law.blocks[b].rows.begin(), law.blocks[b].rows.end());
            count_ += law.blocks[b].rows.size();
        }
        for (std::size_t k = 0; k < law.parameters.size(); ++k)
            if (law.parameters[k].prior > 0.0) priors_.push_back(k);
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] VectorXd residuals(const Values& values) const {
        VectorXd out(static_cast<Eigen::Index>(count_ + priors_.size()));
        Eigen::Index at = 0;
        std::vector<double> predicted;
        for (std::size_t r = 0; r < of_record_.size(); ++r) {
            if (of_record_[r].empty()) continue;
            stop_if_asked();
            law_.predict(r, values, predicted);
            const Target& target = law_.targets[r];
            for (const std::size_t i : of_record_[r]) out[at++] = (target.measured[i] - predicted[i]) / target.sigma[i];
        }
        for (const std::size_t k : priors_) out[at++] = prior_residual(law_.parameters[k], values[k]);
        return out;
    }

private:
    const Law& law_;
    std::vector<std::vector<std::size_t>> of_record_;
    std::size_t count_ = 0;
    std::vector<std::size_t> priors_;  // parameters whose plausible values count as one more row
};

double robust_deviation(const VectorXd& residuals) {
    std::vector<double> sizes(static_cast<std::size_t>(residuals.size()));
    for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = std::abs(residuals[static_cast<Eigen::Index>(i)]);
    return std::max(inference::kLeastDeviation, 1.4826 * math::upper_median(std::move(sizes)));
}

double huber_cost(const VectorXd& residuals, double limit) {
    double cost = 0.0;
    for (const double r : residuals) cost += std::abs(r) <= limit ? r * r : limit * (2.0 * std::abs(r) - limit);
    return cost;
}

/// Columns d residual / d z, z = parameter over its range.
MatrixXd jacobian(const Law& law, const FitRows& rows, const std::vector<std::size_t>& free, const Values& values, const VectorXd& at) {
    MatrixXd J(at.size(), static_cast<Eigen::Index>(free.size()));
    for (std::size_t j = 0; j < free.size(); ++j) {
        const Parameter& parameter = law.parameters[free[j]];
        Values moved = values;
        const double step = inference::kDifference * parameter.range() *
                            (values[free[j]] + inference::kDifference * parameter.range() > parameter.high ? -1.0 : 1.0);
        moved[free[j]] += step;
        J.col(static_cast<Eigen::Index>(j)) = (rows.residuals(moved) - at) * (parameter.range() / step);
    }
    return J;
}

Values stepped(const Law& law, const std::vector<std::size_t>& free, const Values& values, const VectorXd& step) {
    Values moved = values;
    for (std::size_t j = 0; j < free.size(); ++j) {
        const Parameter& parameter = law.parameters[free[j]];
        moved[free[j]] =
            std::clamp(values[free[j]] + step[static_cast<Eigen::Index>(j)] * parameter.range(), parameter.low, parameter.high);
    }
    return moved;
}

void set_covariance(const Law& law, const MatrixXd& A, Fit& fit) {
    const Eigen::Index n = A.rows();
    const MatrixXd ridge = A + MatrixXd::Identity(n, n) * (1e-12 * (A.diagonal().maxCoeff() + 1e-300));
    const MatrixXd C = ridge.ldlt().solve(MatrixXd::Identity(n, n));
    fit.covariance.assign(fit.free.size(), std::vector<double>(fit.free.size()));
    for (std::size_t i = 0; i < fit.free.size(); ++i)
        for (std::size_t j = 0; j < fit.free.size(); ++j)
            fit.covariance[i][j] = C(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * law.parameters[fit.free[i]].range() *
                                   law.parameters[fit.free[j]].range();
}

/// The step of least damped cost; a parameter at an end of its range that the step would leave stays there.
VectorXd bounded_step(const Law& law, const Fit& fit, MatrixXd damped, VectorXd b) {
    VectorXd step = -damped.ldlt().solve(b);
    bool held = false;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        const std::size_t k = fit.free[static_cast<std::size_t>(j)];
        const bool leaves = step[j] > 0.0 ? fit.values[k] >= law.parameters[k].high : fit.values[k] <= law.parameters[k].low;
        if (!leaves || step[j] == 0.0) continue;
        damped.row(j).setZero();
        damped.col(j).setZero();
        damped(j, j) = 1.0;
        b[j] = 0.0;
        held = true;
    }
    return held ? VectorXd(-damped.ldlt().solve(b)) : step;
}

/// One damped step that lowers the cost, or none: the damping rises until one does.
bool descend(const Law& law, const FitRows& rows, const MatrixXd& A, const VectorXd& b, double limit, double& damping, Fit& fit,
             VectorXd& residuals) {
    for (int tries = 0; tries < 8; ++tries, damping *= 6.0) {
        MatrixXd damped = A;
        damped.diagonal() += damping * A.diagonal() + VectorXd::Constant(A.rows(), 1e-12 * (A.diagonal().maxCoeff() + 1e-300));
        const Values moved = stepped(law, fit.free, fit.values, bounded_step(law, fit, damped, b));
        const VectorXd there = rows.residuals(moved);
        const double cost = huber_cost(there, limit);
        if (!(cost < fit.cost)) continue;
        fit.values = moved;
        fit.cost = cost;
        residuals = there;
        damping = std::max(1e-7, damping * 0.15);
        return true;
    }
    return false;
}

}  // namespace

double prior_residual(const Parameter& parameter, double value) {
    return parameter.prior > 0.0 ? (parameter.null_value - value) / parameter.prior : 0.0;
}

std::vector<double> residuals_of(const Law& law, std::size_t record, const Values& values) {
    stop_if_asked();
    std::vector<double> out;
    law.predict(record, values, out);
    const Target& target = law.targets[record];
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = (target.measured[i] - out[i]) / target.sigma[i];
    return out;
}

double Misfit::mean_square(const std::vector<std::size_t>& of_blocks) const {
    double sum = 0.0, count = 0.0;
    for (const std::size_t b : of_blocks) sum += squares[b], count += rows[b];
    return sum / count;
}

double Misfit::gap() const {
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) / std::accumulate(rows.begin(), rows.end(), 0.0));
}

Misfit misfit(const Law& law, const Values& values) {
    std::vector<std::vector<double>> residuals;
    for (std::size_t r = 0; r < law.targets.size(); ++r) residuals.push_back(residuals_of(law, r, values));
    Misfit out;
    for (const Block& block : law.blocks) {
        double squares = 0.0;
        for (const std::size_t i : block.rows) squares += residuals[block.record][i] * residuals[block.record][i];
        out.squares.push_back(squares);
        out.rows.push_back(static_cast<double>(block.rows.size()));
    }
    return out;
}

Values start_values(const Law& law) {
    Values values;
    for (const Parameter& parameter : law.parameters) values.push_back(parameter.null_value);
    return values;
}

std::vector<std::size_t> free_parameters(const Law& law, const std::vector<std::size_t>& effects) {
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < law.nominal; ++k) free.push_back(k);
    for (const std::size_t e : effects) free.insert(free.end(), law.effects[e].parameters.begin(), law.effects[e].parameters.end());
    return free;
}

Fit fit(const Law& law, const std::vector<std::size_t>& kept, const std::vector<std::size_t>& free, const Values& start, int most_steps) {
    const FitRows rows(law, kept);
    Fit fit{start, free, {}, 0.0, static_cast<double>(rows.count())};
    VectorXd residuals = rows.residuals(fit.values);
    double damping = 1e-3;
    MatrixXd A;
    for (int step = 0; step < most_steps; ++step) {
        const double limit = inference::kHuber * robust_deviation(residuals);
        fit.cost = huber_cost(residuals, limit);
        const MatrixXd J = jacobian(law, rows, free, fit.values, residuals);
        VectorXd weights = residuals;
        for (double& w : weights) w = std::abs(w) <= limit ? 1.0 : limit / std::abs(w);
        A = J.transpose() * weights.asDiagonal() * J;
        const double before = fit.cost;
        if (!descend(law, rows, A, J.transpose() * weights.cwiseProduct(residuals), limit, damping, fit, residuals)) break;
        if (before - fit.cost < inference::kLeastGain * before) break;
    }
    set_covariance(law, A, fit);
    return fit;
}

Fit fit_from_all_starts(const Law& law, const std::vector<std::size_t>& kept, const std::vector<std::size_t>& free, const Values& nominal) {
    std::vector<Values> starts{nominal};
    for (const std::size_t k : free) {
        if (law.parameters[k].starts.empty() || (k < law.nominal && free.size() > law.nominal)) continue;
        std::vector<Values> more;
        for (const Values& values : starts)
            for (const double at : law.parameters[k].starts) {
                more.push_back(values);
                more.back()[k] = at;
            }
        starts = std::move(more);
    }
    Fit best;
    for (const Values& start : starts) {
        Fit candidate = fit(law, kept, free, start);
        if (best.values.empty() || candidate.cost < best.cost) best = std::move(candidate);
    }
    return best;
}

}  // namespace fusee::subsystem
