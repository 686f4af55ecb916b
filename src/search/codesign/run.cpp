#include "run.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "fusee/actuator/dead_band.h"
#include "fusee/cam/arm.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::search::codesign {

namespace {

design::Method method_named(const std::string& name) {
    const auto found = std::ranges::find(design::kMethodNames, name);
    if (found == design::kMethodNames.end()) throw core::InvalidInput("method", name, "algorithm_1, co_design or pareto");
    return static_cast<design::Method>(found - design::kMethodNames.begin());
}

constexpr std::size_t kSamples = 401, kLevels = 61;

constexpr double kNear = 0.01;
/// Rules that depend on groove, hub and process only, or on a radius that the closing arc always exhausts.
constexpr std::array<std::string_view, 14> kUnmoved{"groove.",
                                                    "shaft.",
                                                    "process.hole",
                                                    "process.wall",
                                                    "process.detail",
                                                    "structure.idle_curvature",
                                                    "structure.hole_edge",
                                                    "collision.",
                                                    "fdm.",
                                                    "sla.",
                                                    "sls.",
                                                    "mill.",
                                                    "stack.",
                                                    "assembly."};

bool moved(const Limit& limit) {
    return std::none_of(kUnmoved.begin(), kUnmoved.end(), [&](std::string_view rule) { return limit.name.starts_with(rule); });
}

}  // namespace

fs::path result_folder(const profile::Profile& profile, const RunOptions& options) { return options.out / (profile.name + "-design"); }

fs::path checkpoint_file(const profile::Profile& profile, const RunOptions& options) {
    return options.out / (profile.name + "-design.checkpoint");
}

core::OutputRun output_run(const profile::Profile& profile, const RunOptions& options) {
    return {.command = "design", .source = profile.file, .force = options.force, .stays = true};
}

profile::Profile moved(profile::Profile profile, const fs::path& folder) {
    const fs::path from = profile.file.parent_path(), to = fs::absolute(folder).lexically_normal();
    const auto move = [&](fs::path& file) {
        if (!file.empty() && file.is_relative()) file = fs::absolute(from / file).lexically_normal().lexically_relative(to);
    };
    move(profile.rig.gear_friction_table.file);
    move(profile.simulate.measured.file);
    move(profile.co_design.catalogue_file);
    if (auto* one = std::get_if<profile::OneSpring>(&profile.law.curves)) move(one->rows.file);
    if (auto* table = std::get_if<profile::TablePair>(&profile.law.curves)) move(table->file);
    if (auto* wanted = std::get_if<profile::DeadBandSpec>(&profile.law.curves)) {
        move(wanted->dead_band.rows.file);
        move(wanted->series_stiffness.rows.file);
    }
    return profile;
}

design::EvolutionOptions evolution_of(const profile::Profile& profile, std::vector<core::Range> bounds, const RunOptions& run) {
    design::EvolutionOptions options;
    options.bounds = std::move(bounds);
    options.population = profile.search.population;
    options.generations = profile.search.generations;
    options.seed = static_cast<std::uint64_t>(profile.search.seed);
    options.jobs = run.jobs;
    options.stop = run.stop;
    return options;
}

void keep_checkpoint(design::EvolutionOptions& options, const profile::Profile& profile, const RunOptions& run, std::string problem) {
    if (!run.out.empty()) {
        core::make_folder(run.out);
        options.checkpoint = checkpoint_file(profile, run);
    }
    options.resume = run.resume;
    options.force = run.force;
    options.problem = std::move(problem);
    options.progress = run.progress;
}

void change_search(design::SearchOptions& search, const SearchChanges& changes) {
    if (changes.method) search.method = method_named(*changes.method);
    search.population = changes.population.value_or(search.population);
    search.generations = changes.generations.value_or(search.generations);
    search.seed = changes.seed.value_or(search.seed);
}

RunResult find_springs(const profile::Profile& profile, const RunOptions& options) {
    switch (profile.search.method) {
        case design::Method::kAlgorithm1:
            return run_algorithm_1(profile, options);
        case design::Method::kCoDesign:
            return run_co_design(profile, options);
        case design::Method::kPareto:
            break;
    }
    return run_pareto(profile, options);
}

LawCurves law_curves(const actuator::Actuator& joint, core::Range torques) {
    LawCurves curves;
    curves.samples = spring::sample_by_load(*joint.law, kSamples);
    for (std::size_t i = 0; i < kLevels; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(kLevels - 1);
        curves.dead_band.push_back(actuator::dead_band(joint, torques.low + share * torques.width()));
    }
    return curves;
}

CamCurve cam_curve(cam::PartKind kind, const pipeline::ResolvedDesign& design) {
    CamCurve curve;
    curve.kind = kind;
    const cam::ArmFunction arm = design.arm(kind);
    for (const spring::LawPoint& p : spring::sample_by_load(*design.law(), kSamples)) curve.arms.push_back(arm.at_load(p.tau));
    auto designed = pipeline::design_part(kind, design);
    curve.findings = designed ? designed->findings : designed.refusal();
    if (designed) curve.part = std::move(designed).value().part;
    return curve;
}

void note_search(SearchReport& report, const profile::Profile& profile, const design::EvolutionResult& found) {
    report.population = profile.search.population;
    report.generations = found.generations;
    report.seed = profile.search.seed;
    report.evaluations = found.evaluations;
    report.interrupted = found.interrupted;
    report.cost = found.cost;
    report.history = found.history;
}

std::vector<Limit> binding(const Trial& trial) {
    std::vector<Limit> all;
    for (const Limit& limit : trial.limits)
        if (std::abs(limit.excess()) < kNear && moved(limit)) all.push_back(limit);
    return all;
}

core::Findings broken(const Trial& trial) {
    std::vector<Limit> worst;
    for (const Limit& limit : trial.limits)
        if (limit.excess() > 0.0) worst.push_back(limit);
    std::stable_sort(worst.begin(), worst.end(), [](const Limit& a, const Limit& b) { return a.excess() > b.excess(); });
    core::Findings findings;
    for (const Limit& limit : worst) {
        const auto space = limit.name.find(' ');
        core::Finding f = core::error_finding(limit.name.substr(0, space), "the nearest design found breaks this limit", limit.measured,
                                              limit.bound, limit.allowed, limit.unit);
        if (space != std::string::npos) f.where = limit.name.substr(space + 1);
        f.suggestion = "wider bounds, weaker demands or more generations in [co_design] and [design]";
        f.source = "docs/theory/co_design.md";
        findings.push_back(std::move(f));
    }
    return findings;
}

}  // namespace fusee::search::codesign
