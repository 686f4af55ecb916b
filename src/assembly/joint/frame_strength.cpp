#include <fmt/format.h>

#include <cmath>

#include "fusee/checks/limits.h"
#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_frame_strength(const Assembly& assembly, const Allowed& allowed) {
    const auto load = frame_load(assembly);
    if (!load) return {};
    core::Findings all;
    for (const FrameLoad::Part& part : load->parts) {
        if (part.stress_MPa <= 0.0) continue;
        const double strength = 1e-6 * part.material.strength, permanent = 1e-6 * part.material.permanent;
        core::Finding f = checks::compare(part.stress_MPa, {allowed("required", strength), allowed("review", permanent)});
        f.what = fmt::format("bending stress of {} in {} under the cables", part.name, part.material.name);
        f.where = part.name;
        if (&part == &load->parts.back())
            f.suggestion = core::change("assembly.wall_mm", checks::up(plate_mm(assembly) * std::sqrt(part.stress_MPa / f.allowed)));
        else
            f.suggestion = fmt::format("another material.kind, which bears {} MPa for years", checks::up(part.stress_MPa));
        all.push_back(std::move(f));
    }
    return all;
}

}  // namespace

Rule joint_frame_strength() {
    return {
        {"joint.frame_strength",
         "a frame that the cables bend for good",
         "bending stress of plate, rear bracket with its arms, tower and posts as beams, under the largest tensions of the working range",
         "beam theory; loads spread at 45 deg (practice); what the parts' material bears for years, and its strength (table 5)",
         {required(kAtMost, "MPa", "the material's strength"), review(kAtMost, "MPa", "the material's permanent stress")}},
        measure_joint_frame_strength};
}

}  // namespace fusee::assembly
