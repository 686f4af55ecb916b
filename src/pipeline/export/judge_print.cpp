#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "judge.h"

namespace fusee::pipeline {

void require_sliceable(const profile::Profile& profile) {
    if (!profile.outputs.has("sliced")) return;
    if (profile.process.kind != checks::ProcessKind::kFdm)
        throw core::InvalidInput(profile.place_of("outputs.formats"),
                                 fmt::format("\"sliced\" with process.kind = \"{}\"", checks::to_string(profile.process.kind)),
                                 "\"sliced\" with process.kind = \"fdm\" only: no other process extrudes beads");
    if (profile.k_pe.cam.family == cam::Family::kRoller)
        throw core::InvalidInput(profile.place_of("outputs.formats"), "\"sliced\" with k_pe.family = \"roller\"",
                                 "\"sliced\" with k_pe.family = \"cable\" only: the print of a roller's rim is not read back");
}

core::Finding judge_print(const readback::ArmError& error, const solid::Part& part) {
    double least = part.cam.working.front().arm.arm;
    for (const cam::Contact& c : part.cam.working) least = std::min(least, c.arm.arm);
    core::Finding f;
    f.rule = "readback.sliced";
    f.what = fmt::format("the lever arm of a cable on the beads of {} must be within half a layer of the nominal one", error.file);
    f.measured = 100.0 * error.worst_relative;
    f.bound = core::Bound::kAtMost;
    f.allowed = 100.0 * error.allowed;
    f.unit = "%";
    f.where = fmt::format("{} at cam angle {:.1f} deg, worst of {} positions", to_string(part.cam.kind),
                          core::deg_from_rad(error.worst_angle_rad), error.rows);
    constexpr double kWidest = core::kPi / 3.0;
    f.suggestion = part.options.groove.throat < kWidest
                       ? core::change("groove.throat_deg", "60").noted(": on steeper flanks beads stand out by more than half a layer")
                       : core::change("process.layer_mm", core::number(core::mm_from_m(error.allowed * least), 2));
    f.source = "docs/theory/read_back.md, eq. 6";
    return core::judged(f, error.when_broken);
}

}  // namespace fusee::pipeline
