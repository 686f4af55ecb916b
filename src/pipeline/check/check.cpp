#include "fusee/pipeline/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>

#include "fusee/core/units.h"
#include "fusee/pipeline/assembled.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

namespace {

/// Does the limit's default come from the process?
bool is_of_process(const checks::Override& limit) {
    const checks::Rule* rule = checks::find_rule(limit.rule);
    const checks::Limit* declared = rule == nullptr ? nullptr : rule->limit(limit.limit);
    return declared != nullptr && (rule->group() == "process" || declared->by.find("process's") != std::string::npos);
}

core::Findings findings_of(const core::Outcome<DesignedPart>& part) { return part ? part->findings : part.refusal(); }

core::Findings joint_findings(const ResolvedDesign& design, const DesignedPart& k_se, const DesignedPart& k_pe) {
    return assemble(design, std::make_shared<solid::Part>(k_se.part), std::make_shared<solid::Part>(k_pe.part)).findings;
}

/// @param joint findings of the joint, which no process changes: those of the first process that makes both parts
CheckedProcess check_process(const profile::Profile& profile, const core::Outcome<ResolvedDesign>& resolved, checks::ProcessKind kind,
                             std::optional<core::Findings>& joint) {
    OtherProcess other = by_process(profile, kind);
    CheckedProcess checked{checks::to_string(kind), other.figures, kind == profile.process.kind, {}, {}};
    checked.about = resolved ? resolved->findings : resolved.refusal();
    if (!resolved) return checked;
    ResolvedDesign design = *resolved;
    design.profile = std::move(other.profile);  // a process changes no law
    auto series = std::async(std::launch::async | std::launch::deferred, [&design] { return design_part(cam::PartKind::kSeries, design); });
    const auto k_pe = design_part(cam::PartKind::kParallel, design), k_se = series.get();
    checked.parts = {{to_string(cam::PartKind::kSeries), findings_of(k_se)}, {to_string(cam::PartKind::kParallel), findings_of(k_pe)}};
    if (k_se && k_pe) {
        if (!joint) joint = joint_findings(design, *k_se, *k_pe);
        core::append(checked.about, *joint);
    }
    return checked;
}

/// Relative excess over the limit; infinite if the measured value is not a number or the limit is 0.
double beyond(const core::Finding& f) {
    if (!std::isfinite(f.measured) || f.allowed == 0.0) return INFINITY;
    return std::abs(f.measured - f.allowed) / std::abs(f.allowed);
}

}  // namespace

core::Findings CheckedProcess::all() const {
    core::Findings all = about;
    for (const CheckedPart& part : parts) core::append(all, part.findings);
    return all;
}

bool Checked::makeable() const {
    return std::any_of(processes.begin(), processes.end(), [](const CheckedProcess& p) { return !core::any_error(p.all()); });
}

const core::Finding* binding(const core::Findings& findings) {
    const core::Finding* found = nullptr;
    for (const core::Finding& f : findings) {
        if (!core::is_broken(f)) continue;
        const bool graver = !found || f.severity > found->severity || (f.severity == found->severity && beyond(f) > beyond(*found));
        if (graver) found = &f;
    }
    return found;
}

std::string default_figures(const checks::Process& process) {
    return fmt::format("defaults of {}, build volume {:g} x {:g} x {:g} mm", checks::to_string(process.kind),
                       core::mm_from_m(process.build_x), core::mm_from_m(process.build_y), core::mm_from_m(process.build_z));
}

OtherProcess by_process(const profile::Profile& profile, checks::ProcessKind kind) {
    if (kind == profile.process.kind) return {profile, "[process] and [[limits]] of the profile"};
    OtherProcess other{profile, ""};
    other.profile.process = checks::Process{};
    other.profile.process.kind = kind;
    std::erase_if(other.profile.limits, is_of_process);
    other.figures = default_figures(other.profile.process);
    for (const checks::Override& limit : profile.limits)
        if (is_of_process(limit)) other.figures += fmt::format("; left out: {} {} = {:g}", limit.rule, limit.limit, limit.value);
    return other;
}

core::Findings outline_findings(const profile::Profile& profile) {
    require_parts(profile);
    const auto design = resolve(profile);
    if (!design) return design.refusal();
    const auto part_findings = [&](cam::PartKind kind) -> core::Findings {
        const auto cam = design_cam(kind, *design);
        if (!cam) return cam.refusal();
        const profile::PartSpec& spec = design->spec(kind);
        const auto body = solid::outline_part(*cam, spec.solid);
        if (!body) return body.refusal();
        return checks::check_without_mesh({*body, spec.spring, profile.cable, profile.process, profile.limits});
    };
    auto series = std::async(std::launch::async | std::launch::deferred, part_findings, cam::PartKind::kSeries);
    const core::Findings parallel = part_findings(cam::PartKind::kParallel);
    core::Findings all = design->findings;
    core::append(all, series.get());
    core::append(all, parallel);
    return all;
}

Checked check(const profile::Profile& profile, std::span<const checks::ProcessKind> kinds) {
    require_parts(profile);
    const auto resolved = resolve(profile);
    Checked checked{profile.name, profile.sha256, "", {}};
    std::optional<core::Findings> joint;
    for (const checks::ProcessKind kind : kinds) checked.processes.push_back(check_process(profile, resolved, kind, joint));
    return checked;
}

}  // namespace fusee::pipeline
