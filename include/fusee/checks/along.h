#pragma once
#include <span>

#include "fusee/cam/cam.h"

/// Rules whose value is known at each working position of a cam with a cable: the rule judges the worst one.
namespace fusee::checks {

/// D/d at a contact, D = 2 rho - d.
[[nodiscard]] double bend_ratio(const cam::Contact& contact, double cable_diameter);
/// Bearing pressure 2T/(D d) on the groove's floor [Pa]; 0 where there is no floor, 2 rho <= d: cable.bend_ratio reports it.
[[nodiscard]] double floor_pressure(const cam::Contact& contact, double cable_diameter);

/// The measured value of a rule at one contact, in the unit of its findings.
struct AlongCam {
    const char* rule;
    double (*value)(const cam::Cam& cam, const cam::Contact& contact);  ///< @param contact one of cam.working
};
/// All of them; a rule that is not listed has one value for the whole part.
[[nodiscard]] std::span<const AlongCam> along_cam();

}  // namespace fusee::checks
