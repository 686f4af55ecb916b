#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/spring/coil.h"

namespace fusee::spring {

namespace {

using core::m_from_mm;
using core::mm_from_m;

constexpr double kLengthStep_mm = 0.5;
constexpr double kTravelShare = 0.8, kMostTravel = 0.85;  // of the travel to solid: the limits of rule spring.travel
constexpr double kSoft = 1.0 / 0.9;                       // for a rate that is 10 % low: rule spring.rate_scatter

double up_to_step(double value) { return kLengthStep_mm * std::ceil(value / kLengthStep_mm - 1e-9); }

double free_length(const BaseSpring& s, double state) {
    const double travel = std::max({state / kTravelShare, state + least_gaps(s), state * kSoft / kMostTravel});
    return m_from_mm(up_to_step(mm_from_m((s.active_coils + 2.0) * s.wire_diameter + travel)));
}

void state_if_not(double& stated, double value) {
    if (stated <= 0.0) stated = value;
}

}  // namespace

void derive_coils(BaseSpring& s) {
    if (!coil_known(s)) return;
    if (s.active_coils <= 0.0 && s.rate > 0.0) s.active_coils = turns_for_rate(s);
    if (s.rate <= 0.0 && s.active_coils > 0.0) s.rate = rate_of_coils(s);
}

double axial_space(const BaseSpring& s, double state) { return m_from_mm(up_to_step(mm_from_m(wound_length(s, state)) + kLengthStep_mm)); }

void derive_length_and_rating(BaseSpring& s, double state) {
    if (!coil_known(s) || s.active_coils <= 0.0) return;
    const bool torsion = s.kind == BaseKind::kTorsion;
    state_if_not(s.free_length, torsion ? axial_space(s, state) : free_length(s, state));
    if (tensile_strength(s) <= 0.0) return;
    const double bears = allowed_share(s) * tensile_strength(s) / wire_stress(s, 1.0);
    if (torsion) {
        state_if_not(s.max_load, bears);
        state_if_not(s.max_state, bears / s.rate);
    } else {
        state_if_not(s.max_state, std::min(kMostTravel * *travel_to_solid(s), bears / s.rate));
        state_if_not(s.max_load, s.rate * s.max_state);
    }
}

}  // namespace fusee::spring
