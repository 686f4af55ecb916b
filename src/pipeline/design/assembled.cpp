#include "fusee/pipeline/assembled.h"

#include "fusee/assembly/rule.h"

namespace fusee::pipeline {

Assembled assemble(const ResolvedDesign& design, std::shared_ptr<const solid::Part> k_se, std::shared_ptr<const solid::Part> k_pe) {
    const profile::Profile& profile = design.profile;
    auto made =
        assembly::assemble({std::move(k_se), std::move(k_pe), profile.k_se.spring, profile.k_pe.spring, profile.cable, profile.process},
                           profile.rig.capstan_radius, profile.rig.joint_radius, profile.assembly);
    if (!made) return {nullptr, made.refusal()};
    const auto joint = std::make_shared<const assembly::Assembly>(std::move(made).value());
    return {joint, assembly::check(*joint, profile.limits)};
}

}  // namespace fusee::pipeline
