#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/check.h"
#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/spring/coil.h"
#include "measure.h"
#include "shape.h"
#include "spring_form.h"

// The one header that a rule's file includes: beside it, optional values of the profile that rules need, and the designs to which these
// rules apply.
namespace fusee::checks {

inline bool is_torsion(const Design& d) { return d.spring.kind == spring::BaseKind::kTorsion; }
inline bool is_compression(const Design& d) { return d.spring.kind == spring::BaseKind::kCompression; }
inline bool is_milled(const Design& d) { return is_milled(d.process); }
inline bool is_stacked(const Design& d) { return is_stacked(d.process); }
/// Is the base spring between the pins of a roller's arm?
inline bool is_on_arm(const Design& d) {
    const cam::CamOptions& o = d.part.cam.options;
    return o.family == cam::Family::kRoller && o.roller.follower == cam::FollowerKind::kArm;
}
inline bool works(const Design& d) { return !d.part.cam.working.empty(); }
/// The axle that goes through a spool, with its torsion spring around it [m]; 0: that of an overhung spool ends below the spring.
inline double through_axle(const Design& d) {
    const solid::HubOptions& hub = d.part.options.hub;
    return is_torsion(d) && hub.kind == solid::HubKind::kThrough ? hub.bore_diameter : 0.0;
}
/// Diameter of what stands inside the coils [m]: as stated, else that axle; 0: not known.
inline double inner_rod(const Design& d) { return d.spring.rod_diameter > 0.0 ? d.spring.rod_diameter : through_axle(d); }
inline bool has_leg_slot(const Design& d) { return has_slot(d.part.options.features); }
inline bool has_torsion_leg_slot(const Design& d) { return is_torsion(d) && has_leg_slot(d); }
inline bool has_torsion_anchor(const Design& d) {
    return is_torsion(d) && anchor_hole(d.part).has_value() && !solid::anchor_leads_down(d.part.cam, d.part.options);
}

namespace need {

/// Is a number of the base spring stated? 0 means that it is not.
template <auto Number>
bool of_spring(const Design& d) {
    return d.spring.*Number > 0.0;
}

inline constexpr Need kWire{"spring.wire_mm", of_spring<&spring::BaseSpring::wire_diameter>};
inline constexpr Need kCoil{"spring.coil_mm", of_spring<&spring::BaseSpring::coil_diameter>};
inline constexpr Need kActiveCoils{"spring.active_coils", of_spring<&spring::BaseSpring::active_coils>};
inline constexpr Need kFreeLength{"spring.free_length_mm", of_spring<&spring::BaseSpring::free_length>};
inline constexpr Need kStrength{"spring.tensile_strength_MPa",
                                [](const Design& d) { return spring::tensile_strength(d.spring) > 0.0; },
                                nullptr,
                                {"spring.wire_class"}};
inline constexpr Need kRod{"spring.rod_mm", [](const Design& d) { return inner_rod(d) > 0.0; }};
inline constexpr Need kCycles{"spring.cycles", of_spring<&spring::BaseSpring::cycles>};
inline constexpr Need kHand{"spring.hand", [](const Design& d) { return d.spring.hand != spring::Hand::kUnknown; }};
inline constexpr Need kContactModulus{"roller.contact_modulus_MPa",
                                      [](const Design& d) { return d.part.cam.options.roller.contact_modulus > 0.0; }};

/// Active coils. Only the inside diameter of a torsion spring depends on them.
inline constexpr Need kWoundCoils{"spring.active_coils", [](const Design& d) { return is_compression(d) || d.spring.active_coils > 0.0; }};
/// Travel to solid length, stated by the maker or computed from the coils.
inline constexpr Need kTravel{"spring.max_travel_mm",
                              [](const Design& d) { return d.spring.max_state > 0.0 || spring::travel_to_solid(d.spring).has_value(); },
                              "rated_required",
                              {"spring.free_length_mm", "spring.active_coils", "spring.wire_mm"}};

// Limits that the profile states: by their own key, or as an override of the rule's limit.
inline constexpr Need kMaxAngle{"spring.max_angle_rad", of_spring<&spring::BaseSpring::max_state>, "required"};
inline constexpr Need kAxialSpace{"spring.free_length_mm", of_spring<&spring::BaseSpring::free_length>, "required"};
inline constexpr Need kMaxTorque{"spring.max_torque_Nm", [](const Design& d) { return !is_torsion(d) || d.spring.max_load > 0.0; },
                                 "torque_required"};
inline constexpr Need kMaxForce{"spring.max_force_N", [](const Design& d) { return is_torsion(d) || d.spring.max_load > 0.0; },
                                "force_required"};
inline constexpr Need kScatterAngle{"spring.max_angle_rad", [](const Design& d) { return !is_torsion(d) || d.spring.max_state > 0.0; },
                                    "angle_review"};
inline constexpr Need kScatterTravel{"spring.max_travel_mm", [](const Design& d) { return is_torsion(d) || d.spring.max_state > 0.0; },
                                     "travel_review"};
inline constexpr Need kRollerPressure{"roller.max_pressure_MPa",
                                      [](const Design& d) { return d.part.cam.options.roller.max_pressure > 0.0; }, "required"};

}  // namespace need

}  // namespace fusee::checks
