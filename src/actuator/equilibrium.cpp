#include "fusee/actuator/equilibrium.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "fusee/core/error.h"
#include "fusee/spring/potential.h"
#include "settle.h"

// Equation numbers: docs/theory/equilibrium.md.

namespace fusee::actuator {

namespace {

constexpr const char* kSource = "docs/theory/equilibrium.md";
constexpr const char* kConvexity = "equilibrium.convexity";
constexpr std::array<const char*, 3> kBodies{"capstan 1", "capstan 2", "output"};

/// Stiffness below this share of the largest counts as 0: about fifty roundings of the largest.
constexpr double kNoStiffness = 1e-14;
/// A torque below this share of the largest is rounding.
constexpr double kNoTorque = 1e-12;
/// A suggested stiffness, as a share of the largest: any value above kNoStiffness suffices; this one is readable.
constexpr double kEnoughStiffness = 0.01;

/// How far inside the ends of a law a suggested resting place lies [rad].
double margin(core::Range domain) { return 1e-3 * std::min(domain.width(), 1.0); }

/// A spring between two hard stops, just inside its law.
class Stopped final : public spring::Potential {
public:
    Stopped(spring::PotentialPtr spring, double largest_torque)
        : spring_(std::move(spring)), inside_(spring_->domain()), stop_(10.0 * std::max(1.0, largest_torque) / margin(inside_)) {
        const double gap = margin(inside_);
        inside_ = {inside_.low + gap, inside_.high - gap};
    }
    [[nodiscard]] core::Range domain() const override { return spring_->domain(); }
    [[nodiscard]] double energy(double x) const override {
        const double end = nearest(x), beyond = x - end;
        return spring_->energy(end) + beyond * (spring_->force(end) + 0.5 * stop_ * beyond);
    }
    [[nodiscard]] double force(double x) const override { return spring_->force(nearest(x)) + stop_ * (x - nearest(x)); }
    [[nodiscard]] double stiffness(double x) const override { return inside_.holds(x) ? spring_->stiffness(x) : stop_; }
    [[nodiscard]] double slope(double x) const override { return inside_.holds(x) ? spring_->slope(x) : 0.0; }

private:
    [[nodiscard]] double nearest(double x) const { return std::clamp(x, inside_.low, inside_.high); }
    spring::PotentialPtr spring_;
    core::Range inside_;
    double stop_;  ///< [Nm/rad]
};

/// "equilibrium.free" if a motion at z has no stiffness; without suggestion.
core::Findings free_motion(const Joint& joint, const Eigen::Vector3d& z) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(free_stiffness(joint, z));
    const double least = modes.eigenvalues()[0], greatest = modes.eigenvalues()[2];
    if (least > kNoStiffness * greatest) return {};
    Eigen::Index body = 0;
    modes.eigenvectors().col(0).cwiseAbs().maxCoeff(&body);
    core::Finding f = core::error_finding("equilibrium.free", "no spring holds a motion of the joint", std::max(0.0, least),
                                          core::Bound::kAtLeast, kEnoughStiffness * greatest, "Nm/rad");
    f.where = fmt::format("mostly the {}", kBodies[static_cast<std::size_t>(body)]);
    f.suggestion = "a spring to the ground: not both a = 0 and b = 0 in the paper's figure 1";
    f.source = kSource;
    return {f};
}

/// The torques without the share of hard stops that hold the joint at the laws' ends; empty if the laws have no common interior.
std::string nearest_torques(const Joint& joint, const Eigen::Vector3d& torque, const Settled& settled) {
    Joint stopped = joint;
    for (JointSpring& spring : stopped.springs)
        spring.potential = std::make_shared<Stopped>(spring.potential, torque.lpNorm<Eigen::Infinity>());
    const Settled held = settle(stopped, torque, settled.ran_away ? Eigen::Vector3d::Zero() : settled.z);
    if (!held.at_rest() || !outside(joint, held.z).empty() || !free_motion(joint, held.z).empty()) return "";
    const Eigen::Vector3d torques = spring_torques(joint, held.z);
    const Eigen::Vector3d within = (torques.array().abs() < kNoTorque * torques.lpNorm<Eigen::Infinity>()).select(0.0, torques);
    return fmt::format("tau_1 = {:.8g} Nm, tau_2 = {:.8g} Nm, tau_q = {:.8g} Nm", within[kAgonist], within[kAntagonist], within[kOutput]);
}

/// "equilibrium.convexity" for each spring with negative stiffness at z.
core::Findings softening(const Joint& joint, const Eigen::Vector3d& z) {
    core::Findings findings;
    for (const JointSpring& spring : joint.springs) {
        const double x = deflection(spring, z), stiff = spring.potential->stiffness(x);
        if (!(stiff < 0.0)) continue;
        core::Finding f = core::error_finding(kConvexity, "a spring softens: the resting place is not unique", stiff, core::Bound::kAtLeast,
                                              0.0, "Nm/rad");
        f.where = fmt::format("{} at {:.4g} rad", spring.name, x);
        f.suggestion = fmt::format("a spring whose stiffness is higher by {:.4g} Nm/rad", -1.001 * stiff);
        f.source = kSource;
        findings.push_back(std::move(f));
    }
    return findings;
}

/// The search ended neither at rest nor far away, which continuous, rising torques exclude.
core::Findings unsettled(const Settled& settled) {
    core::Finding f = core::error_finding(kConvexity, "no resting place was found: the torque of some spring jumps or falls",
                                          settled.residual, core::Bound::kAtMost, 1e-9 * settled.scale, "Nm");
    f.suggestion = "springs whose torque rises at every deflection, without jumps";
    f.source = kSource;
    return {f};
}

/// "equilibrium.outside" for each spring that is outside its law at z.
core::Findings beyond_laws(const Joint& joint, const Eigen::Vector3d& z) {
    core::Findings findings;
    const std::vector<std::string> names = outside(joint, z);
    for (const JointSpring& spring : joint.springs) {
        if (std::find(names.begin(), names.end(), spring.name) == names.end()) continue;
        const double x = deflection(spring, z);
        const core::Range domain = spring.potential->domain();
        const bool below = x < domain.low;
        core::Finding f = core::error_finding(
            "equilibrium.outside", below ? "a spring goes slack or rests on its stop" : "a spring is wound beyond its law", x,
            below ? core::Bound::kAtLeast : core::Bound::kAtMost, below ? domain.low : domain.high, "rad");
        f.where = spring.name;
        f.source = kSource;
        findings.push_back(std::move(f));
    }
    return findings;
}

/// Findings if the place where the joint settled is not a resting place of its springs.
core::Findings refusals(const Joint& joint, const Settled& settled) {
    core::Findings findings = softening(joint, settled.z);
    if (findings.empty()) findings = free_motion(joint, settled.z);
    if (findings.empty()) findings = beyond_laws(joint, settled.z);
    return findings.empty() && !settled.at_rest() ? unsettled(settled) : findings;
}

/// The same with the nearest torques that the springs hold, where there can be any.
core::Findings suggesting(core::Findings findings, const Joint& joint, const Eigen::Vector3d& torque, const Settled& settled) {
    if (findings.empty() || findings.front().rule == kConvexity) return findings;
    const std::string torques = nearest_torques(joint, torque, settled);
    for (core::Finding& f : findings)
        if (!torques.empty()) f.suggestion = torques;
    return findings;
}

void require_finite(const char* field, const Eigen::Vector3d& values) {
    if (!values.allFinite())
        throw core::InvalidInput(field, fmt::format("({:g}, {:g}, {:g})", values[0], values[1], values[2]), "finite numbers");
}

Settled settled_from(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& start) {
    require_finite("torque", torque);
    require_finite("start", start);
    return settle(joint, torque, start);
}

}  // namespace

