#include <gtest/gtest.h>

#include "fixture.h"
#include "helix.h"
#include "taut_cable.h"

// Virtual work on the assembled joint: the energy of the base springs over the length of taut cables on the meshes as they stand in the
// assembly. No code of module cam takes part, neither contour nor arm; a helix' contact only says on which turn the cable lies.
namespace fusee::assembly {
namespace {

using taut::Vec;

/// Half of the plane's outline at a cam's height, in the assembly.
class Wrapped {
public:
    Wrapped(const Assembly& a, const Body& body, const Pose& pose) : at_(placement(a, body, pose)) {
        std::vector<Vec> floor;
        for (const solid::Vec3& p : body.cam->points_mm) {
            const Eigen::Vector3d q = at_ * Eigen::Vector3d(p[0], p[1], p[2]);
            if (std::abs(p[2]) < 1e-4) floor.push_back({q.x() - at_.translation().x(), q.y() - at_.translation().y()});
        }
        polygon_ = taut::hull(floor);
    }
    [[nodiscard]] double length(const Eigen::Vector3d& guide, std::size_t anchor, double half, double sense) const {
        return taut::length(polygon_, anchor, half, {guide.x() - at_.translation().x(), guide.y() - at_.translation().y()}, sense);
    }
    [[nodiscard]] double angle() const { return std::atan2(at_.linear()(1, 0), at_.linear()(0, 0)); }
    /// The vertex that is farthest in a direction of the body: every pose finds the same one.
    [[nodiscard]] std::size_t farthest(const Eigen::Vector3d& in_body) const {
        const Eigen::Vector3d n = at_.linear() * in_body;
        const auto reach = [&](const Vec& p) { return p[0] * n.x() + p[1] * n.y(); };
        const auto less = [&](const Vec& p, const Vec& q) { return reach(p) < reach(q); };
        return static_cast<std::size_t>(std::max_element(polygon_.begin(), polygon_.end(), less) - polygon_.begin());
    }

private:
    Eigen::Isometry3d at_;
    std::vector<Vec> polygon_;
};

struct Case {
    const char* profile;
    Side side;
};

class Balance : public ::testing::TestWithParam<Case> {
protected:
    /// Cable from the guide to a point of a helical K_PE that stays wound [m].
    double length_on_helix(const Assembly& a, const Pose& pose) {
        const Body& body = *a.find(std::string("k_pe_") + to_string(GetParam().side));
        const Eigen::Isometry3d at = placement(a, body, pose);
        const double mirror = GetParam().side == Side::kAntagonist ? -1.0 : 1.0, up = at.linear()(2, 2);
        Eigen::Vector3d guide, contact;
        for (const FreeCable& cable : free_cables(a, pose))
            if (cable.side == GetParam().side && cable.kind == CableKind::kParallel)
                guide = at.inverse() * cable.to_mm, contact = at.inverse() * cable.from_mm;
        if (floor_.empty()) floor_ = helix::floor(*body.cam, contact, core::rad_from_deg(0.5));
        constexpr double kTurnApart_mm = 1.0;  // less than half the land and groove between turns
        return 1e-3 * helix::cable_length(floor_, guide, 0.5 * a.cable_mm, -mirror * up, contact.z(), kTurnApart_mm);
    }
    /// Cable from the guide to a point of the cam that stays wound [m].
    double length(const Assembly& a, const std::string& part, const Pose& pose, double& angle) {
        if (part == "k_pe" && !a.drive.k_pe->cam.closed()) return length_on_helix(a, pose);
        const std::string of = std::string("_") + to_string(GetParam().side);
        const Body& body = *a.find(part + of);
        const Wrapped wrapped(a, body, pose);
        angle = wrapped.angle();
        const cam::Cam& cam = part == "k_se" ? a.drive.k_se->cam : a.drive.k_pe->cam;
        const double mirror = GetParam().side == Side::kAntagonist ? -1.0 : 1.0;
        const std::size_t anchor = wrapped.farthest({std::cos(cam.anchor_psi), mirror * std::sin(cam.anchor_psi), 0.0});
        Eigen::Vector3d guide;
        for (const FreeCable& cable : free_cables(a, pose))
            if (cable.side == GetParam().side && cable.kind == (part == "k_se" ? CableKind::kSeries : CableKind::kParallel) &&
                (part == "k_pe" || cable.to_mm.y() < -1.0))
                guide = cable.to_mm;
        // K_SE turns with its tension; K_PE's tension turns its capstan back, which the load turns counter-clockwise on the agonist's side.
        const double sense = mirror * (part == "k_se" ? static_cast<double>(cam.rotation_sign) : -1.0);
        return 1e-3 * wrapped.length(guide, anchor, 0.5 * a.cable_mm, sense);
    }
    [[nodiscard]] Pose pose(double turn, double payout_mm) const {
        return GetParam().side == Side::kAgonist ? Pose{{turn, payout_mm}, {}} : Pose{{}, {turn, payout_mm}};
    }
    std::vector<Eigen::Vector3d> floor_;  ///< of a helical K_PE, in its own frame
};

constexpr int kPoses = 40;

TEST_P(Balance, KPeHasItsTorque) {
    const Joint joint = shipped_joint(GetParam().profile);
    const Assembly& a = joint.assembly;
    const spring::BaseSpring& spring = a.drive.k_pe_spring;
    double angle = 0.0;
    const double at_rest = length(a, "k_pe", pose(0.0, 0.0), angle);
    const auto energy = [&](double turn) {
        const double state = spring.preload + length(a, "k_pe", pose(turn, 0.0), angle) - at_rest;
        return 0.5 * spring.rate * state * state;
    };
    const double step = 0.5 * a.greatest_turn / kPoses;
    for (int i = 0; i < kPoses; ++i) {
        const double turn = a.greatest_turn * (i + 0.5) / kPoses;
        const double torque = (energy(turn + step) - energy(turn - step)) / (2.0 * step);
        const double wanted = (joint.law->at_angle(turn + step).u_pe - joint.law->at_angle(turn - step).u_pe) / (2.0 * step);
        EXPECT_NEAR(torque / wanted, 1.0, 1e-3) << "capstan at " << turn << " rad";
    }
}

TEST_P(Balance, KSeHasItsTorque) {
    const Joint joint = shipped_joint(GetParam().profile);
    const Assembly& a = joint.assembly;
    if (!a.drive.k_se->cam.closed()) GTEST_SKIP() << "a helix: its cable leaves the plane";
    const spring::BaseSpring& spring = a.drive.k_se_spring;
    double at_rest = 0.0;
    const double length_at_rest = length(a, "k_se", pose(0.0, 0.0), at_rest);
    const double radius = 1e-3 * a.capstan_radius_mm, step = 0.5 * a.greatest_payout_mm / kPoses;
    const double sense = (GetParam().side == Side::kAntagonist ? -1.0 : 1.0) * a.drive.k_se->cam.rotation_sign;
    struct State {
        double energy, turn;
    };
    const auto state = [&](double payout_mm) {
        double angle = 0.0;
        const double paid = length_at_rest - length(a, "k_se", pose(0.0, payout_mm), angle);
        EXPECT_NEAR(paid, 1e-3 * payout_mm, 1e-3 * 1e-3 * a.greatest_payout_mm) << "the spool pays out what the carriage travels";
        const double turned = sense * (angle - at_rest), whole = 2.0 * core::kPi;  // less than one turn
        const double wound = spring.preload + turned - whole * std::floor((turned + 1e-9) / whole);
        return State{0.5 * spring.rate * wound * wound, paid / radius};
    };
    for (int i = 0; i < kPoses; ++i) {
        const State low = state(2.0 * step * i), high = state(2.0 * step * (i + 1));
        const double torque = (high.energy - low.energy) / (high.turn - low.turn);
        const double wanted = (joint.law->at_angle(high.turn).u_se - joint.law->at_angle(low.turn).u_se) / (high.turn - low.turn);
        EXPECT_NEAR(torque / wanted, 1.0, 1e-3) << "capstan at " << low.turn << " rad";
    }
}

TEST_P(Balance, ItsParallelCableIsAsLongAsItsRun) {
    const Assembly& a = shipped_joint(GetParam().profile).assembly;
    if (!a.drive.k_pe->cam.closed()) GTEST_SKIP() << "a helix: its cable leaves the plane";
    double angle = 0.0;
    const double run = 1e3 * length(a, "k_pe", pose(0.0, 0.0), angle);
    for (const Cable& cable : a.cables) {
        if (cable.kind != CableKind::kParallel || cable.side != GetParam().side) continue;
        const spring::BaseSpring& spring = a.drive.k_pe_spring;
        const double at_rest = 1e3 * (spring.free_length - spring.preload);
        EXPECT_NEAR(cable.length_mm, run + 4.0 + at_rest + 3.0, 1.0) << "with seat, spring and cap; the anchor hole takes 1 mm of floor";
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Balance, ::testing::ValuesIn([] {
                             std::vector<Case> all;
                             for (const char* profile : {"pnrvsa", "pnrvsa_co_design", "free_curve", "from_dead_band", "first_prototype",
                                                         "measured_table", "paper/new_cams"})
                                 for (const Side side : {Side::kAgonist, Side::kAntagonist}) all.push_back({profile, side});
                             return all;
                         }()),
                         [](const auto& one) {
                             std::string name = std::string(one.param.profile) + "_" + to_string(one.param.side);
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

}  // namespace
}  // namespace fusee::assembly
