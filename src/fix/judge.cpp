#include "judge.h"

#include <algorithm>

#include "fusee/cam/arm.h"
#include "fusee/checks/check.h"
#include "fusee/core/progress.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/make.h"

namespace fusee::fix {

namespace {

constexpr cam::PartKind kKinds[] = {cam::PartKind::kSeries, cam::PartKind::kParallel};

}  // namespace

std::string part_of(const core::Finding& finding) {
    for (const cam::PartKind kind : kKinds)
        if (finding.where.starts_with(to_string(kind))) return to_string(kind);
    return {};
}

std::string name_of(const core::Finding& finding) {
    const std::string part = part_of(finding);
    return part.empty() ? finding.rule : finding.rule + " " + part;
}

void Judge::ask_to_stop() const {
    if (options_.stop && options_.stop()) throw core::Stopped();
}

void Judge::keep(Verdict& verdict, const core::Findings& findings) const {
    const core::Severity least = options_.reviews ? core::Severity::kWarning : core::Severity::kError;
    std::copy_if(findings.begin(), findings.end(), std::back_inserter(verdict.broken),
                 [least](const core::Finding& f) { return f.severity >= least; });
}

void Judge::sketch(Verdict& verdict, cam::PartKind kind, const pipeline::ResolvedDesign& design) const {
    const auto cam = pipeline::design_cam(kind, design);
    if (!cam) {
        verdict.unseen += kBehindCam;
        return keep(verdict, cam.refusal());
    }
    const profile::Profile& profile = design.profile;
    const profile::PartSpec& spec = design.spec(kind);
    const auto body = solid::outline_part(*cam, spec.solid);
    if (!body) {
        verdict.unseen += kBehindBody;
        return keep(verdict, body.refusal());
    }
    keep(verdict, checks::check_without_mesh({*body, spec.spring, profile.cable, profile.process, profile.limits}));
}

Verdict Judge::drawing(const profile::Profile& profile) { return draw(kKinds, profile); }

Verdict Judge::part(cam::PartKind kind, const profile::Profile& profile) { return draw(std::span(&kind, 1), profile); }

Verdict Judge::draw(std::span<const cam::PartKind> kinds, const profile::Profile& profile) {
    ask_to_stop();
    ++judged_;
    Verdict verdict;
    const auto design = pipeline::resolve(profile);
    if (!design) {
        verdict.unseen = kBehindLaw;
        keep(verdict, design.refusal());
        return verdict;
    }
    keep(verdict, design->findings);
    for (const cam::PartKind kind : kinds) sketch(verdict, kind, *design);
    return verdict;
}

Verdict Judge::making(const profile::Profile& profile) {
    ask_to_stop();
    if (options_.progress) options_.progress("making every file and reading it back");
    ++made_;
    const core::Findings findings = options_.make ? options_.make(profile) : pipeline::verify(profile).findings;
    Verdict verdict;
    keep(verdict, findings);
    if (!verdict.clear()) return verdict;
    not_judged_ = core::count(findings, core::Severity::kNotJudged);
    warnings_.clear();
    std::copy_if(findings.begin(), findings.end(), std::back_inserter(warnings_),
                 [](const core::Finding& f) { return f.severity == core::Severity::kWarning; });
    return verdict;
}

Verdict Judge::all(const profile::Profile& profile) {
    const Verdict drawn = drawing(profile);
    return drawn.clear() ? making(profile) : drawn;
}

}  // namespace fusee::fix
