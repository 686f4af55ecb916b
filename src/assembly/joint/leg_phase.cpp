#include <fmt/format.h>

#include <cmath>

#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_leg_phase(const Assembly& assembly, const Allowed& allowed) {
    const auto leg = leg_angle(assembly.drive, assembly.find("k_se_agonist")->rest);
    if (!leg) return {};  // joint.spring_leg says what is not stated, or that there is no slot
    const double aside = core::deg_from_rad(std::remainder(assembly.leg_post_angle - *leg, 2.0 * core::kPi));
    const spring::BaseSpring& s = assembly.drive.k_se_spring;
    core::Finding f = checks::compare(std::abs(aside), {allowed("required"), allowed("review")});
    f.what = fmt::format(
        "angle by which the preload of {:.1f} deg changes when the radial leg is put into its post, at {:.0f} deg: {:g} coils "
        "and the preload leave it at {:.0f} deg",
        core::deg_from_rad(s.preload), core::deg_from_rad(assembly.leg_post_angle), s.active_coils,
        core::deg_from_rad(std::remainder(*leg, 2.0 * core::kPi)));
    f.where = "carriage";
    const double slot = core::deg_from_rad(assembly.drive.k_se->options.features.leg_slot_angle) + aside;
    f.suggestion = core::change("k_se.features.leg_slot_angle_deg", core::number(std::round(std::remainder(slot, 360.0))))
                       .noted(", which turns the post beside the cable");
    return {f};
}

}  // namespace

Rule joint_leg_phase() {
    return {
        {"joint.leg_phase",
         "a torsion spring that cannot have its preload",
         "angle between the radial leg, as slot, coils and preload leave it at the law's lowest load, and its post: the layout places the "
         "post there, unless the series cable passes",
         "geometry: the legs are 2 pi n + preload apart; 2 deg (practice), 10 deg are 5 % of a preload of 200 deg",
         {required(kAtMost, "deg", 10.0), review(kAtMost, "deg", 2.0)}},
        measure_joint_leg_phase};
}

}  // namespace fusee::assembly
