#pragma once
#include <map>

#include "fusee/assembly/motion.h"
#include "fusee/assembly/rule.h"
#include "fusee/pipeline/make.h"
#include "fusee/profile/profile.h"
#include "pipeline/fixture.h"

namespace fusee::assembly {

struct Joint {
    Assembly assembly;
    spring::SpringLawPtr law;
};

/// A shipped profile, or "init": what `fusee init mine.toml --yes` writes (tests/search/init/find_test.cpp).
inline std::filesystem::path joint_file(const std::string& name) {
    return name == "init" ? std::filesystem::path(FUSEE_SOURCE_DIR) / "tests/assembly/init.toml" : fixtures::shipped(name);
}

/// The joint of such a profile; each is made once in a process.
inline const Joint& shipped_joint(const std::string& name) {
    static std::map<std::string, Joint> made;
    if (const auto known = made.find(name); known != made.end()) return known->second;
    const auto design = pipeline::make_figures(profile::read_profile(joint_file(name)));
    const auto& profile = design->resolved.profile;
    const auto& parts = design->report.parts;
    Assembly assembly = assemble({parts[0].part, parts[1].part, profile.k_se.spring, profile.k_pe.spring, profile.cable},
                                 profile.rig.capstan_radius, profile.rig.joint_radius, {})
                            .value();
    return made.emplace(name, Joint{std::move(assembly), design->resolved.law()}).first->second;
}

/// What one rule alone finds.
inline core::Findings judged_by(const std::string& id, const Assembly& a) {
    for (const Rule& rule : rules())
        if (rule.id == id) return rule.measure(a, checks::Allowed(rule, {}));
    return {};
}

}  // namespace fusee::assembly
