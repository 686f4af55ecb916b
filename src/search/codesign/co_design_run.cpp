#include <fmt/format.h>

#include <cmath>

#include "draft.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/pipeline/evaluate.h"
#include "run.h"

namespace fusee::search::codesign {

namespace {

using core::deg_from_rad;

design::EvolutionResult search_co_design(const Problem& problem, const RunOptions& run) {
    const profile::Profile& base = problem.base();
    design::EvolutionOptions options = evolution_of(base, problem.bounds(), run);
    keep_checkpoint(options, base, run, "co_design " + base.sha256);
    return design::evolve([&problem](std::span<const double> x) { return cost(problem.evaluate(x)); }, options);
}

/// Adds the dead-bands of built joints, of the design found and of the profile's own.
void add_bands(std::vector<ComparedFigure>& all, const Trial& trial, const design::CoDesignOptions& o,
               const core::Outcome<pipeline::ResolvedDesign>& own) {
    for (const design::RobustBand& built : trial.bands) {
        design::RobustBand before{.nominal = NAN, .band = {NAN, NAN}, .covered_share = NAN};
        if (own) before = design::robust_dead_band(own->drawn_joint(), built.tau, o.scatter);
        all.push_back({fmt::format("95th percentile of built joints at {:g} Nm", built.tau), "deg", deg_from_rad(built.band.high),
                       deg_from_rad(before.band.high)});
        all.push_back({fmt::format("of them with the whole dead-band on their springs at {:g} Nm", built.tau), "%",
                       100.0 * built.covered_share, 100.0 * before.covered_share});
    }
}

std::vector<ComparedFigure> figures_of(const Trial& trial, const design::CoDesignOptions& o,
                                       const core::Outcome<pipeline::ResolvedDesign>& own) {
    std::vector<ComparedFigure> all;
    for (std::size_t i = 0; i < o.torques.size(); ++i)
        all.push_back({fmt::format("exact dead-band at {:g} Nm, full width at the joint", o.torques[i]), "deg",
                       deg_from_rad(trial.dead_band[i]),
                       own ? deg_from_rad(actuator::dead_band(own->actuator, o.torques[i]).exact_width) : NAN});
    add_bands(all, trial, o, own);
    const spring::LawPoint low = own ? own->law()->at_load(o.loads.low) : spring::LawPoint{};
    const spring::LawPoint high = own ? own->law()->at_load(o.loads.high) : spring::LawPoint{};
    const double twice = own ? 2.0 * std::pow(own->actuator.ratio(), 2) : NAN;
    all.push_back({fmt::format("capstan travel from {:g} to {:g} Nm", o.loads.low, o.loads.high), "rad", trial.travel,
                   own ? high.theta - low.theta : NAN});
    all.push_back({fmt::format("joint stiffness, capstans held, at {:g} Nm", o.loads.low), "Nm/rad", trial.stiffness.low, twice * low.s});
    all.push_back(
        {fmt::format("joint stiffness, capstans held, at {:g} Nm", o.loads.high), "Nm/rad", trial.stiffness.high, twice * high.s});
    all.push_back({"largest contour radius of both cams, idle arcs included", "mm", core::mm_from_m(trial.radius)});
    return all;
}

std::vector<std::string> remarks_of(const Trial& trial, const design::CoDesignOptions& o, double worst_arm_error) {
    std::vector<std::string> all;
    std::string line = "exact dead-band, full width at the joint:";
    for (std::size_t i = 0; i < o.torques.size(); ++i)
        line += fmt::format("{} {:.2f} deg at {:g} Nm", i == 0 ? "" : ",", deg_from_rad(trial.dead_band[i]), o.torques[i]);
    all.push_back(line);
    for (const design::RobustBand& built : trial.bands)
        all.push_back(fmt::format("as built, at {:g} Nm: 95 % of the joints within {:.2f} deg; {:.1f} % have all of it on their springs",
                                  built.tau, deg_from_rad(built.band.high), 100.0 * built.covered_share));
    all.push_back(fmt::format("capstan travel {:.4g} rad from {:g} to {:g} Nm; joint stiffness {:.4g} to {:.4g} Nm/rad", trial.travel,
                              o.loads.low, o.loads.high, trial.stiffness.low, trial.stiffness.high));
    line = "limited by:";
    for (const Limit& limit : binding(trial))
        line += fmt::format("{} {} ({:.4g} of {:.4g}{})", line.back() == ':' ? "" : ",", limit.name, limit.measured, limit.allowed,
                            limit.unit.empty() ? "" : " " + limit.unit);
    all.push_back(line.back() == ':' ? "nothing limits it but the box that was searched" : line);
    all.push_back(fmt::format("made and read back: worst arm error {:.4f} %", 100.0 * worst_arm_error));
    return all;
}

SearchReport report_of(const profile::Profile& profile, const Problem& problem, const design::EvolutionResult& found,
                       const profile::Profile& best, const Trial& trial) {
    const auto own = pipeline::resolve(profile), design = pipeline::resolve(best);
    const core::Range torques{profile.rig.least_torque, profile.rig.overdrive_torque};
    SearchReport report;
    report.provenance = {best.name, profile.sha256, "method=co_design"};
    report.method = "co_design";
    note_search(report, profile, found);
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const Problem::Shown v = problem.show(i, found.best[i]);
        report.variables.push_back({v.name, v.unit, v.box, v.value});
    }
    report.figures = figures_of(trial, problem.options(), own);
    report.findings = design->findings;
    report.found = law_curves(design->actuator, torques);
    if (own) report.own = law_curves(own->actuator, torques);
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) report.cams.push_back(cam_curve(kind, *design));
    return report;
}

}  // namespace

RunResult run_co_design(const profile::Profile& profile, const RunOptions& options) {
    const Problem problem(profile);
    const design::EvolutionResult found = search_co_design(problem, options);
    RunResult result;
    result.interrupted = found.interrupted;
    profile::Profile best = problem.candidate(found.best);
    const Trial trial = problem.evaluate(best);
    if (!trial.feasible()) {
        result.findings = broken(trial);
        return result;
    }
    best = renamed(std::move(best), "-best");
    const pipeline::Evaluation made = pipeline::evaluate(best, pipeline::Depth::kFiles);
    for (const core::Finding& f : made.all())
        if (f.severity != core::Severity::kPass) result.findings.push_back(f);
    if (!made.passed()) return result;
    best = moved(std::move(best), result_folder(profile, options));
    SearchReport& report = result.search.emplace(report_of(profile, problem, found, best, trial));
    report.remarks = remarks_of(trial, problem.options(), std::isnan(made.file_errors.arm) ? 0.0 : made.file_errors.arm);
    result.summary = report.remarks;
    result.profiles = {{best.name + ".toml", profile::to_toml(best)}};
    return result;
}

}  // namespace fusee::search::codesign
