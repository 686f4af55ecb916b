#include "judge.h"

#include <fmt/format.h>

#include <algorithm>

#include "fusee/checks/check.h"
#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/check.h"

namespace fusee::pipeline {

namespace {

/// The mill that the part's programs are for: for a wrapped groove the part turns under the tool.
checks::ProcessKind mill_of(const PartExport& out) {
    const toolpath::Settings& settings = out.settings.machining;
    const toolpath::Method method = out.part.cam.kind == cam::PartKind::kSeries ? settings.k_se : settings.k_pe;
    const bool wrapped = method == toolpath::Method::kWrap || !out.part.cam.closed();
    return wrapped ? checks::ProcessKind::kMill4 : checks::ProcessKind::kMill;
}

/// Warns if the part was judged for another process and rules of the mill object.
core::Finding judged_for_another(const PartExport& out, const profile::Profile& profile) {
    const checks::ProcessKind mill = mill_of(out);
    const OtherProcess other = by_process(profile, mill);
    const core::Findings findings = checks::check({out.part, out.spring, other.profile.cable, other.profile.process, other.profile.limits});
    core::Finding f;
    f.rule = "toolpath.process";
    const auto broken = static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), core::is_broken));
    f.what = broken == 0 ? fmt::format("no rule of {} fails; the part was judged for {}", checks::to_string(mill),
                                       checks::to_string(profile.process.kind))
                         : core::counted(broken, "milling rule") + (broken == 1 ? " fails" : " fail") + "; this G-code suits no mill";
    f.measured = static_cast<double>(broken);
    f.bound = core::Bound::kAtMost;
    f.allowed = 0.0;
    f.unit = "rules";
    f.where = out.name();
    f.suggestion =
        fmt::format("leave \"ngc\" out of outputs.formats; or fusee check PROFILE --process {} lists them", checks::to_string(mill));
    f.source = "docs/theory/toolpaths.md; limits: " + other.figures;
    return core::judged(f, core::Severity::kWarning);
}

}  // namespace

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

void judge_for_mill(PartExport& out, const profile::Profile& profile) {
    const bool has_programs =
        std::any_of(out.law_files.begin(), out.law_files.end(), [](const FileRow& row) { return row.entry.name.ends_with(".ngc"); });
    const bool mirrored = out.name() != profile.name_of(out.part.cam.kind);  // reported once, for the part itself
    if (has_programs && !mirrored && !checks::is_milled(profile.process)) out.findings.push_back(judged_for_another(out, profile));
}

}  // namespace fusee::pipeline
