#include "draft.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "fusee/profile/edit.h"

namespace fusee::search::codesign {

double rounded(double value, double numerator, double denominator) {
    // Multiplied and divided as the profile's reader does, so that the written text gives the same bits.
    return std::strtod(fmt::format("{:.6g}", value * denominator / numerator).c_str(), nullptr) * numerator / denominator;
}

profile::Profile finished(Draft draft) {
    profile::Profile p = std::move(draft.profile);
    p.law.start_torque = rounded(draft.start);
    p.law.end_torque = rounded(draft.end);
    if (draft.series_stiffness.empty()) {
        spring::StictionLawOptions law;
        law.mu = p.rig.rest_friction();
        law.start_torque = p.law.start_torque;
        law.end_torque = p.law.end_torque;
        // T(start) = u^2/(mu start^2) + C/start
        law.k = rounded(draft.k);
        law.u = rounded(std::sqrt(law.mu * draft.share_u * draft.transmission) * law.start_torque);
        law.c = rounded((1.0 - draft.share_u) * draft.transmission * law.start_torque);
        p.law.curves = law;
        return p;
    }
    spring::FreeCurveOptions law;
    const std::size_t knots = draft.series_stiffness.size();
    for (std::size_t i = 0; i < knots; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(knots - 1);
        law.loads.push_back(rounded(draft.start * std::pow(draft.end / draft.start, share)));
        law.series_stiffness.push_back(rounded(draft.series_stiffness[i]));
        law.transmission.push_back(rounded(draft.transmissions[i]));
    }
    p.law.curves = std::move(law);
    return p;
}

profile::Profile renamed(profile::Profile profile, const std::string& ending) {
    profile.name = profile::derived_name(profile.name, ending);
    return profile;
}

}  // namespace fusee::search::codesign
