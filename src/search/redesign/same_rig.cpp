#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures.h"
#include "fusee/core/error.h"
#include "fusee/pipeline/design.h"
#include "fusee/search/redesign.h"

namespace fusee::search::redesign {

namespace {

constexpr double kRounding = 1e-3;  // of figures that a case writes with few digits

/// Requires equal figures, in the profile's unit.
void require_equal(const profile::Profile& profile, const std::string& key, const std::string& what, double own, double of_case,
                   double tolerance) {
    const double allowed = std::max(kSameRig * tolerance, kRounding);
    if (std::abs(own - of_case) <= allowed * std::abs(of_case)) return;
    throw core::InvalidInput(
        profile.place_of(key), fmt::format("{}{:.5g}", what, own),
        fmt::format("the case's {:.5g} within {:.2g} %: profile and case must be of the same rig", of_case, 100.0 * allowed));
}

using AtLoad = gap_case::NominalRig::SpringRow;
/// The springs of a case at one load of the capstan, both springs seeing the capstan's angle.
AtLoad at_load(const std::vector<gap_case::NominalRig::SpringRow>& rows, double load) {
    const auto total = [](const gap_case::NominalRig::SpringRow& row) { return row.se_torque + row.pe_torque; };
    auto above = std::find_if(rows.begin() + 1, rows.end() - 1, [&](const auto& row) { return total(row) >= load; });
    const auto below = above - 1;
    const double share = (load - total(*below)) / (total(*above) - total(*below));
    return {std::lerp(below->deflection, above->deflection, share), std::lerp(below->se_torque, above->se_torque, share),
            std::lerp(below->pe_torque, above->pe_torque, share)};
}

/// Requires the same springs, for any origin of their deflection: the share of K_SE at each load, and the travel between loads.
pipeline::ResolvedDesign require_same_springs(const profile::Profile& profile, const gap_case::Case& gap_case) {
    constexpr int kPlaces = 24;
    auto design = pipeline::resolve(profile);
    if (!design) throw core::InvalidInput(profile.place_of("law.kind"), "refused", core::to_line(design.refusal().front()));
    const spring::SpringLaw& law = *design->law();
    const std::vector<gap_case::NominalRig::SpringRow>& rows = gap_case.rig.springs;
    core::Range loads = design->design_loads;
    loads.high = std::min(loads.high, rows.back().se_torque + rows.back().pe_torque);
    const double first_angle = law.at_load(loads.low).theta, first_deflection = at_load(rows, loads.low).deflection;
    for (int i = 0; i <= kPlaces; ++i) {
        const double load = std::lerp(loads.low, loads.high, static_cast<double>(i) / kPlaces);
        const spring::LawPoint own = law.at_load(load);
        const AtLoad of_case = at_load(rows, load);
        require_equal(profile, "law.kind", fmt::format("at a load of {:.4g} Nm F_SE [Nm] = ", load), own.f_se, of_case.se_torque,
                      gap_case.tolerance.spring_rate);
        if (i == kPlaces)
            require_equal(profile, "law.kind", fmt::format("travel [rad] from {:.4g} to {:.4g} Nm = ", loads.low, load),
                          own.theta - first_angle, of_case.deflection - first_deflection, gap_case.tolerance.spring_rate);
    }
    return std::move(design).value();
}

}  // namespace

double rest_deflection(const pipeline::ResolvedDesign& design, const gap_case::Case& gap_case) {
    return at_load(gap_case.rig.springs, design.law()->loads().low).deflection;
}

pipeline::ResolvedDesign require_same_rig(const profile::Profile& profile, const gap_case::Case& gap_case) {
    pipeline::require_joint(profile, "a diagnosis");
    pipeline::require_parts(profile);
    const gap_case::Tolerance& t = gap_case.tolerance;
    const gap_case::NominalRig& rig = gap_case.rig;
    constexpr double kMm = 1e3;
    if (!profile.rig.gear_friction_table.file.empty())
        throw core::InvalidInput(profile.place_of("rig.gear_friction_table"), "given",
                                 "friction in proportion to the load: a case's nominal gear has no other");
    require_equal(profile, "rig.capstan_radius_mm", "", kMm * profile.rig.capstan_radius, kMm * rig.capstan_radius, t.radii);
    require_equal(profile, "rig.joint_radius_mm", "", kMm * profile.rig.joint_radius, kMm * rig.joint_radius, t.radii);
    require_equal(profile, "rig.gear_friction", "", profile.rig.rest_friction(), rig.gear_load_friction, t.gear_load_friction);
    require_equal(profile, "k_se.spring.rate_Nm_per_rad", "", profile.k_se.spring.rate, rig.se_torsion_rate, t.spring_rate);
    require_equal(profile, "k_pe.spring.rate_N_per_m", "", profile.k_pe.spring.rate, rig.pe_compression_rate, t.spring_rate);
    return require_same_springs(profile, gap_case);
}

}  // namespace fusee::search::redesign
