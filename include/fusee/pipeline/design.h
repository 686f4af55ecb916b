#pragma once
#include <cstddef>
#include <vector>

#include "fusee/actuator/joint.h"
#include "fusee/cam/arm.h"
#include "fusee/core/finding.h"
#include "fusee/design/robust.h"
#include "fusee/profile/profile.h"
#include "fusee/solid/part.h"
#include "fusee/spring/friction.h"
#include "fusee/spring/law.h"

namespace fusee::pipeline {

/// The law that `profile.law` describes, without its lead-in. Refusal and @throws: those of its maker in module spring; a formula's mistake
/// names its key.
[[nodiscard]] core::Outcome<spring::SpringLawPtr> spring_law(const profile::Profile& profile);

/// The friction of both gears that a profile asks for. @throws core::InvalidInput naming the row of its table
[[nodiscard]] spring::FrictionLaw gear_friction(const profile::Profile& profile);

/// The joint that the law drives. @throws core::InvalidInput naming the member
[[nodiscard]] actuator::Actuator actuator_of(const profile::Profile& profile, const spring::SpringLawPtr& law);
/// The spring as its cam pulls it: K_PE's in series with its cable; K_SE's cable is on the other side of its spool.
[[nodiscard]] spring::BaseSpring pulled_spring(const profile::PartSpec& spec);

/// Smoothed minus measured torques of one curve.
struct Misfit {
    double rms = 0.0;      ///< [Nm]
    double largest = 0.0;  ///< of the largest magnitude [Nm]
    double median = 0.0;   ///< of the magnitudes [Nm]
    std::size_t row = 0;   ///< of the largest: by rising angle, the first is 1
};
/// @param differences of the rows, by rising angle [Nm]; not empty
[[nodiscard]] Misfit misfit_of(const std::vector<double>& differences);

/// A profile and what follows from it: springs and joint. Computed once for each profile and handed down as const.
struct ResolvedDesign {
    profile::Profile profile;
    actuator::Actuator actuator;            ///< its law is the spring law, lead-in included; of a single spring no figure of a rig
    core::Range design_loads;               ///< of the law without the lead-in [Nm]
    core::Findings findings;                ///< passes and warnings: coverage of the loads that stiction allows
    std::vector<ResolvedDesign> ways = {};  ///< of two cables: the design of each alone, first of the one that pulls forth; else none

    [[nodiscard]] const spring::SpringLawPtr& law() const { return actuator.law; }
    [[nodiscard]] const profile::PartSpec& spec(cam::PartKind kind) const { return profile.part(kind); }
    [[nodiscard]] cam::ArmFunction arm(cam::PartKind kind) const;
    /// The joint and the springs that its cams pull: the drawing from which a shop's scatter is computed.
    [[nodiscard]] design::DrawnJoint drawn_joint() const;
};
/// One part that a design asks for.
struct AskedPart {
    const ResolvedDesign* design;  ///< its own: of two cables that of its way
    cam::PartKind kind;
};
/// The parts of a design in the order of its results. @param design must outlive them
[[nodiscard]] std::vector<AskedPart> parts_of(const ResolvedDesign& design);

/// Refusals: findings of the law's maker, of its lead-in or of `spring::check_law`; of a single spring "law.energy".
[[nodiscard]] core::Outcome<ResolvedDesign> resolve(profile::Profile profile);
/// The same for a search that judges many: without the findings on coverage, which it measures itself, and without `spring::check_law`: the
/// law's maker has judged its stiffnesses, and no cam has an arm where a spring would push.
[[nodiscard]] core::Outcome<ResolvedDesign> resolve_for_search(profile::Profile profile);
/// How often `resolve` was called in this process.
[[nodiscard]] std::size_t resolve_count();

/// Requires both springs and their rig, for `what`: "a simulation". @throws core::InvalidInput naming kind
void require_joint(const profile::Profile& profile, const char* what);
/// Requires a part that has its spring alone, for `what`: "springs for a cam". @throws core::InvalidInput naming cam.family
void require_one_cable(const profile::Profile& profile, const char* what);
/// Requires all figures that parts need (a simulation needs fewer), and a kerf that leaves a bore.
/// @throws core::InvalidInput naming the first key that is missing or inconsistent with another
void require_parts(const profile::Profile& profile);
/// Requires a printed part if it is to be sliced. @throws core::InvalidInput naming outputs.formats
void require_sliceable(const profile::Profile& profile);

/// Arm and cam, its anchor placed, without a body. Refusal: the cam's. @pre require_parts(profile)
[[nodiscard]] core::Outcome<cam::Cam> design_cam(cam::PartKind kind, const ResolvedDesign& design);

/// One cam as a solid, with the findings of every rule.
struct DesignedPart {
    solid::Part part;
    core::Findings findings;
};
/// Arm, cam, solid, rules. Refusal: the findings, if one is an error; for a helix that meets itself the suggestion is the least pitch that
/// makes a solid, found by making it.
/// @pre require_parts(profile)
[[nodiscard]] core::Outcome<DesignedPart> design_part(cam::PartKind kind, const ResolvedDesign& design);
}  // namespace fusee::pipeline
