#include "fusee/pipeline/make.h"

#include <algorithm>
#include <future>
#include <optional>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/report/report.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

constexpr std::size_t kDeadBandLevels = 41;
constexpr std::size_t kLawSamples = 401;

/// The two parts share nothing but the law: each is designed on its own thread.
template <class Work>
auto both_parts(const Work& work) {
    auto series = std::async(std::launch::async, [&] { return work(cam::PartKind::kSeries); });
    auto parallel = work(cam::PartKind::kParallel);
    return std::pair{series.get(), std::move(parallel)};
}

report::FileRow springs_file(const fs::path& folder, const spring::SpringLaw& law, const profile::Profile& profile) {
    const fs::path path = folder / "springs.csv";
    report::write_springs_csv(path, law, static_cast<std::size_t>(profile.outputs.springs_rows));
    return file_row(path);
}

report::LawReport law_report(const DesignedLaw& designed, const profile::Profile& profile, const actuator::Actuator& joint) {
    report::LawReport law;
    law.samples = spring::sample_by_load(*designed.law, kLawSamples);
    law.design_loads = designed.design_loads;
    law.lead_in_travel = profile.law.lead_in_travel;
    law.stiction_loads = joint.loads();
    if (const auto* options = std::get_if<spring::StictionLawOptions>(&profile.law.curves))
        law.least_feasible_start = spring::least_feasible_load(*options);
    return law;
}

/// Nothing is left in out/ until a result says that it was made.
MakeResult not_made(const profile::Profile& profile, core::Findings findings) {
    return {profile.name, false, {}, std::move(findings), 0.0, 0.0};
}

double worst_arm_error(const report::DesignReport& design) {
    double worst = 0.0;
    for (const report::PartReport& part : design.parts)
        for (const readback::ArmError& e : part.arm_errors) worst = std::max(worst, e.worst_relative);
    return worst;
}

core::Findings all_findings(const report::DesignReport& design) {
    core::Findings all = design.findings;
    for (const report::PartReport& part : design.parts) core::append(all, part.findings);
    return all;
}

}  // namespace

MakeResult make(const profile::Profile& profile, const MakeOptions& options) {
    require_parts(profile);
    const auto law = design_law(profile);
    if (!law) return not_made(profile, law.refusal());
    auto simulation = std::async(std::launch::async, [&profile] { return simulate(profile); });  // needs no part
    const auto [k_se, k_pe] = both_parts([&](cam::PartKind kind) { return design_part(kind, profile, law->law); });
    if (!k_se || !k_pe) {
        core::Findings findings = law->findings;
        for (const auto* part : {&k_se, &k_pe}) core::append(findings, *part ? (*part)->findings : part->refusal());
        return not_made(profile, findings);
    }

    const actuator::Actuator joint = actuator_of(profile, law->law);
    core::StagedFolder staged(options.out / profile.name);
    report::DesignReport design;
    design.provenance = {profile.name, profile.sha256, std::string("via=") + to_string(options.via)};
    design.law = law_report(*law, profile, joint);
    design.dead_band = actuator::dead_band_curve(joint, kDeadBandLevels);
    design.findings = law->findings;
    design.files = write_simulation(*simulation.get(), staged.path());
    design.files.push_back(springs_file(staged.path(), *law->law, profile));
    if (options.via == Via::kOpenScad && options.note) options.note(profile.name + ": OpenSCAD renders both solids");
    auto [series, parallel] = both_parts([&, &se = k_se, &pe = k_pe](cam::PartKind kind) {
        return export_part(kind == cam::PartKind::kSeries ? *se : *pe, profile, design.provenance, options.via, staged.path());
    });
    design.parts = {std::move(series), std::move(parallel)};

    MakeResult result = not_made(profile, all_findings(design));
    result.worst_arm_error = worst_arm_error(design);
    if (core::any_required(result.findings)) return result;  // a file does not carry the law: the staged folder goes
    core::write_file(staged.path() / "report.json", report::report_json(design));
    core::write_file(staged.path() / "report.html", report::report_html(design));
    staged.commit();
    result.made = true;
    result.folder = options.out / profile.name;
    result.dead_band_peak_deg = core::deg_from_rad(actuator::dead_band(joint, joint.peak_torque).extreme);
    return result;
}

}  // namespace fusee::pipeline
