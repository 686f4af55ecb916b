#include "fusee/mjcf/curve.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "fusee/core/error.h"

namespace fusee::mjcf {

namespace {

constexpr std::size_t kFirstCells = 128, kMostCells = 8192;
constexpr double kTableShare = 1e-5;     ///< of the greatest torque: a tenth of what the encoders of a rig would show
constexpr double kCamStop = 0.01;        ///< [rad], as joint_model::CamSpring (a test compares both)
constexpr std::size_t kCamCells = 1200;  ///< as joint_model::CamSpring

double row_of(const Curve& curve, std::size_t i) {
    return curve.low + (curve.high - curve.low) * static_cast<double>(i) / static_cast<double>(curve.torque.size() - 1);
}

Curve with_cells(const spring::Potential& spring, std::size_t cells) {
    const core::Range domain = spring.domain();
    Curve curve;
    curve.low = domain.low;
    curve.high = domain.high;
    curve.torque.resize(cells + 1);
    for (std::size_t i = 0; i <= cells; ++i) curve.torque[i] = spring.force(std::min(row_of(curve, i), domain.high));
    curve.end_stiffness = spring.stiffness(domain.high);
    for (std::size_t i = 0; i < cells; ++i) {
        const double middle = 0.5 * (row_of(curve, i) + row_of(curve, i + 1));
        curve.table_error = std::max(curve.table_error, std::abs(spring.force(middle) - curve.at(middle)));
    }
    return curve;
}

constexpr std::size_t kRows = 201;  ///< of the fit, even over the curve
constexpr int kCandidates = 400;    ///< values of `free`
constexpr int kRefinements = 40;    ///< halvings of the step between them
constexpr double kSlackest = 0.8;   ///< of the curve's width: the greatest `free`, for springs that begin slack
constexpr double kFarthest = 3.0;   ///< of the curve's width below its first row, or of the length on which its end slope loses the preload

struct Rows {
    Eigen::VectorXd x, torque;
};

Rows rows_of(const Curve& curve) {
    Rows rows{Eigen::VectorXd(kRows), Eigen::VectorXd(kRows)};
    for (std::size_t i = 0; i < kRows; ++i) {
        const double x = curve.low + (curve.high - curve.low) * static_cast<double>(i) / (kRows - 1);
        rows.x[static_cast<Eigen::Index>(i)] = x;
        rows.torque[static_cast<Eigen::Index>(i)] = curve.at(x);
    }
    return rows;
}

/// The cubic with its zero at `free` that is nearest to the rows, and their squared error; nothing if it would push.
std::optional<std::pair<Cubic, double>> with_zero_at(const Rows& rows, double free) {
    const Eigen::ArrayXd d = (rows.x.array() - free).max(0.0);
    Eigen::MatrixXd powers(rows.x.size(), 3);
    powers << d.matrix(), (d * d).matrix(), (d * d * d).matrix();
    const Eigen::Vector3d found = powers.colPivHouseholderQr().solve(rows.torque);
    const Eigen::VectorXd fitted = powers * found;
    if (!(found[0] >= 0.0) || fitted.minCoeff() < 0.0) return std::nullopt;
    Cubic cubic{.free = free, .linear = found[0], .square = found[1], .cube = found[2]};
    Eigen::Index at = 0;
    cubic.worst = (fitted - rows.torque).cwiseAbs().maxCoeff(&at);
    cubic.worst_at = rows.x[at];
    return std::pair(cubic, (fitted - rows.torque).squaredNorm());
}

/// A straight line through the last row, where no cubic fits: it pulls everywhere.
Cubic straight(const Rows& rows, double free) {
    Cubic line{.free = free, .linear = rows.torque[rows.torque.size() - 1] / (rows.x[rows.x.size() - 1] - free)};
    Eigen::Index at = 0;
    line.worst = (line.linear * (rows.x.array() - free) - rows.torque.array()).abs().maxCoeff(&at);
    line.worst_at = rows.x[at];
    return line;
}

}  // namespace

double Curve::at(double x) const {
    if (x < low) return std::max(0.0, torque.front() * (1.0 + (x - low) / stop_travel));
    if (x >= high) return torque.back() + end_stiffness * (x - high);
    const double place = (x - low) / (high - low) * static_cast<double>(torque.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), torque.size() - 2);
    return torque[i] + (place - static_cast<double>(i)) * (torque[i + 1] - torque[i]);
}

double Curve::greatest() const { return torque.back(); }

double Curve::greatest_stiffness() const {
    const double cell = (high - low) / static_cast<double>(torque.size() - 1);
    double most = end_stiffness;
    for (std::size_t i = 1; i < torque.size(); ++i) most = std::max(most, (torque[i] - torque[i - 1]) / cell);
    return most;
}

Curve tabulate(const spring::Potential& spring, double stop_travel) {
    core::require_positive("stop_travel", stop_travel, "rad");
    Curve curve = with_cells(spring, kFirstCells);
    while (curve.table_error > kTableShare * curve.greatest() && curve.torque.size() <= kMostCells / 2 + 1)
        curve = with_cells(spring, 2 * (curve.torque.size() - 1));
    curve.stop_travel = stop_travel;
    return curve;
}

Curve tabulate(const joint_model::CamSpring& spring, double hysteresis) {
    Curve curve;
    curve.high = spring.end();
    curve.torque.resize(kCamCells + 1);
    for (std::size_t i = 0; i <= kCamCells; ++i) curve.torque[i] = spring.torque(row_of(curve, i));
    curve.torque.front() = spring.torque(1e-12 * curve.high);  // at 0 itself, not on its stop below
    curve.end_stiffness = (spring.torque(2.0 * curve.high) - curve.torque.back()) / curve.high;
    curve.stop_travel = kCamStop;
    curve.hysteresis = hysteresis;
    return curve;
}

double Cubic::at(double x) const {
    const double d = x - free;
    return d <= 0.0 ? 0.0 : d * (linear + d * (square + d * cube));
}

Cubic fit_cubic(const Curve& curve) {
    const Rows rows = rows_of(curve);
    const double width = curve.high - curve.low;
    const double slope = (curve.greatest() - curve.torque.front()) / width;
    const double reach = kFarthest * std::max(width, slope > 0.0 ? curve.torque.front() / slope : 0.0);
    Cubic best = straight(rows, curve.low - 1e-9 * width);
    double least = std::numeric_limits<double>::infinity(), step = (reach + kSlackest * width) / kCandidates;
    const auto consider = [&](double free) {
        const auto found = with_zero_at(rows, free);
        if (found && found->second < least) {
            best = found->first;
            least = found->second;
        }
    };
    for (int i = 0; i <= kCandidates; ++i) consider(curve.low + kSlackest * width - step * i);
    for (int i = 0; i < kRefinements; ++i, step *= 0.5)
        for (const double side : {-1.0, 1.0}) consider(std::min(curve.low + kSlackest * width, best.free + side * step));
    return best;
}

}  // namespace fusee::mjcf