core::Outcome<Equilibrium> find_equilibrium(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& start) {
    const Settled settled = settled_from(joint, torque, start);
    if (core::Findings refusal = refusals(joint, settled); !refusal.empty()) return suggesting(std::move(refusal), joint, torque, settled);
    return Equilibrium{settled.z, settled.residual, settled.steps};
}

std::optional<Equilibrium> equilibrium(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& start) {
    const Settled settled = settled_from(joint, torque, start);
    if (!refusals(joint, settled).empty()) return {};
    return Equilibrium{settled.z, settled.residual, settled.steps};
}

core::Outcome<Eigen::Matrix3d> sensitivity(const Joint& joint, const Eigen::Vector3d& z) {
    if (core::Findings refusal = free_motion(joint, z); !refusal.empty()) return refusal;
    Eigen::Matrix3d inverse = free_stiffness(joint, z).inverse();
    for (int body = 0; body < 3; ++body)
        if (joint.frozen[static_cast<std::size_t>(body)]) inverse(body, body) = 0.0;
    return inverse;
}

Eigen::Matrix3d cable_space(const Eigen::Matrix3d& sensitivity, const Joint& joint) {
    const Eigen::Vector3d radii(joint.capstan_radius, joint.capstan_radius, joint.joint_radius);
    return radii.asDiagonal() * sensitivity * radii.asDiagonal();
}

}  // namespace fusee::actuator
