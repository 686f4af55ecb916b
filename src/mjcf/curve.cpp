#include "fusee/mjcf/curve.h"

#include <algorithm>
#include <cmath>

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

}  // namespace fusee::mjcf
