#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/provenance.h"
#include "fusee/pipeline/rig.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

namespace {

std::vector<std::string> left_out(const ResolvedDesign& design) {
    std::vector<std::string> sentences{"errors of built parts: springs and radii are those of the design"};
    if (design.profile.dynamics.motor_noise > 0.0 || design.profile.dynamics.joint_noise > 0.0)
        sentences.emplace_back("torque noise of [dynamics]: add it to the commands");
    if (!stretch_sides(design).empty()) sentences.emplace_back("stretch of the cables under load");
    if (!wrap_sides(design).empty()) sentences.emplace_back("friction of the cables on their cams");
    return sentences;
}

}  // namespace

mjcf::Twin twin_of(const ResolvedDesign& design) {
    const profile::Profile& profile = design.profile;
    require_joint(profile, "a model for MuJoCo");
    if (profile.rig.arrangement != actuator::Arrangement::kPnrvsa)
        throw core::InvalidInput(profile.place_of("rig.arrangement"), actuator::to_string(profile.rig.arrangement),
                                 fmt::format("{} for a model for MuJoCo", actuator::to_string(actuator::Arrangement::kPnrvsa)));
    const actuator::NoiseOptions& dynamics = profile.dynamics;
    mjcf::Twin twin = mjcf::twin_of(joint_of(design), {.motor_inertia = dynamics.motor_inertia,
                                                       .joint_inertia = dynamics.joint_inertia,
                                                       .motor_viscous = dynamics.motor_viscous,
                                                       .joint_viscous = dynamics.joint_viscous,
                                                       .reference_torque = profile.rig.peak_torque});
    twin.name = profile.name;
    twin.source = core::Provenance{profile.name, profile.sha256, ""}.line();
    twin.not_expressed = left_out(design);
    return twin;
}

}  // namespace fusee::pipeline
