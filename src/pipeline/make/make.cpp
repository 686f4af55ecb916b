#include "fusee/pipeline/make.h"

#include <algorithm>
#include <future>
#include <iterator>
#include <set>

#include "evaluate/both_parts.h"
#include "export/joint_files.h"
#include "export/plate.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/as_exported.h"
#include "fusee/pipeline/assembled.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/pair.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/spring/potential.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

constexpr int kDraws = 200;  // joints sampled for the error budget

constexpr std::size_t kDeadBandLevels = 41;
constexpr std::size_t kLawSamples = 401;

/// The table's rows with the springs smoothed from them; none for other kinds of law.
std::optional<SmoothedTable> smoothed_table(const profile::LawSpec& law) {
    const auto* pair = std::get_if<profile::TablePair>(&law.curves);
    if (pair == nullptr) return std::nullopt;
    const auto series = spring::make_tabulated(pair->angle, pair->series, pair->smoothing);
    const auto parallel = spring::make_tabulated(pair->angle, pair->parallel, pair->smoothing);
    SmoothedTable table{pair->file.string(), {}};
    for (std::size_t i = 0; i < pair->angle.size(); ++i)
        table.rows.push_back(
            {pair->angle[i], pair->series[i], pair->parallel[i], series->force(pair->angle[i]), parallel->force(pair->angle[i])});
    return table;
}

LawReport law_report(const ResolvedDesign& design) {
    const profile::LawSpec& spec = design.profile.law;
    LawReport law;
    law.samples = spring::sample_by_load(*design.law(), kLawSamples);
    law.design_loads = design.design_loads;
    law.lead_in_travel = spec.lead_in_travel;
    law.stiction_loads = design.actuator.loads();
    law.table = smoothed_table(spec);
    if (const auto* options = std::get_if<spring::StictionLawOptions>(&spec.curves))
        law.least_feasible_start = spring::least_feasible_load(*options);
    return law;
}

/// Announces external programs, which take seconds for each part.
void announce(const profile::Profile& profile, const MakeOptions& options) {
    if (!options.note) return;
    std::set<std::string> notes;  // a program that several formats need is announced once
    if (options.via == Via::kOpenScad) notes.insert(formats::kOpenScadRenders);
    for (const formats::Format& format : formats::all_formats())
        if (profile.outputs.has(format.name) && *format.note != '\0') notes.insert(format.note);
    for (const std::string& note : notes) options.note(profile.name + ": " + note);
}

void ask_to_stop(const MakeOptions& options) {
    if (options.stop && options.stop()) throw core::Stopped();
}

struct Parts {
    Pair series, parallel;
};

/// Refusal: the law's findings and those of both parts.
core::Outcome<Parts> joined(const ResolvedDesign& design, EvaluatedPart series, EvaluatedPart parallel, bool both_sides) {
    core::Findings refusal = design.findings;
    for (const auto* part : {&series, &parallel}) core::append(refusal, part->findings);
    auto k_se = designed(std::move(series)), k_pe = designed(std::move(parallel));
    if (!k_se || !k_pe) return refusal;
    return Parts{pair_of(std::move(k_se).value(), both_sides), pair_of(std::move(k_pe).value(), both_sides)};
}

core::Outcome<Parts> design_parts(const ResolvedDesign& design, bool both_sides) {
    auto [k_se, k_pe] = both_parts([&](cam::PartKind kind) { return evaluate_part(kind, design, Depth::kSolid); });
    return joined(design, std::move(k_se), std::move(k_pe), both_sides);
}

/// The same, but a part that the rules without a mesh refuse ends the design before either part is meshed. Refusal: then the findings of
/// these rules only.
core::Outcome<Parts> design_parts_outlines_first(const ResolvedDesign& design, bool both_sides) {
    auto outlined = both_parts([&](cam::PartKind kind) { return evaluate_part(kind, design, Depth::kOutline); });
    core::Findings refusal;
    for (const auto* part : {&outlined.first, &outlined.second})
        if (core::any_error(part->findings)) core::append(refusal, part->findings);
    if (!refusal.empty()) {
        refusal.insert(refusal.begin(), design.findings.begin(), design.findings.end());
        return refusal;
    }
    auto [k_se, k_pe] = both_parts([&](cam::PartKind kind) {
        EvaluatedPart part = std::move(kind == cam::PartKind::kSeries ? outlined.first : outlined.second);
        deepen(part, design, Depth::kSolid);
        return part;
    });
    return joined(design, std::move(k_se), std::move(k_pe), both_sides);
}

