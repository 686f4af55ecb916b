#include "scene/poses.h"

#include <algorithm>
#include <cmath>

#include "fusee/actuator/equilibrium.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::Body, assembly::Motion, assembly::Pose, assembly::Side;
using Eigen::Isometry3d, Eigen::Vector3d;

constexpr int kLevels = 33, kShares = 21;
constexpr int kHalvings = 30;            // of the greatest torque: to 1e-9 of it
constexpr double kRangeRounding = 1e-6;  // of the working range, by which rounding may pass its end
constexpr int kSideChannels = kTurnAntagonist;

double sign_of(Side side) { return side == Side::kAntagonist ? -1.0 : 1.0; }

bool is_angle(int channel) { return channel == kJointAngle || channel % kSideChannels <= kSpoolAgonist; }

bool within(double value, double most) { return value >= -kRangeRounding * most && value <= (1.0 + kRangeRounding) * most; }

/// Rest of the frictionless joint; null beyond the laws.
std::optional<Pose> rest_of(const Assembly& a, const actuator::Joint& joint, double tau, double torque) {
    const auto found = actuator::find_equilibrium(joint, {tau, tau, torque});
    if (!found) return {};
    const Pose pose = assembly::pose_of(a, found->z[0], found->z[1], found->z[2]);
    for (const assembly::SidePose& side : {pose.agonist, pose.antagonist})
        if (!within(side.turn, a.greatest_turn) || !within(side.payout_mm, a.greatest_payout_mm)) return {};
    return pose;
}

/// The greatest joint torque with a pose, by halving; both directions are alike.
double most_torque(const Assembly& a, const actuator::Joint& joint, double tau) {
    double low = 0.0, high = 4.0 * tau * joint.ratio();  // no more than the springs of both sides exert together
    for (int i = 0; i < kHalvings; ++i) (rest_of(a, joint, tau, 0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return low;
}

PoseValues mean(const PoseValues& a, const PoseValues& b) {
    PoseValues out{};
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = 0.5 * (a[k] + b[k]);
    return out;
}

/// The interpolation against the joint itself, in the middle of each cell.
void measure_errors(PoseGrid& grid, const Assembly& a, const actuator::Joint& joint) {
    for (std::size_t i = 0; i + 1 < grid.tau.size(); ++i)
        for (std::size_t j = 0; j + 1 < grid.share.size(); ++j) {
            const double tau = 0.5 * (grid.tau[i] + grid.tau[i + 1]), most = 0.5 * (grid.most[i] + grid.most[i + 1]);
            const auto pose = rest_of(a, joint, tau, 0.5 * (grid.share[j] + grid.share[j + 1]) * most);
            if (!pose) continue;  // where `most` curves, a cell at its edge may reach beyond it
            const ChannelValues exact = channels_of(a, *pose);
            const PoseValues middle = mean(mean(grid.rows[i][j], grid.rows[i][j + 1]), mean(grid.rows[i + 1][j], grid.rows[i + 1][j + 1]));
            const ChannelValues read = channels_of(a, pose_from(middle));
            for (int k = 0; k < kChannels; ++k) {
                double& worst = is_angle(k) ? grid.error_rad : grid.error_mm;
                worst = std::max(worst, std::abs(read[static_cast<std::size_t>(k)] - exact[static_cast<std::size_t>(k)]));
            }
        }
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
    return rest_of(a, actuator::joint_of(actuator, false), tau, joint_torque);
}

std::optional<PoseGrid> pose_grid(const Assembly& a, const actuator::Actuator& actuator) {
    const actuator::Joint joint = actuator::joint_of(actuator, false);
    const core::Range loads = actuator.law->loads();
    const double low = std::max(actuator.least_torque, loads.low), high = std::min(actuator.overdrive_torque, loads.high);
    PoseGrid grid;
    for (int j = 0; j < kShares; ++j) grid.share.push_back(2.0 * j / (kShares - 1) - 1.0);
    for (int i = 0; i < kLevels; ++i) {
        const double tau = low + (high - low) * i / (kLevels - 1);
        if (!rest_of(a, joint, tau, 0.0)) continue;
        const double most = most_torque(a, joint, tau);
        std::vector<PoseValues> row;
        for (const double share : grid.share)
            if (const auto pose = rest_of(a, joint, tau, share * most)) row.push_back(values_of(*pose));
        if (row.size() != grid.share.size()) continue;
        grid.tau.push_back(tau), grid.most.push_back(most), grid.rows.push_back(std::move(row));
    }
    if (grid.tau.size() < 2) return {};
    measure_errors(grid, a, joint);
    return grid;
}

}  // namespace fusee::report
