#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/gap_case/reference.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/rig.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

namespace {

constexpr int kLeastRows = 8;
constexpr int kRowsBelowStop = 120;

/// One spring below its stop; the symbols of case_template.h.
struct Toe {
    double rate = 0.0, preload = 0.0;  ///< k, z_0
    double end_slope = 0.0;            ///< s

    /// L of a constant arm.
    [[nodiscard]] double shortest() const { return preload / end_slope; }
    /// @pre length >= shortest()
    [[nodiscard]] double torque(double x, double length) const {
        const double mean = preload / length, first = mean * mean / end_slope, power = end_slope / mean;
        const double bend = (end_slope - first) * std::pow(x / length, power);
        return rate * (first + bend / (power + 1.0)) * x * (first + bend);
    }
};

Toe toe_of(const char* key, double force, const spring::BaseSpring& base) {
    if (base.preload <= 0.0)
        throw core::InvalidInput(key, fmt::format("{:g}", base.preload),
                                 "above 0: a cam that starts at a torque has a preloaded base spring");
    return {base.rate, base.preload, force / (base.rate * base.preload)};
}

double proportional_friction(const profile::Profile& profile) {
    const profile::Rig& rig = profile.rig;
    const auto refuse = [&profile](const char* key) {
        throw core::InvalidInput(profile.place_of(key), "given",
                                 "friction in proportion to the load: the nominal gear of a case knows no other");
    };
    if (!rig.gear_friction_table.file.empty()) refuse("rig.gear_friction_table");
    if (rig.gear_friction_constant > 0.0) refuse("rig.gear_friction_constant_Nm");
    return rig.rest_friction();
}

}  // namespace

SpringsWithoutStops springs_without_stops(const spring::SpringLaw& law, const spring::BaseSpring& series,
                                          const spring::BaseSpring& parallel, int rows) {
    if (rows < kLeastRows) throw core::InvalidInput("springs_rows", fmt::format("{}", rows), fmt::format("at least {}", kLeastRows));
    const spring::LawPoint start = law.at_angle(0.0);
    const Toe se = toe_of("k_se.spring.preload_rad", start.f_se, series);
    const Toe pe = toe_of("k_pe.spring.preload_mm", start.f_pe, parallel);
    SpringsWithoutStops all;
    all.rest_deflection = std::max(se.shortest(), pe.shortest());
    for (int i = 0; i < kRowsBelowStop; ++i) {
        const double x = all.rest_deflection * i / kRowsBelowStop;
        all.rows.push_back({x, se.torque(x, all.rest_deflection), pe.torque(x, all.rest_deflection)});
    }
    const double travel = law.angles().high;
    for (int i = 0; i < rows; ++i) {
        const spring::LawPoint point = law.at_angle(travel * i / (rows - 1));
        all.rows.push_back({all.rest_deflection + point.theta, point.f_se, point.f_pe});
    }
    return all;
}

core::Outcome<gap_case::CaseTemplate> case_template(const profile::Profile& profile, const CaseTemplateOptions& options) {
    require_joint(profile, "a case of it");
    require_parts(profile);
    const auto design = resolve(profile);
    if (!design) return design.refusal();
    SpringsWithoutStops springs = springs_without_stops(*design->law(), profile.k_se.spring, profile.k_pe.spring, options.springs_rows);
    gap_case::CaseTemplate made;
    made.name = profile.name;
    made.rig = {.capstan_radius = profile.rig.capstan_radius,
                .joint_radius = profile.rig.joint_radius,
                .gear_load_friction = proportional_friction(profile),
                .motor_inertia = profile.dynamics.motor_inertia,
                .joint_inertia = profile.dynamics.joint_inertia,
                .motor_viscous = profile.dynamics.motor_viscous,
                .joint_viscous = profile.dynamics.joint_viscous,
                .se_torsion_rate = profile.k_se.spring.rate,
                .pe_compression_rate = profile.k_pe.spring.rate,
                .springs = std::move(springs.rows)};
    constexpr int kDigits = 3;
    made.tolerance = gap_case::usual_tolerance(made.rig, kDigits);
    made.sensors = gap_case::usual_sensors(made.rig, kDigits);
    made.torques = {profile.rig.least_torque, profile.rig.overdrive_torque};
    made.rest_deflection = springs.rest_deflection;
    const actuator::ReleaseTest test{.push_torque = profile.simulate.push_torque};
    made.push = [joint = path_joint_of(*design), test](double cocontraction) -> gap_case::Push {
        const actuator::ReleaseReading reading = actuator::release_test(joint, cocontraction, test);
        return {reading.push_torque, reading.covered_push};
    };
    return made;
}

}  // namespace fusee::pipeline
