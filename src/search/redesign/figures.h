#pragma once
#include <array>
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"
#include "fusee/joint_model/built_rig.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"

/// Which figures of a profile a diagnosis changes, and by how much.
namespace fusee::search::redesign {

/// A figure of a profile that effects on a rig can change.
struct Figure {
    enum class Of { kGear, kSpring, kJoint };
    std::string key;        ///< of the profile
    std::string build;      ///< name in Diagnosis::build without its side; "" none
    Of of = Of::kJoint;     ///< kSpring: each side cuts its own; else both sides share the profile's
    bool relative = false;  ///< the departure multiplies, else it is added
    bool cut = true;        ///< cams can compensate it
    double (*value)(const joint_model::BuiltRig& rig, int side) = {};  ///< of a rig as built
};
[[nodiscard]] const std::vector<Figure>& figures();

/// Departure of a rig's figure from the nominal one: SI, or relative.
struct Departure {
    std::array<double, 2> on_side{};  ///< agonist, antagonist
    std::string why;                  ///< the effects that cause it; empty: none
    [[nodiscard]] bool any() const { return !why.empty(); }
};

/// Deflection of the springs of a case at which the profile's springs rest on their stops [rad]: a case's springs have no stops
/// (docs/gap.md, eq. 5).
/// @pre require_same_rig
[[nodiscard]] double rest_deflection(const pipeline::ResolvedDesign& design, const gap_case::Case& gap_case);

/// Departures by the effects of a diagnosis, in the order of `figures()`. A build parameter of the same figure is added: the mean of both
/// sides if the effects are equal on both. In a case, a longer arm of K_PE has already pressed its spring by dr L where the profile's
/// deflections begin: that is added to the preload.
/// @param rest_deflection L [rad]
[[nodiscard]] std::vector<Departure> departures(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found, double rest_deflection);
/// The effects that no cam can compensate, and the advice for them.
[[nodiscard]] std::vector<effects::Cause> not_mended(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found);
[[nodiscard]] std::string instead_of_cams(const std::string& effect_id);

/// The figure measured on a side of the rig [SI].
[[nodiscard]] double as_built(const profile::Profile& profile, const Figure& figure, double departure);

}  // namespace fusee::search::redesign
