#include <fmt/format.h>

#include <algorithm>

#include "fusee/checks/thread.h"
#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_frame_screws(const Assembly& assembly, const Allowed& allowed) {
    const auto load = frame_load(assembly);
    if (!load) return {};
    constexpr double kM3 = 3e-3;
    const FrameLoad::Part& worst =
        *std::max_element(load->parts.begin(), load->parts.end(), [](const auto& a, const auto& b) { return a.screw < b.screw; });
    const checks::Material& material = worst.material;
    const double bears = checks::thread_strength(kM3, core::m_from_mm(kScrewReach_mm), material);
    core::Finding f = checks::compare(bears / worst.screw, {allowed("required"), allowed("review")});
    f.what = fmt::format("safety of the threads M3 of {}, {:g} mm deep in {}: {:.0f} N against a pull of {:.0f} N", worst.name,
                         kScrewReach_mm, material.name, bears, worst.screw);
    f.where = worst.name;
    f.suggestion = fmt::format("inserts for M3 that hold {:.0f} N", f.allowed * worst.screw);
    return {f};
}

}  // namespace

Rule joint_frame_screws() {
    return {{"joint.frame_screws",
             "a screw of the frame whose thread strips",
             "strength of the thread over the pull of the most loaded screw, by the moment of what hangs on the plate about its edge",
             "shear area 0.875 pi d L of a 60 deg thread; shear strength half of the tensile one (practice); safety 1.45: Pugsley, good "
             "material and analysis, loads that springs bound",
             {required(kAtLeast, "", 1.0), review(kAtLeast, "", checks::kSafety)}},
            measure_joint_frame_screws};
}

}  // namespace fusee::assembly
