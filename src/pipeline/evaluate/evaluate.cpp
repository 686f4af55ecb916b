#include "fusee/pipeline/evaluate.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "each_part.h"
#include "fusee/core/folder.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/make.h"

namespace fusee::pipeline {

namespace {

std::vector<EvaluatedPart> evaluate_parts(const ResolvedDesign& design, Depth depth, std::span<const cam::PartKind> kinds) {
    if (depth == Depth::kLaw) return {};
    std::vector<AskedPart> parts = parts_of(design);
    if (!kinds.empty())
        std::erase_if(parts, [&](const AskedPart& part) { return std::find(kinds.begin(), kinds.end(), part.kind) == kinds.end(); });
    return each_part(parts, [&](const AskedPart& part) { return evaluate_part(part.kind, *part.design, depth); });
}

/// Nothing for a single spring, and unless both parts stand and break no rule: a joint of other parts would not be this one.
core::Findings judge_joint(const ResolvedDesign& design, const std::vector<EvaluatedPart>& parts) {
    std::vector<std::shared_ptr<const solid::Part>> solids;
    for (const EvaluatedPart& part : parts)
        if (part.reached == Depth::kSolid && !core::any_error(part.findings)) solids.push_back(std::make_shared<solid::Part>(*part.body));
    return solids.size() == 2 && !design.profile.is_spring() ? assemble(design, solids[0], solids[1]).findings : core::Findings{};
}

Evaluation evaluate_files(const profile::Profile& profile) {
    const core::TemporaryFolder folder;
    core::OutputFolder output(folder.path() / "parts", {.command = "make", .source = profile.file});  // never committed
    auto made = make_parts(profile, output);
    Evaluation all;
    if (!made) {
        all.findings = made.refusal();
        return all;
    }
    all.findings = made->report.findings;
    for (const PartReport* side : made->report.sides())
        all.parts.push_back({.kind = side->part->cam.kind, .name = side->name, .reached = Depth::kFiles, .findings = side->findings});
    all.file_errors = made->report.file_errors();
    all.design = std::move(made).value().resolved;
    return all;
}

}  // namespace

core::Findings Evaluation::all() const {
    core::Findings all = findings;
    for (const EvaluatedPart& part : parts) core::append(all, part.findings);
    return all;
}

Evaluation evaluate(ResolvedDesign design, Depth depth, std::span<const cam::PartKind> kinds) {
    Evaluation all;
    all.findings = design.findings;
    all.parts = evaluate_parts(design, depth, kinds);
    if (depth == Depth::kSolid) core::append(all.findings, judge_joint(design, all.parts));
    all.design = std::move(design);
    return all;
}

Evaluation evaluate(const profile::Profile& profile, Depth depth, std::span<const cam::PartKind> kinds) {
    if (depth > Depth::kLaw) require_parts(profile);
    if (depth == Depth::kFiles) return evaluate_files(profile);
    auto design = resolve(profile);
    if (!design) return {.findings = design.refusal()};
    return evaluate(std::move(design).value(), depth, kinds);
}

}  // namespace fusee::pipeline
