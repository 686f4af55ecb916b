#include "fusee/pipeline/check.h"

#include <fmt/format.h>

#include <future>

#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

namespace {

/// Does the limit's default come from the process?
bool is_of_process(const checks::Override& limit) {
    const checks::Rule* rule = checks::find_rule(limit.rule);
    const checks::Limit* declared = rule == nullptr ? nullptr : rule->limit(limit.limit);
    return declared != nullptr && (rule->group() == "process" || declared->by.find("process's") != std::string::npos);
}

core::Findings findings_of(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law) {
    const auto part = design_part(kind, profile, law);
    return part ? part->findings : part.refusal();
}

report::CheckedProcess check_process(const profile::Profile& profile, const core::Outcome<DesignedLaw>& law, checks::ProcessKind kind) {
    const OtherProcess other = by_process(profile, kind);
    report::CheckedProcess checked{checks::to_string(kind), other.figures, kind == profile.process.kind, {}, {}};
    checked.about = law ? law->findings : law.refusal();
    if (!law) return checked;
    auto series = std::async(std::launch::async | std::launch::deferred,
                             [&] { return findings_of(cam::PartKind::kSeries, other.profile, law->law); });
    core::Findings parallel = findings_of(cam::PartKind::kParallel, other.profile, law->law);
    checked.parts = {{to_string(cam::PartKind::kSeries), series.get()}, {to_string(cam::PartKind::kParallel), std::move(parallel)}};
    return checked;
}

}  // namespace

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

report::Checked check(const profile::Profile& profile, std::span<const checks::ProcessKind> kinds) {
    require_parts(profile);
    const auto law = design_law(profile);
    report::Checked checked{profile.name, profile.sha256, "", {}};
    for (const checks::ProcessKind kind : kinds) checked.processes.push_back(check_process(profile, law, kind));
    return checked;
}

}  // namespace fusee::pipeline
