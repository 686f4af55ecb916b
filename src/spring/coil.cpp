#include "fusee/spring/coil.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/core/units.h"

// Equation numbers: docs/theory/coils.md.
namespace fusee::spring {

namespace {

constexpr double kDeadCoils = 2.0;  // ground ends: one inactive coil each
constexpr double kSteel = 7850.0;   // density of the wire [kg/m^3]
constexpr double kTorsionShare = 0.7, kCompressionShare = 0.8;

bool is_torsion(const BaseSpring& s) { return s.kind == BaseKind::kTorsion; }

/// q = (w + 0.07)/(w - 0.75): stress at the inside of a bend of index w over that of a straight wire. @pre w > 0.75
double bend_factor(double index) { return (index + 0.07) / (index - 0.75); }

/// Wahl: (4w - 1)/(4w - 4) + 0.615/w.
double shear_factor(double index) { return (4.0 * index - 1.0) / (4.0 * index - 4.0) + 0.615 / index; }

double section_modulus(double wire) { return core::kPi * std::pow(wire, 3) / 32.0; }

/// Rm = base - slope lg(d/mm) [MPa]
struct StrengthLine {
    double base, slope;
};
constexpr std::array kLines = {StrengthLine{0.0, 0.0},      StrengthLine{1720.0, 660.0}, StrengthLine{1980.0, 740.0},
                               StrengthLine{2220.0, 820.0}, StrengthLine{1980.0, 740.0}, StrengthLine{2220.0, 820.0}};

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

bool coil_known(const BaseSpring& s) { return s.wire_diameter > 0.0 && s.coil_diameter > s.wire_diameter; }
double spring_index(const BaseSpring& s) { return s.coil_diameter / s.wire_diameter; }

double rate_of_coils(const BaseSpring& s) {
    const double d4 = std::pow(s.wire_diameter, 4), n = s.active_coils;
    return is_torsion(s) ? s.youngs_modulus * d4 / (64.0 * s.coil_diameter * n)
                         : s.shear_modulus * d4 / (8.0 * std::pow(s.coil_diameter, 3) * n);
}

double turns_for_rate(const BaseSpring& s) {
    BaseSpring one = s;
    one.active_coils = 1.0;
    return rate_of_coils(one) / s.rate;
}
double wire_for_rate(const BaseSpring& s) { return s.wire_diameter * std::pow(s.rate / rate_of_coils(s), 0.25); }

double wire_stress(const BaseSpring& s, double load) {
    const double w = spring_index(s);
    if (is_torsion(s)) return load * bend_factor(w) / section_modulus(s.wire_diameter);
    return 8.0 * load * s.coil_diameter * shear_factor(w) / (core::kPi * std::pow(s.wire_diameter, 3));
}

double bend_stress(const BaseSpring& s, double moment, double bend_radius) {
    return moment * bend_factor(2.0 * bend_radius / s.wire_diameter + 1.0) / section_modulus(s.wire_diameter);
}

double strength_of(WireClass wire_class, double wire_diameter) {
    if (wire_class == WireClass::kUnknown || wire_diameter <= 0.0) return 0.0;
    const StrengthLine& line = kLines[static_cast<std::size_t>(wire_class)];
    return (line.base - line.slope * std::log10(core::mm_from_m(wire_diameter))) * 1e6;
}
double tensile_strength(const BaseSpring& s) {
    return s.tensile_strength > 0.0 ? s.tensile_strength : strength_of(s.wire_class, s.wire_diameter);
}
double allowed_share(const BaseSpring& s) {
    const double share = s.stress_share > 0.0 ? s.stress_share : is_torsion(s) ? kTorsionShare : kCompressionShare;
    return is_torsion(s) ? share : share / std::sqrt(3.0);
}

std::optional<double> travel_to_solid(const BaseSpring& s) {
    if (s.free_length <= 0.0 || s.active_coils <= 0.0 || s.wire_diameter <= 0.0) return std::nullopt;
    return s.free_length - (s.active_coils + kDeadCoils) * s.wire_diameter;
}

double inside_diameter(const BaseSpring& s, double state) {
    if (!is_torsion(s)) return s.coil_diameter - s.wire_diameter;
    const double turns = state / (2.0 * core::kPi);  // the wire keeps its length: more turns mean smaller coils
    return s.coil_diameter * s.active_coils / (s.active_coils + turns) - s.wire_diameter;
}

double wound_length(const BaseSpring& s, double state) { return s.wire_diameter * (s.active_coils + 1.0 + state / (2.0 * core::kPi)); }

bool is_dynamic(const BaseSpring& s) { return s.cycles >= 1e4; }

double least_gaps(const BaseSpring& s) {
    const double wire = core::mm_from_m(s.wire_diameter), coil = core::mm_from_m(s.coil_diameter);
    return (is_dynamic(s) ? 1.5 : 1.0) * core::m_from_mm(s.active_coils * (0.0015 * coil * coil / wire + 0.1 * wire));
}

double leg_turn(const BaseSpring& s, double state) { return 2.0 * core::kPi * s.active_coils + state; }

double wire_length(const BaseSpring& s) { return core::kPi * s.coil_diameter * (s.active_coils + (is_torsion(s) ? 0.0 : kDeadCoils)); }

double wire_mass(const BaseSpring& s, double length) { return kSteel * 0.25 * core::kPi * s.wire_diameter * s.wire_diameter * length; }

double surge_frequency(const BaseSpring& s) {
    const double mass = wire_mass(s, core::kPi * s.coil_diameter * s.active_coils);
    const double inertia = is_torsion(s) ? 0.25 * mass * s.coil_diameter * s.coil_diameter : mass;
    return 0.5 * std::sqrt(rate_of_coils(s) / inertia);
}

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
