#include "part_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fusee/cam/arm.h"
#include "fusee/core/lists.h"

namespace fusee::design::budget {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kRows = 48, kRowsPerPlace = 4;
constexpr int kNewtonSteps = 4;   // quadratic, from a start that is off by the error over the span
constexpr double kBeyond = 0.15;  // of a spring's range: built joints whose springs end earlier keep their dead-band

Vector2d unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }
Vector2d turned(const Vector2d& v, double angle) { return Eigen::Rotation2Dd(angle) * v; }

}  // namespace

PartModel::PartModel(const PartSubject& subject, double capstan_radius)
    : subject_(subject),
      capstan_radius_(capstan_radius),
      parallel_(subject.cam->options.guide.kind == cam::GuideKind::kParallel),
      rolls_(subject.cam->has_roller()) {
    const cam::Cam& cam = *subject.cam;
    const auto& working = cam.working;
    const std::size_t last = working.size() - 1;
    const Vector2d guide = cam.options.guide.distance * unit(cam.options.guide.direction);
    const cam::Contact& middle = working[last / 2];
    const Vector2d shift = turned(unit(middle.path.psi), cam.rotation_sign * middle.arm.angle);  // in the world
    double paid_out = 0.0;
    for (std::size_t i = 0; i <= kRows; ++i) {
        const cam::Contact& c = working[i * last / kRows];
        const double back = -cam.rotation_sign * c.arm.angle;
        const double pressure = rolls_ ? cam::pressure_angle(c.arm, cam.options) : 0.0;
        const double ratio = rolls_ ? cam::spring_ratio(c.arm, cam.options) : 1.0;
        Row row{c.arm.angle,
                c.path.psi,
                c.path.h,
                c.path.rho,
                c.arm.arm,
                c.arm.slope,
                c.path.slope,
                c.arm.state,
                0.0,
                0.0,
                0.0,
                unit(c.path.psi),
                turned(guide, back),
                turned(shift, back),
                ratio / std::cos(pressure),
                ratio * std::tan(pressure),
                0.0};
        if (!rows_.empty()) paid_out += 0.5 * (row.angle - rows_.back().angle) * (row.arm + rows_.back().arm);
        row.travel = cam.kind == cam::PartKind::kSeries ? paid_out / capstan_radius : row.angle;
        row.lever = left_of(row.n).dot(row.guide) - row.h_slope;
        row.across = row.n.dot(row.shift);
        row.gap = row.n.dot(row.guide) - c.path.h;
        rows_.push_back(row);
    }
    if (!rolls_) {
        nominal_ = spring({});
        const double end = nominal_->domain().high / (1.0 + kBeyond);
        for (Row& row : rows_) row.travel = std::min(row.travel, end);
    }
    for (std::size_t i = 0; i <= kRows; i += kRowsPerPlace) places_.push_back(i);
}

double PartModel::arm_change(const Row& row, const PartErrors& e) const {
    const double outward = e.offset() + e.runout.dot(row.n);
    if (parallel_) return outward + row.h_slope * e.guide;
    return outward + row.h_slope * (outward - e.guide * row.across) / row.lever;
}

double PartModel::torque(std::size_t at) const {
    return rolls_ ? subject_.spring.rate * rows_[at].state * rows_[at].arm : nominal_->force(rows_[at].travel);
}

double PartModel::lift_change(const Row& row, const PartErrors& e) const {
    return (e.offset() + e.runout.dot(row.n)) * row.along + e.guide * row.aside;
}

double PartModel::change(std::size_t at, const PartErrors& e) const {
    if (!rolls_) return linear(at, e) * torque(at);
    const std::size_t before = at == 0 ? 0 : at - 1, after = std::min(at + 1, rows_.size() - 1);
    const Row& row = rows_[at];
    const double arm = (lift_change(rows_[after], e) - lift_change(rows_[before], e)) / (rows_[after].angle - rows_[before].angle);
    const double lift = lift_change(row, e) - lift_change(rows_.front(), e), rate = subject_.spring.rate;
    const double of_spring = (e.rate * row.state + e.preload * subject_.spring.preload) * row.arm;
    return rate * (of_spring + row.state * arm + lift * row.arm + e.zero * (row.arm * row.arm + row.state * row.slope));
}

double PartModel::linear(std::size_t at, const PartErrors& e) const {
    const Row& row = rows_[at];
    double integral = 0.0;  // of the arm's change over the cam's angle
    for (std::size_t i = 1; i <= at; ++i)
        integral += 0.5 * (rows_[i].angle - rows_[i - 1].angle) * (arm_change(rows_[i], e) + arm_change(rows_[i - 1], e));
    const double of_spring = e.rate + e.preload * subject_.spring.preload / row.state;
    const double of_zero = e.zero * nominal_->stiffness(row.travel) / nominal_->force(row.travel);
    const double change = arm_change(row, e) / row.arm;
    if (subject_.cam->kind == cam::PartKind::kParallel) return of_spring + of_zero + change + integral / row.state;  // eq. 2
    return of_spring + of_zero - change + integral / row.arm * (row.slope / row.arm - 1.0 / row.state);              // eq. 3
}

double PartModel::exact_change(const Row& row, const PartErrors& e) const {
    // h about the row's normal, by its curve of curvature: the contact moves by the error over the span, so that the next term is
    // nanometres.
    const auto h = [&](double turn) { return row.h + turn * (row.h_slope + 0.5 * turn * (row.rho - row.h)); };
    const auto slope = [&](double turn) { return row.h_slope + turn * (row.rho - row.h); };
    double turn = parallel_ ? e.guide : 0.0;
    const Vector2d guide = row.guide + e.guide * row.shift;
    for (int step = 0; !parallel_ && step < kNewtonSteps; ++step) {
        const Vector2d n = unit(row.psi + turn), t = left_of(n);
        const double excess = n.dot(guide) - row.gap - (h(turn) + e.offset() + e.runout.dot(n));
        turn -= excess / (t.dot(guide) - slope(turn) - e.runout.dot(t));
    }
    return h(turn) + e.offset() + e.runout.dot(unit(row.psi + turn)) - row.h;
}

std::vector<double> PartModel::arms(const PartErrors& e) const {
    return core::each<double>(rows_, [&](const Row& row) { return row.arm + exact_change(row, e); });
}

spring::PotentialPtr PartModel::spring(const PartErrors& e) const {
    constexpr double kLeastArm = 1e-5;  // [m]: a grosser error leaves no arm
    const std::vector<double> arms = this->arms(e);
    std::vector<cam::FoundArm> found;
    for (std::size_t i = 0; i < rows_.size(); ++i) found.push_back({rows_[i].angle, std::max(arms[i], kLeastArm)});
    spring::BaseSpring built = subject_.spring;
    built.rate *= 1.0 + e.rate;
    built.preload *= 1.0 + e.preload;
    return spring::continued(cam::spring_of_arms(subject_.cam->kind, found, built, capstan_radius_, subject_.allowance), kBeyond);
}

}  // namespace fusee::design::budget
