#include "penalised_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace fusee::math {

namespace {

class DenseFit final : public PenalisedFit {
public:
    DenseFit(Eigen::MatrixXd design, Eigen::MatrixXd penalty, Eigen::VectorXd y)
        : PenalisedFit(static_cast<std::size_t>(design.rows()), design.squaredNorm() / penalty.squaredNorm()),
          design_(std::move(design)),
          penalty_(std::move(penalty)),
          y_(std::move(y)) {}

    [[nodiscard]] Result solve(double lambda) const override {
        const Eigen::Index rows = design_.rows(), count = design_.cols(), all = rows + penalty_.rows();
        Eigen::MatrixXd stacked(all, count);
        stacked << design_, std::sqrt(lambda) * penalty_;
        Eigen::VectorXd right = Eigen::VectorXd::Zero(all);
        right.head(rows) = y_;
        // Rank-revealing: without a penalty, knots without rows between them leave coefficients free; the least ones are chosen.
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(stacked);
        const Eigen::VectorXd coefficients = factors.solve(right);
        Result result;
        result.coefficients.assign(coefficients.begin(), coefficients.end());
        result.residual = (design_ * coefficients - y_).squaredNorm();
        const Eigen::MatrixXd q = factors.householderQ() * Eigen::MatrixXd::Identity(all, factors.rank());
        result.parameters = q.topRows(rows).squaredNorm();
        return result;
    }

private:
    Eigen::MatrixXd design_, penalty_;
    Eigen::VectorXd y_;
};

constexpr std::size_t kWidth = PenalisedFit::kDegree + 1;
using Band = std::array<double, kWidth>;

/// R and Q'y of a least-squares problem whose rows have at most kWidth neighbouring entries and come sorted by the first one: each row is
/// rotated into R, which keeps that width (Lawson & Hanson, Solving Least Squares Problems, 1974, chapter 27, with Givens' rotations).
class BandedQr {
public:
    explicit BandedQr(std::size_t count) : r_(count, Band{}), right_(count, 0.0) {}

    void add(std::size_t first, Band row, double y) {
        for (std::size_t k = first; k < r_.size(); ++k) {
            if (std::all_of(row.begin(), row.end(), [](double entry) { return entry == 0.0; })) break;
            rotate(k, row, y);
            std::move(row.begin() + 1, row.end(), row.begin());  // its first entry is 0 now
            row.back() = 0.0;
        }
        residual_ += y * y;
    }

    /// Row k of R: columns k to k + kWidth - 1.
    [[nodiscard]] const Band& row(std::size_t k) const { return r_[k]; }
    [[nodiscard]] double right(std::size_t k) const { return right_[k]; }
    /// Sum of squares that remains for any coefficients.
    [[nodiscard]] double residual() const { return residual_; }

    /// @pre no 0 on the diagonal
    [[nodiscard]] std::vector<double> solve() const {
        std::vector<double> c = right_;
        for (std::size_t k = c.size(); k-- > 0;) {
            for (std::size_t j = 1; j < kWidth && k + j < c.size(); ++j) c[k] -= r_[k][j] * c[k + j];
            c[k] /= r_[k][0];
        }
        return c;
    }
    /// |R'^-1 b|^2 of a row b: its leverage in the fit. @pre as solve
    [[nodiscard]] double leverage(std::size_t first, const Band& b) const {
        std::vector<double> u(r_.size() + kWidth, 0.0);
        std::copy(b.begin(), b.end(), u.begin() + static_cast<std::ptrdiff_t>(first));
        double sum = 0.0;
        for (std::size_t k = first; k < r_.size(); ++k) {
            u[k] /= r_[k][0];
            for (std::size_t j = 1; j < kWidth; ++j) u[k + j] -= r_[k][j] * u[k];
            sum += u[k] * u[k];
        }
        return sum;
    }

private:
    /// Turns row k of R and `row`, which begin in the same column, so that the latter's first entry vanishes.
    void rotate(std::size_t k, Band& row, double& y) {
        if (row[0] == 0.0) return;
        const double length = std::hypot(r_[k][0], row[0]), c = r_[k][0] / length, s = row[0] / length;
        const auto turn = [c, s](double& upper, double& lower) {
            const double turned = c * upper + s * lower;
            lower = c * lower - s * upper;
            upper = turned;
        };
        for (std::size_t j = 0; j < kWidth; ++j) turn(r_[k][j], row[j]);
        turn(right_[k], y);
    }

