#include "codesign/problem.h"

#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"

namespace fusee::search::codesign {

namespace {

constexpr int kDefaultLevels = 6;  // of co-contraction, where the profile names none

std::vector<double> levels(const profile::Rig& rig) {
    std::vector<double> torques;
    for (int i = 0; i < kDefaultLevels; ++i)
        torques.push_back(rig.least_torque + (rig.overdrive_torque - rig.least_torque) * i / (kDefaultLevels - 1));
    return torques;
}

void require_rising(const char* key, core::Range range, double unit) {
    if (!(range.low < range.high))
        throw core::InvalidInput(key, fmt::format("{:g}, {:g}", range.low / unit, range.high / unit), "the second above the first");
}

/// Ranges that are searched; two equal numbers fix the value.
void require_ordered(const char* key, core::Range range, double unit) {
    if (range.low > range.high)
        throw core::InvalidInput(key, fmt::format("{:g}, {:g}", range.low / unit, range.high / unit), "the second not below the first");
}

}  // namespace

Problem::Problem(const profile::Profile& base) : base_(base) {
    pipeline::require_joint(base_, "co-design");
    pipeline::require_parts(base_);
    design::CoDesignOptions& o = base_.co_design;
    if (o.loads.high <= 0.0) o.loads = {base_.rig.least_torque, base_.rig.overdrive_torque};
    require_rising("co_design.loads_Nm", o.loads, 1.0);
    require_ordered("co_design.capstan_radius_mm", o.capstan_radius, 1e-3);
    require_ordered("co_design.lead_in_deg", o.lead_in, core::rad_from_deg(1.0));
    require_ordered("co_design.winding_rad", o.winding, 1.0);
    require_ordered("co_design.compression_mm", o.compression, 1e-3);
    if (o.torques.empty()) o.torques = levels(base_.rig);
    complete_demands();
    add_rig();
    add_spring(&profile::Profile::k_se, "K_SE", o.winding);
    add_spring(&profile::Profile::k_pe, "K_PE", o.compression);
    if (o.law == design::SearchedLaw::kStiction) {
        core::require_positive("rig.gear_friction", pipeline::gear_friction(base_).mu());
        add_stiction_law();
    } else {
        add_free_curve();
    }
}

void Problem::complete_demands() {
    design::CoDesignOptions& o = base_.co_design;
    if (o.travel > 0.0 && o.soft > 0.0 && o.stiff > 0.0) return;
    const auto own = pipeline::resolve(base_);
    if (!own)
        throw core::InvalidInput("co_design.travel_rad", "0, and soft_Nm_per_rad or stiff_Nm_per_rad too",
                                 fmt::format("values above 0: 0 takes them from the profile's own law, which cannot be made: {}",
                                             core::to_line(own.refusal().front())));
    const spring::LawPoint low = own->law()->at_load(o.loads.low), high = own->law()->at_load(o.loads.high);
    const double ratio = base_.rig.joint_radius / base_.rig.capstan_radius;
    if (o.travel <= 0.0) o.travel = high.theta - low.theta;
    if (o.soft <= 0.0) o.soft = 2.0 * ratio * ratio * low.s;
    if (o.stiff <= 0.0) o.stiff = 2.0 * ratio * ratio * high.s;
}

}  // namespace fusee::search::codesign
