#include "scene/poses.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/actuator/equilibrium.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::Body, assembly::Motion, assembly::Pose, assembly::Side;
using Eigen::Isometry3d, Eigen::Vector3d;

constexpr int kLevels = 33, kShares = 21;
constexpr double kRangeRounding = 1e-6;  // of the working range, by which rounding may pass its end
constexpr int kSideChannels = kTurnAntagonist;

double sign_of(Side side) { return side == Side::kAntagonist ? -1.0 : 1.0; }

bool is_angle(int channel) { return channel == kJointAngle || channel % kSideChannels <= kSpoolAgonist; }

/// The frictionless joint at rest under one co-contraction. Each search begins at the pose found last: they ask for neighbours.
class Rests {
public:
    Rests(const Assembly& a, const actuator::Joint& joint, double tau) : a_(a), joint_(joint), tau_(tau) {}

    void begin_at(const Pose& pose) { z_ = {pose.agonist.turn, pose.antagonist.turn, assembly::joint_angle(a_, pose)}; }
    /// Null beyond the laws; a pose may lie beyond the working range.
    std::optional<Pose> at(double torque) {
        const auto found = actuator::equilibrium(joint_, {tau_, tau_, torque}, z_);
        if (!found) return {};
        z_ = found->z;
        return assembly::pose_of(a_, z_[0], z_[1], z_[2]);
    }
    std::optional<Pose> within_range(double torque) {
        const auto pose = at(torque);
        return pose && slack(*pose) >= 0.0 ? pose : std::nullopt;
    }
    /// Share of the working range that is left to its nearest end; below 0 beyond it.
    [[nodiscard]] double slack(const Pose& pose) const {
        double least = std::numeric_limits<double>::infinity();
        for (const assembly::SidePose& side : {pose.agonist, pose.antagonist})
            for (const double share : {side.turn / a_.greatest_turn, side.payout_mm / a_.greatest_payout_mm})
                least = std::min({least, share, 1.0 - share});
        return least + kRangeRounding;
    }
    /// The greatest joint torque with a pose; both directions are alike. @param guess that of another level; 0: none
    double most_torque(const Pose& rest, double guess) {
        const double most = 4.0 * tau_ * joint_.ratio();  // no more than the springs of both sides exert together
        double low = 0.0, high = most,
               end = guess > 0.0 ? guess : 0.5 * most;  // `end`: where the secant of the last two poses ends the range
        double last = 0.0, last_slack = slack(rest);
        for (int i = 0; i < kSteps && high - low > kNear * most && std::abs(end - low) > kNear * most; ++i) {
            const double torque = low < end && end < high ? end : 0.5 * (low + high);
            const auto pose = at(torque);
            const double left = pose ? slack(*pose) : -1.0;
            (left >= 0.0 ? low : high) = torque;
            end = pose && left != last_slack ? torque + left * (torque - last) / (last_slack - left) - 0.5 * kNear * most
                                             : 0.5 * (low + high);
            if (pose) last = torque, last_slack = left;
        }
        return low;
    }

private:
    static constexpr int kSteps = 60;
    static constexpr double kNear = 1e-9;  // of the greatest torque
    const Assembly& a_;
    const actuator::Joint& joint_;
    double tau_;
    Eigen::Vector3d z_ = Eigen::Vector3d::Zero();  ///< both capstans and the joint [rad]
};

PoseValues mean(const PoseValues& a, const PoseValues& b) {
    PoseValues out{};
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = 0.5 * (a[k] + b[k]);
    return out;
}

/// The same joint with its sides exchanged.
PoseValues exchanged(const PoseValues& v) { return {v[2], v[3], v[0], v[1]}; }

/// The interpolation against the joint itself, in the middle of each cell with a positive torque: the others are alike.
void measure_errors(PoseGrid& grid, const Assembly& a, const actuator::Joint& joint) {
    for (std::size_t i = 0; i + 1 < grid.tau.size(); ++i) {
        const double tau = 0.5 * (grid.tau[i] + grid.tau[i + 1]), most = 0.5 * (grid.most[i] + grid.most[i + 1]);
        Rests rests(a, joint, tau);
        for (std::size_t j = kShares / 2; j + 1 < grid.share.size(); ++j) {
            const PoseValues middle = mean(mean(grid.rows[i][j], grid.rows[i][j + 1]), mean(grid.rows[i + 1][j], grid.rows[i + 1][j + 1]));
            rests.begin_at(pose_from(middle));
            const auto pose = rests.within_range(0.5 * (grid.share[j] + grid.share[j + 1]) * most);
            if (!pose) continue;  // where `most` curves, a cell at its edge may reach beyond it
            const ChannelValues exact = channels_of(a, *pose);
            const ChannelValues read = channels_of(a, pose_from(middle));
            for (int k = 0; k < kChannels; ++k) {
                double& worst = is_angle(k) ? grid.error_rad : grid.error_mm;
                worst = std::max(worst, std::abs(read[static_cast<std::size_t>(k)] - exact[static_cast<std::size_t>(k)]));
            }
        }
    }
}