    std::vector<Band> r_;
    std::vector<double> right_;
    double residual_ = 0.0;
};

/// The data are rotated into a band once; each weight then works on that band and the penalty alone.
class BandedFit final : public PenalisedFit {
public:
    BandedFit(const std::vector<Row>& rows, std::size_t count) : PenalisedFit(rows.size(), 0.0), count_(count), data_(count) {
        double square = 0.0;
        for (const Row& row : rows) {
            for (const double value : row.values) square += value * value;
            data_.add(row.first, row.values, row.y);
        }
        double of_penalty = 0.0;
        for (const double value : kDifference) of_penalty += value * value;
        scale_ = square / (of_penalty * static_cast<double>(count - 3));
    }

    [[nodiscard]] Result solve(double lambda) const override {
        // Where there are no rows, only the penalty determines the coefficients: a trace of it always remains.
        const double weight = std::sqrt(std::max(lambda, kLeastShare * scale_));
        BandedQr both(count_);
        for (std::size_t i = 0; i < count_; ++i) {
            both.add(i, data_.row(i), data_.right(i));
            Band penalty{};
            for (std::size_t j = 0; j < kDifference.size(); ++j) penalty[j] = weight * kDifference[j];
            if (i + 3 < count_) both.add(i, penalty, 0.0);
        }
        Result result;
        result.coefficients = both.solve();
        result.residual = data_.residual();
        for (std::size_t i = 0; i < count_; ++i) {
            double difference = -data_.right(i);
            for (std::size_t j = 0; j < kWidth && i + j < count_; ++j) difference += data_.row(i)[j] * result.coefficients[i + j];
            result.residual += difference * difference;
            result.parameters += both.leverage(i, data_.row(i));
        }
        return result;
    }

private:
    static constexpr std::array<double, 4> kDifference{-1.0, 3.0, -3.0, 1.0};
    static constexpr double kLeastShare = 1e-20;

    std::size_t count_;
    BandedQr data_;
};

}  // namespace

double PenalisedFit::Result::score(double rows) const {
    const double left = rows - 1.4 * parameters;
    return left > 0.0 ? rows * residual / (left * left) : std::numeric_limits<double>::infinity();
}

double PenalisedFit::choose_lambda() const {
    constexpr double kLow = -9.0, kHigh = 9.0, kStep = 0.5;  // decades around the weight that balances data and penalty
    const auto score = [this](double decade) { return solve(scale_ * std::pow(10.0, decade)).score(rows_); };
    double best = kHigh, least = score(kHigh);  // ties and useless rows: the smoothest
    for (double decade = kHigh - kStep; decade >= kLow; decade -= kStep)
        if (const double now = score(decade); now < least) least = now, best = decade;
    constexpr int kBits = 12;  // a thousandth of a decade is finer than the score resolves
    const auto refined = boost::math::tools::brent_find_minima(score, best - kStep, best + kStep, kBits);
    return scale_ * std::pow(10.0, refined.second < least ? refined.first : best);
}

std::unique_ptr<const PenalisedFit> make_penalised_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count) {
    constexpr double kMostDense = 1e7;  // some 50 weights in about a second
    const double work = static_cast<double>(rows.size()) * static_cast<double>(count * count);
    return work <= kMostDense ? make_dense_fit(rows, count) : make_banded_fit(rows, count);
}

std::unique_ptr<const PenalisedFit> make_dense_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count) {
    const auto height = static_cast<Eigen::Index>(rows.size()), width = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(height, width);
    Eigen::VectorXd y(height);
    for (Eigen::Index i = 0; i < height; ++i) {
        const PenalisedFit::Row& row = rows[static_cast<std::size_t>(i)];
        for (std::size_t j = 0; j < row.values.size(); ++j) design(i, static_cast<Eigen::Index>(row.first + j)) = row.values[j];
        y(i) = row.y;
    }
    Eigen::MatrixXd penalty = Eigen::MatrixXd::Zero(width - 3, width);
    for (Eigen::Index i = 0; i + 3 < width; ++i) penalty.row(i).segment<4>(i) << -1.0, 3.0, -3.0, 1.0;
    return std::make_unique<DenseFit>(std::move(design), std::move(penalty), std::move(y));
}

std::unique_ptr<const PenalisedFit> make_banded_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count) {
    return std::make_unique<BandedFit>(rows, count);
}

}  // namespace fusee::math
