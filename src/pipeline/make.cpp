#include "fusee/pipeline/make.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <iterator>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/file.h"
#include "fusee/core/output_folder.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/as_exported.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/export.h"
#include "fusee/pipeline/pair.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/report/report.h"
#include "fusee/spring/potential.h"
#include "outlook.h"
#include "plate.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

constexpr std::size_t kDeadBandLevels = 41;
constexpr std::size_t kLawSamples = 401;

/// The two parts share nothing but the law: each is designed on its own thread.
template <class Work>
auto both_parts(const Work& work) {
    auto series = std::async(std::launch::async | std::launch::deferred, [&] { return work(cam::PartKind::kSeries); });
    auto parallel = work(cam::PartKind::kParallel);
    return std::pair{series.get(), std::move(parallel)};
}

report::FileRow springs_file(const fs::path& folder, const spring::SpringLaw& law, const profile::Profile& profile) {
    const fs::path path = folder / "springs.csv";
    report::write_springs_csv(path, law, static_cast<std::size_t>(profile.outputs.springs_rows));
    return file_row(path);
}

/// The table's rows beside the springs smoothed from it; none for other kinds of law.
std::optional<report::SmoothedTable> smoothed_table(const profile::LawSpec& law) {
    const auto* pair = std::get_if<profile::TablePair>(&law.curves);
    if (pair == nullptr) return std::nullopt;
    const auto series = spring::make_tabulated(pair->angle, pair->series, pair->smoothing);
    const auto parallel = spring::make_tabulated(pair->angle, pair->parallel, pair->smoothing);
    report::SmoothedTable table{pair->file.string(), {}};
    for (std::size_t i = 0; i < pair->angle.size(); ++i)
        table.rows.push_back(
            {pair->angle[i], pair->series[i], pair->parallel[i], series->force(pair->angle[i]), parallel->force(pair->angle[i])});
    return table;
}

report::LawReport law_report(const DesignedLaw& designed, const profile::Profile& profile, const actuator::Actuator& joint) {
    report::LawReport law;
    law.samples = spring::sample_by_load(*designed.law, kLawSamples);
    law.design_loads = designed.design_loads;
    law.lead_in_travel = profile.law.lead_in_travel;
    law.stiction_loads = joint.loads();
    law.table = smoothed_table(profile.law);
    if (const auto* options = std::get_if<spring::StictionLawOptions>(&profile.law.curves))
        law.least_feasible_start = spring::least_feasible_load(*options);
    return law;
}

/// Nothing is left in out/ until a result says that it was made.
MakeResult not_made(const profile::Profile& profile, core::Findings findings) {
    MakeResult result;
    result.name = profile.name;
    result.findings = std::move(findings);
    return result;
}

core::OutputRun run_of(const profile::Profile& profile, const MakeOptions& options) {
    return {.command = "make",
            .source = profile.file,
            .force = options.force,
            .files = {"report.json", "report.html", "springs.csv", "simulation.json", "simulation.html", "dead_band.csv"}};
}

/// Other programs take seconds a part.
void announce(const profile::Profile& profile, const MakeOptions& options) {
    if (!options.note) return;
    if (options.via == Via::kOpenScad || profile.outputs.scad_stl) options.note(profile.name + ": OpenSCAD renders the solids");
    if (profile.outputs.sliced) options.note(profile.name + ": PrusaSlicer slices the parts");
}

struct Parts {
    Pair series, parallel;
};

/// Refusal: the law's findings and those of both parts.
core::Outcome<Parts> design_parts(const profile::Profile& profile, const DesignedLaw& law) {
    auto [k_se, k_pe] = both_parts([&](cam::PartKind kind) { return design_part(kind, profile, law.law); });
    if (k_se && k_pe)
        return Parts{pair_of(std::move(k_se).value(), profile.outputs.pair), pair_of(std::move(k_pe).value(), profile.outputs.pair)};
    core::Findings findings = law.findings;
    for (const auto* part : {&k_se, &k_pe}) core::append(findings, *part ? (*part)->findings : part->refusal());
    return findings;
}

/// Both sides of both parts, each part on its thread, and all on one plate. The report points at `parts`.
void export_parts(report::DesignReport& design, const Parts& parts, const profile::Profile& profile, Via via, const fs::path& folder) {
    auto [all, more] = both_parts([&](cam::PartKind kind) {
        return export_pair(kind == cam::PartKind::kSeries ? parts.series : parts.parallel, profile, design.provenance, via, folder);
    });
    std::move(more.begin(), more.end(), std::back_inserter(all));
    PlateFiles plate = write_plate(all, profile, design.provenance, folder);
    for (ExportedPart& one : all) (one.mirrored ? design.mirrored : design.parts).push_back(std::move(one.report));
    core::append(design.findings, plate.findings);
    std::move(plate.files.begin(), plate.files.end(), std::back_inserter(design.files));
    design.plate_errors = std::move(plate.arm_errors);
}

}  // namespace

MakeResult make(const profile::Profile& profile, const MakeOptions& options) {
    require_parts(profile);
    require_sliceable(profile);
    core::OutputFolder output(options.out / profile.name, run_of(profile, options));
    const auto law = design_law(profile);
    if (!law) return not_made(profile, law.refusal());
    auto simulation = std::async(std::launch::async | std::launch::deferred, [&profile] { return simulate(profile); });  // needs no part
    const auto parts = design_parts(profile, *law);
    if (!parts) return not_made(profile, parts.refusal());

    const actuator::Actuator joint = actuator_of(profile, law->law);
    const fs::path folder = output.path();
    report::DesignReport design;
    design.provenance = {profile.name, profile.sha256, std::string("via=") + to_string(options.via)};
    design.law = law_report(*law, profile, joint);
    design.dead_band = actuator::dead_band_curve(joint, kDeadBandLevels);
    design.findings = law->findings;
    const core::Outcome<report::Simulation> simulated = simulation.get();
    design.files = write_simulation(*simulated, folder);
    design.files.push_back(springs_file(folder, *law->law, profile));
    announce(profile, options);
    export_parts(design, *parts, profile, options.via, folder);
    design.as_exported = as_exported(profile, law->law, design);

    design.outlook = outlook_of(profile, law->law, *simulated, design.parts);

    MakeResult result = not_made(profile, design.all_findings());
    const report::FileErrors errors = design.file_errors();
    result.head = report::head_figures(design.outlook, errors);
    result.worst_arm_error = std::isnan(errors.arm) ? 0.0 : errors.arm;
    result.worst_dead_band_change = design.as_exported.worst_change();
    if (core::any_error(result.findings)) return result;  // a file does not carry the law: the files go
    core::write_file(folder / "report.json", report::report_json(design));
    core::write_file(folder / "report.html", report::report_html(design));
    output.commit();
    result.made = true;
    result.folder = output.target();
    result.dead_band_peak_deg = core::deg_from_rad(actuator::dead_band(joint, joint.peak_torque).exact_width);
    return result;
}

}  // namespace fusee::pipeline
