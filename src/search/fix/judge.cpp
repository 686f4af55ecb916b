#include "judge.h"

#include <algorithm>

#include "fusee/core/progress.h"
#include "fusee/pipeline/evaluate.h"

namespace fusee::search::fix {

namespace {

using pipeline::Depth;

}  // namespace

cam::PartKind kind_of(const std::string& part, const profile::Profile& profile) {
    const std::vector<cam::PartKind> kinds = profile.part_kinds();
    return kinds.size() == 1 || part == profile.table_of(kinds.front()) ? kinds.front() : kinds.back();
}

std::string part_of(const std::string& text) {
    for (const char* part : {"k_se", "k_pe", "cam"})
        if (text.starts_with(part)) return part;
    return {};
}

std::string part_of(const core::Finding& finding) { return part_of(finding.where); }

std::string name_of(const core::Finding& finding) {
    const std::string part = part_of(finding);
    return part.empty() ? finding.rule : finding.rule + " " + part;
}

core::Findings broken_in(const core::Findings& findings, core::Severity least) {
    core::Findings broken;
    std::copy_if(findings.begin(), findings.end(), std::back_inserter(broken),
                 [least](const core::Finding& f) { return f.severity >= least; });
    return broken;
}

void Judge::ask_to_stop() const {
    if (options_.stop && options_.stop()) throw core::Stopped();
}

void Judge::keep(Verdict& verdict, const core::Findings& findings) const {
    core::append(verdict.broken, broken_in(findings, options_.reviews ? core::Severity::kWarning : core::Severity::kError));
}

Verdict Judge::drawing(const profile::Profile& profile) {
    count();
    return seen(profile);
}

Verdict Judge::seen(const profile::Profile& profile, std::span<const cam::PartKind> kinds) const {
    ask_to_stop();
    const pipeline::Evaluation found = pipeline::evaluate(profile, Depth::kOutline, kinds);
    Verdict verdict;
    if (!found.design) verdict.unseen = kBehindLaw;
    for (const pipeline::EvaluatedPart& part : found.parts)
        if (part.reached < Depth::kOutline) verdict.unseen += part.reached < Depth::kCam ? kBehindCam : kBehindBody;
    keep(verdict, found.all());
    return verdict;
}

/// Nothing of a caller that makes drafts in its own way.
Verdict Judge::solids(const profile::Profile& profile) {
    ask_to_stop();
    Verdict verdict;
    if (!options_.make) keep(verdict, pipeline::evaluate(profile, Depth::kSolid).all());
    return verdict;
}

Verdict Judge::unwritten(const profile::Profile& profile) {
    Verdict drawn = drawing(profile);
    return drawn.clear() ? solids(profile) : drawn;
}

Verdict Judge::making(const profile::Profile& profile) {
    if (Verdict seen = solids(profile); !seen.clear()) return seen;  // files take half of the time
    if (options_.progress) options_.progress("making every file and reading it back");
    ++made_;
    const core::Findings findings = options_.make ? options_.make(profile) : pipeline::evaluate(profile, Depth::kFiles).all();
    Verdict verdict;
    keep(verdict, findings);
    if (!verdict.clear()) return verdict;
    not_judged_ = core::count(findings, core::Severity::kNotJudged);
    warnings_ = broken_in(findings, core::Severity::kWarning);  // no error is left
    return verdict;
}

Verdict Judge::all(const profile::Profile& profile) {
    const Verdict drawn = drawing(profile);
    return drawn.clear() ? making(profile) : drawn;
}

}  // namespace fusee::search::fix
