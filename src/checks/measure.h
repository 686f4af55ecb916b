#pragma once
#include <initializer_list>
#include <string>

#include "fusee/checks/check.h"
#include "fusee/checks/judge.h"
#include "fusee/core/change.h"
#include "fusee/core/units.h"

namespace fusee::checks {

using core::change, core::number, core::quoted;
using core::deg_from_rad, core::m_from_mm, core::mm_from_m, core::rad_from_deg;

inline constexpr double kPaPerMPa = 1e6;

/// The rule for parts of a cable only, in a group that has rules for rollers too.
Rule on_cable(Rule rule);

/// "k_pe"
std::string name(const Design& design);
/// "k_pe.hub.bore_mm" for "hub.bore_mm"
std::string key_of(const Design& design, const std::string& key);
/// The suggestion of another value for a key of the part: change(design, "hub.bore_mm", down(5.2)).
core::Suggestion change(const Design& design, const std::string& key, std::string value);
/// The anchor hole left out, and the cable's end held outside the part.
core::Suggestion without_anchor_hole(const Design& design);
/// "k_pe at psi 12.0 deg"
std::string where(const Design& design, double psi);
std::string at_anchor(const Design& design);
std::string at_leg_slot(const Design& design);
std::string along_groove(const Design& design);  ///< "k_pe all along the groove"
/// @param offset from the cable's centreline along n [m]; -d/2 is the groove's floor
core::Place place(const cam::PathPoint& point, double offset);
/// States a point of the path as the finding's place, in words and as a point. @param offset as for `place`
void locate(core::Finding& finding, const Design& design, const cam::PathPoint& point, double offset = 0.0);

/// A bend of the cable against cable.min_bend_ratio if the profile states it, else against the construction's figures (table 1), "required"
/// and "review"; with their source. @param ratio D/d
core::Finding judge_bend(double ratio, const Design& design, const Allowed& allowed);
/// Depth of the slenderest hole in its diameters; the change is a wider one.
core::Finding judge_slenderest_hole(const Design& design, std::initializer_list<EffectiveLimit> limits);

/// The cable's breaking load: as the profile states it, else estimated by construction and diameter.
struct BreakingLoad {
    double newton = 0.0;
    bool estimated = false;
    /// "", or a remark for a finding that the load is an estimate.
    [[nodiscard]] std::string remark(const Cable& cable) const;
};
BreakingLoad breaking_load(const Cable& cable);

}  // namespace fusee::checks