/// Both sides of both parts, each part on its thread, and all on one plate. @return the exact solids of their STEP files
ExactSolids export_parts(DesignReport& report, const Parts& parts, const profile::Profile& profile, Via via, const fs::path& folder) {
    auto [all, more] = both_parts([&](cam::PartKind kind) {
        return export_pair(kind == cam::PartKind::kSeries ? parts.series : parts.parallel, profile, report.provenance, via, folder);
    });
    std::move(more.begin(), more.end(), std::back_inserter(all));
    PlateFiles plate = write_plate(all, profile, report.provenance, folder);
    ExactSolids exact;
    for (ExportedPart& one : all) {
        if (one.exact) exact.emplace(one.name, *one.exact);
        (one.mirrored ? report.mirrored : report.parts).push_back(std::move(one.report));
    }
    core::append(report.findings, plate.findings);
    report.files = std::move(plate.files);
    report.plate_errors = std::move(plate.arm_errors);
    return exact;
}

void export_joint(DesignReport& report, Assembled joint, const ExactSolids& parts, const profile::Profile& profile,
                  const fs::path& folder) {
    core::append(report.findings, joint.findings);
    report.assembly = std::move(joint.assembly);
    if (!report.assembly) return;
    JointFiles written = write_joint(*report.assembly, parts, profile, report.provenance, folder);
    core::append(report.findings, written.findings);
    report.files.insert(report.files.end(), written.files.begin(), written.files.end());
}

Assembled assemble_pairs(const ResolvedDesign& design, const Parts& parts) {
    const auto part = [](const Pair& pair) { return std::shared_ptr<const solid::Part>(pair.agonist, &pair.agonist->part); };
    return assemble(design, part(parts.series), part(parts.parallel));
}

/// A design with its law alone. Refusal: the law's.
core::Outcome<MadeDesign> start_design(const profile::Profile& profile) {
    auto resolved = resolve(profile);
    if (!resolved) return resolved.refusal();
    MadeDesign made{std::move(resolved).value(), {}, {}};
    made.report.provenance = {profile.name, profile.sha256, ""};
    made.report.actuator = made.resolved.actuator;
    made.report.findings = made.resolved.findings;
    return made;
}

}  // namespace

core::Outcome<MadeDesign> make_parts(const profile::Profile& profile, core::OutputFolder& output, const MakeOptions& options) {
    require_parts(profile);
    require_sliceable(profile);
    const auto begin = [&options](const char* stage) {
        if (options.stage) options.stage(stage);
    };
    begin("spring law");
    auto law = start_design(profile);
    if (!law) return law;
    MadeDesign made = std::move(law).value();
    const ResolvedDesign& design = made.resolved;
    auto simulation = std::async(std::launch::async | std::launch::deferred, [&] { return simulate(design); });  // needs no part
    begin("cams, solids and rules");
    const auto parts = design_parts(design, profile.outputs.pair);
    if (!parts) return parts.refusal();
    ask_to_stop(options);

    DesignReport& report = made.report;
    report.provenance.options = std::string("via=") + to_string(options.via);
    report.law = law_report(design);
    report.dead_band = actuator::dead_band_curve(design.actuator, kDeadBandLevels);
    auto assembled = std::async(std::launch::async | std::launch::deferred, [&] { return assemble_pairs(design, *parts); });
    announce(profile, options);
    begin("part files and read-back");
    const ExactSolids exact = export_parts(report, *parts, profile, options.via, output.path());
    ask_to_stop(options);
    report.as_exported = as_exported(design, report);
    begin("joint and its files");
    export_joint(report, assembled.get(), exact, profile, output.path());
    begin("simulation and error budget");
    made.simulation = simulation.get();
    report.headline = headline_of(design, made.simulation, report.parts, kDraws);
    return made;
}

core::Outcome<MadeDesign> make_figures(const profile::Profile& profile, core::OutputFolder* output) {
    require_parts(profile);
    if (output != nullptr) require_sliceable(profile);
    auto law = start_design(profile);
    if (!law) return law;
    MadeDesign made = std::move(law).value();
    const ResolvedDesign& design = made.resolved;
    const auto parts = design_parts_outlines_first(design, output != nullptr && profile.outputs.pair);
    if (!parts) return parts.refusal();
    DesignReport& report = made.report;
    if (output != nullptr) {
        report.provenance.options = std::string("via=") + to_string(Via::kCgal);
        (void)export_parts(report, *parts, profile, Via::kCgal, output->path());
        report.as_exported = as_exported(design, report);
    } else {
        for (const Pair* pair : {&parts->series, &parts->parallel})
            report.parts.push_back(without_files(pair->agonist, design.spec(pair->agonist->part.cam.kind).spring));
    }
    made.simulation = headline_simulation(design);
    report.headline = headline_of(design, made.simulation, report.parts);
    return made;
}

std::vector<std::string> sheets_of(const profile::Profile& profile) {
    if (!profile.outputs.has("drawing")) return {};
    std::vector<std::string> names{"k_se_inspection.csv", "k_pe_inspection.csv"};
    if (profile.outputs.pair) names.insert(names.end(), {"k_se_mirrored_inspection.csv", "k_pe_mirrored_inspection.csv"});
    return names;
}

}  // namespace fusee::pipeline
