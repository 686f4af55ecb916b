#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kScrew = 4.17e-3, kTorque = 1.5;  // #8-32 [m], [Nm]

core::Findings measure_shaft_screw_torque(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kSetScrew || hub.screw_diameter <= 0.0 || design.part.cam.working.empty()) return {};
    const double share = hub.screw_diameter / kScrew;
    core::Finding f = compare(largest_torque(design.part.cam), {allowed("required", kTorque * share * share)});
    f.what = "largest torque that the set screw transmits to the shaft";
    f.suggestion = change(design, "hub.screw_mm", up(mm_from_m(kScrew) * std::sqrt(f.measured / kTorque)))
                       .or_else(change(design, "hub.lock", quoted("keyway")));
    return {f};
}

}  // namespace

Rule shaft_screw_torque() {
    return {"shaft.screw_torque",
            "a set screw that slips on its shaft",
            "set screw: largest tension times arm",
            "machinedesign, ficientdesign: #8-32 cup about 1.5 Nm; as the square of the diameter (practice)",
            {required(kAtMost, "Nm", "1.5 Nm (screw/4.17 mm)^2")},
            measure_shaft_screw_torque};
}

}  // namespace fusee::checks