/// A level's poses for every share, which the torques towards one side tell. Empty: no pose at some of them.
std::vector<PoseValues> level(Rests& rests, const PoseGrid& grid, double most) {
    std::vector<PoseValues> row(grid.share.size());
    for (std::size_t j = kShares / 2; j < row.size(); ++j) {
        const auto pose = rests.within_range(grid.share[j] * most);
        if (!pose) return {};
        row[j] = values_of(*pose), row[row.size() - 1 - j] = exchanged(row[j]);
    }
    return row;
}

}  // namespace

PoseValues values_of(const Pose& pose) {
    return {pose.agonist.turn, pose.agonist.payout_mm, pose.antagonist.turn, pose.antagonist.payout_mm};
}
Pose pose_from(const PoseValues& v) { return {{v[0], v[1]}, {v[2], v[3]}}; }

ChannelValues channels_of(const Assembly& a, const Pose& pose) {
    ChannelValues out{};
    std::size_t k = 0;
    for (const assembly::SidePose& side : {pose.agonist, pose.antagonist}) {
        out[k++] = side.turn;
        out[k++] = assembly::spool_angle(a, side.payout_mm);
        out[k++] = a.capstan_radius_mm * side.turn;
        out[k++] = assembly::drawn_mm(a, side.turn);
    }
    out[k] = assembly::joint_angle(a, pose);
    return out;
}

Follows follows(const Assembly& a, const Body& body) {
    const double sign = sign_of(body.side);
    const int first = body.side == Side::kAntagonist ? kTurnAntagonist : kTurnAgonist;
    const Vector3d back(0.0, -1.0, 0.0);
    switch (body.motion) {
        case Motion::kFixed:
            return {};
        case Motion::kCapstan:
            return {first, body.cam ? sign * a.drive.k_pe->cam.rotation_sign : sign, -1, Vector3d::Zero()};
        case Motion::kCarriage:
            return {-1, 0.0, first + kCarriageAgonist, back};
        case Motion::kSpool:
            return {first + kSpoolAgonist, sign * a.drive.k_se->cam.rotation_sign, first + kCarriageAgonist, back};
        case Motion::kSpringEnd:
            return {-1, 0.0, first + kDrawnAgonist, {-sign * std::cos(a.options.k_pe_direction), -std::sin(a.options.k_pe_direction), 0.0}};
        case Motion::kJoint:
            return {kJointAngle, 1.0, -1, Vector3d::Zero()};
    }
    return {};
}

Isometry3d placement(const Body& body, const Follows& f, const ChannelValues& values) {
    Isometry3d at = body.rest;
    if (f.turn >= 0) at.rotate(Eigen::AngleAxisd(f.gain * values.at(static_cast<std::size_t>(f.turn)), Vector3d::UnitZ()));
    if (f.slide >= 0) at.pretranslate(values.at(static_cast<std::size_t>(f.slide)) * f.direction);
    return at;
}

std::optional<Pose> resting_pose(const Assembly& a, const actuator::Actuator& actuator, double tau, double joint_torque) {
    const actuator::Joint joint = actuator::joint_of(actuator, false);
    return Rests(a, joint, tau).within_range(joint_torque);
}

std::optional<PoseGrid> pose_grid(const Assembly& a, const actuator::Actuator& actuator) {
    const actuator::Joint joint = actuator::joint_of(actuator, false);
    const core::Range loads = actuator.law->loads();
    const double low = std::max(actuator.least_torque, loads.low), high = std::min(actuator.overdrive_torque, loads.high);
    PoseGrid grid;
    for (int j = 0; j < kShares; ++j) grid.share.push_back(2.0 * j / (kShares - 1) - 1.0);
    double most = 0.0;
    for (int i = 0; i < kLevels; ++i) {
        const double tau = low + (high - low) * i / (kLevels - 1);
        Rests rests(a, joint, tau);
        const auto rest = rests.within_range(0.0);
        if (!rest) continue;
        most = rests.most_torque(*rest, most);
        rests.begin_at(*rest);
        std::vector<PoseValues> row = level(rests, grid, most);
        if (row.empty()) continue;
        grid.tau.push_back(tau), grid.most.push_back(most), grid.rows.push_back(std::move(row));
    }
    if (grid.tau.size() < 2) return {};
    measure_errors(grid, a, joint);
    return grid;
}

}  // namespace fusee::report
