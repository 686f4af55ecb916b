#pragma once
#include <string>
#include <vector>

#include "fusee/profile/profile.h"

namespace fusee::search::codesign {

/// A candidate while the searched numbers are entered.
struct Draft {
    profile::Profile profile;
    double start = 0.0, end = 0.0;                        ///< of the law [Nm]
    double k = 0.0, transmission = 0.0, share_u = 0.0;    ///< (k, u, C): T at the start, and the share of u in it
    std::vector<double> series_stiffness, transmissions;  ///< of the free curve's knots
};

/// `value` [SI] with 6 digits in the profile's unit, numerator/denominator SI, as the profile's reader gives it back.
[[nodiscard]] double rounded(double value, double numerator = 1.0, double denominator = 1.0);

/// The profile with its law.
[[nodiscard]] profile::Profile finished(Draft draft);

/// The profile with `ending` added to its name, which stays a valid name.
[[nodiscard]] profile::Profile renamed(profile::Profile profile, const std::string& ending);

}  // namespace fusee::search::codesign
