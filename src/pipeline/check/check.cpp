#include "fusee/pipeline/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/profile/edit.h"

namespace fusee::pipeline {

namespace {

/// Does the limit's default come from the process?
bool is_of_process(const checks::Override& limit) {
    const checks::Rule* rule = checks::find_rule(limit.rule);
    const checks::Limit* declared = rule == nullptr ? nullptr : rule->limit(limit.limit);
    return declared != nullptr && declared->of_process;
}

CheckedProcess check_process(const profile::Profile& profile, const core::Outcome<ResolvedDesign>& resolved, checks::ProcessKind kind) {
    OtherProcess other = by_process(resolved ? resolved->profile : profile, kind);  // with the figures that follow for its springs
    CheckedProcess checked{checks::to_string(kind), other.figures, kind == profile.process.kind, {}, {}};
    if (!resolved) {
        checked.about = resolved.refusal();
        return checked;
    }
    ResolvedDesign design = *resolved;
    design.profile = other.profile;  // a process changes no law
    for (ResolvedDesign& way : design.ways) {
        way.profile.process = other.profile.process, way.profile.limits = other.profile.limits;
        profile::follow_process(way.profile);
    }
    Evaluation evaluation = evaluate(std::move(design), Depth::kSolid);
    checked.about = std::move(evaluation.findings);
    judge_suggestions(checked.about, other.profile);
    for (EvaluatedPart& part : evaluation.parts) {
        judge_suggestions(part.findings, other.profile);
        checked.parts.push_back({part.name, std::move(part.findings)});
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
    profile::follow_process(other.profile);
    std::erase_if(other.profile.limits, is_of_process);
    other.figures = default_figures(other.profile.process);
    for (const checks::Override& limit : profile.limits)
        if (is_of_process(limit)) other.figures += fmt::format("; left out: {} {} = {:g}", limit.rule, limit.limit, limit.value);
    return other;
}

Checked check(const profile::Profile& profile, std::span<const checks::ProcessKind> kinds) {
    require_parts(profile);
    const auto resolved = resolve(profile);
    Checked checked{profile.name, profile.sha256, "", {}};
    for (const checks::ProcessKind kind : kinds) checked.processes.push_back(check_process(profile, resolved, kind));
    return checked;
}

}  // namespace fusee::pipeline
