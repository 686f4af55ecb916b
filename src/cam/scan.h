#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/math/roots.h"

/// Contacts over the loads of a law.
namespace fusee::cam {

/// `count` contacts, evenly spaced in load.
[[nodiscard]] std::vector<Contact> scan_contacts(const ArmFunction& arm, const CamOptions& options, std::size_t count);

/// The contact at a cam angle, between those of a scan. @pre angle within the scan's (clamped)
[[nodiscard]] Contact contact_at(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& scanned, double angle);

/// Angle between the free cable and the contact's plane, above 0 upwards [rad]; 0 for a parallel exit. @pre contact.path.z is known
[[nodiscard]] double fleet_of(const Contact& contact, const Guide& guide);

/// The arms in the plane with which a cable at its fleet angle has the torque of `arm`: arm/cos(fleet) (docs/theory/cams.md, eq. 8a); none
/// if all fleet angles are 0. @param contacts scanned from `arm`, sound
[[nodiscard]] std::optional<ArmFunction> in_plane(const ArmFunction& arm, const CamOptions& options, std::vector<Contact> contacts);

/// The root of a monotone f between two samples; if rounding removes the change of sign, the end with the smaller value.
template <class F>
double solve_between(const F& f, double low, double high) {
    if (const auto root = math::bracketed_root(f, low, high)) return *root;
    return std::abs(f(low)) <= std::abs(f(high)) ? low : high;
}

}  // namespace fusee::cam
