#include "fusee/pipeline/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fusee/core/error.h"
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

/// "structure.leg_slot k_se": a rule and the part that it judges.
std::string subject_of(const core::Finding& f) {
    for (const cam::PartKind kind : kBothParts)
        if (f.where.starts_with(to_string(kind))) return f.rule + " " + to_string(kind);
    return f.rule;
}

/// The findings against the profile with an alternative's changes, as `fusee` would read it; none if a value is not allowed.
std::optional<core::Findings> findings_with(const core::Changes& changes, const profile::Profile& profile) {
    std::vector<profile::Edit> edits;
    for (const core::Change& change : changes) edits.push_back({change, ""});
    try {
        const std::string toml = profile::to_toml(profile);
        return evaluate(profile::parse_profile(profile::with_edits(toml, profile, edits), profile.file), Depth::kOutline).all();
    } catch (const core::InvalidInput&) {
        return std::nullopt;
    } catch (const core::InvalidInputs&) {
        return std::nullopt;
    }
}

/// Is another base spring asked for? Its wire and coils are found by `fusee springs`, not here.
bool asks_for_spring(const core::Changes& changes) {
    return std::any_of(changes.begin(), changes.end(), [](const core::Change& c) { return c.key.find(".spring.rate_") != c.key.npos; });
}

/// Judges alternatives by the rules that need no mesh.
class Jury {
public:
    explicit Jury(const profile::Profile& profile) : profile_(profile) {
        const Evaluation seen = evaluate(profile, Depth::kOutline);
        before_ = seen.all();
        saw_all_ = seen.design.has_value() && std::all_of(seen.parts.begin(), seen.parts.end(),
                                                          [](const EvaluatedPart& part) { return part.reached == Depth::kOutline; });
    }

    struct Verdict {
        std::string objection;  ///< why it is no alternative: it breaks another rule, or leaves the finding as it is; "" if it helps
        bool suffices = true;
    };
    [[nodiscard]] Verdict judge(const core::Finding& finding, const core::Changes& changes) const {
        const auto after = findings_with(changes, profile_);
        if (!after) return {"is not allowed"};
        const bool spring = asks_for_spring(changes);
        for (const core::Finding& f : *after)
            if (saw_all_ && !(spring && f.rule.starts_with("spring.")) && f.severity == core::Severity::kError && f.rule != finding.rule &&
                badness(before_, subject_of(f)).errors == 0)
                return {"breaks " + subject_of(f)};
        const Badness was = badness(before_, subject_of(finding)), is = badness(*after, subject_of(finding));
        // Of several findings of a rule each has its own suggestion. One of another spring needs coils, which follow.
        const bool left = was.broken == 1 && was.errors == is.errors && is.broken > 0 && !spring;
        return {was.broken > 0 && is >= was ? "does not help" : "", !left};
    }

private:
    /// How much of a subject is broken: fewer errors before fewer warnings before a smaller excess.
    struct Badness {
        int errors = 0, broken = 0;
        double excess = 0.0;
        auto operator<=>(const Badness&) const = default;
    };
    static Badness badness(const core::Findings& findings, const std::string& subject) {
        Badness b;
        for (const core::Finding& f : findings) {
            if (!core::is_broken(f) || subject_of(f) != subject) continue;
            ++b.broken, b.errors += f.severity == core::Severity::kError ? 1 : 0;
            b.excess += std::abs(f.measured - f.allowed);
        }
        return b;
    }

    const profile::Profile& profile_;
    core::Findings before_;
    bool saw_all_ = false;  ///< no refusal hid a rule: an error that is new was caused
};

/// One alternative alone, with its words.
core::Suggestion alone(const core::Alternative& a) {
    if (a.changes.empty()) return a.before + a.after;
    core::Suggestion one(a.changes.front().key, a.changes.front().value);
    for (std::size_t i = 1; i < a.changes.size(); ++i) one.with(a.changes[i].key, a.changes[i].value);
    return one.begun(a.before).noted(a.after);
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

void judge_suggestions(core::Findings& findings, const profile::Profile& profile) {
    if (std::none_of(findings.begin(), findings.end(), [](const core::Finding& f) { return core::is_broken(f); })) return;
    const Jury jury(profile);
    for (core::Finding& f : findings) {
        if (!core::is_broken(f) || f.suggestion.changes().empty()) continue;
        core::Suggestion kept;
        std::string refused;
        for (const core::Alternative& a : f.suggestion.alternatives()) {
            const auto [why, suffices] = a.changes.empty() ? Jury::Verdict{} : jury.judge(f, a.changes);
            if (why.empty())
                kept.or_else(suffices ? alone(a) : alone(a).noted(a.after + ", which helps and does not suffice"));
            else
                refused = fmt::format("no single change of the profile ({} = {} {})", a.changes.front().key, a.changes.front().value, why);
        }
        f.suggestion = kept.empty() ? core::Suggestion(refused) : kept;
    }
}

}  // namespace fusee::pipeline
