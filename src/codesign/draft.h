#pragma once
#include <string>
#include <vector>

#include "fusee/profile/profile.h"

namespace fusee::codesign {

/// A candidate while the searched numbers are put in, one after the other.
struct Draft {
    profile::Profile profile;
    double start = 0.0, end = 0.0;                        ///< of the law [Nm]
    double k = 0.0, transmission = 0.0, share_u = 0.0;    ///< (k, u, C): T at the start, and the part of it that u makes
    std::vector<double> series_stiffness, transmissions;  ///< of the free curve's knots
};

/// `value` with 6 digits in a unit of which one is `unit` in SI, as a profile would write it.
[[nodiscard]] double rounded(double value, double numerator = 1.0, double denominator = 1.0);

/// The profile with its law.
[[nodiscard]] profile::Profile finished(Draft draft);

/// A profile under a longer name, which stays one that a profile may have.
[[nodiscard]] profile::Profile renamed(profile::Profile profile, const std::string& ending);

/// The law of a candidate, lead-in included. Refusals of its makers.
[[nodiscard]] core::Outcome<spring::SpringLawPtr> law_of(const profile::Profile& profile);

}  // namespace fusee::codesign
