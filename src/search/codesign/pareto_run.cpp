#include <fmt/format.h>

#include <set>

#include "draft.h"
#include "front.h"
#include "fusee/core/lists.h"
#include "fusee/pipeline/evaluate.h"
#include "run.h"

namespace fusee::search::codesign {

namespace {

// Single searches for first members of the front, at these shares of the travel demanded or of the contour's radius; NSGA-II
// alone stays near the first feasible design it meets. Against travel the front begins at the first share.
constexpr std::array kTravels{0.25, 1.0, 1.5, 2.0}, kRadii{1.0, 0.85, 0.7, 0.55};

bool against_size(const Problem& problem) { return problem.options().against == design::Against::kSize; }

/// Dead-band in degrees, and the figure against it, less is better; an infeasible candidate costs its violation in both.
std::array<double, 2> costs_of(const Problem& problem, const Trial& trial) {
    const double figure = cost(trial);
    if (!trial.feasible()) return {figure, figure};
    return {figure, against_size(problem) ? core::mm_from_m(trial.radius) : -trial.travel};
}

/// The least dead-band for the demands of `problem`: a first member of the front, with half of the generations.
design::EvolutionResult best_of(const Problem& problem, const RunOptions& run) {
    design::EvolutionOptions options = evolution_of(problem.base(), problem.bounds(), run);
    options.generations = (options.generations + 1) / 2;
    return design::evolve([&problem](std::span<const double> x) { return cost(problem.evaluate(x)); }, options);
}

/// The same search with another share of the travel demanded, or of the radius allowed.
profile::Profile with_share(const Problem& demanded, double share) {
    profile::Profile profile = demanded.base();
    design::CoDesignOptions& o = profile.co_design;
    (against_size(demanded) ? o.contour_radius : o.travel) *= share;
    return profile;
}

std::string limits_text(const Trial& trial) { return core::listed(binding(trial), &Limit::name); }

/// The front's members that were made, and the rules that forbade the others.
struct Made {
    std::vector<ParetoPoint> points;
    std::vector<FoundProfile> profiles;
    std::size_t dropped = 0;
    std::set<std::string> rules;
};

Made make_all(const Problem& problem, const Front& front, const fs::path& folder) {
    Made made;
    for (const std::vector<double>& x : front.members) {
        profile::Profile profile = problem.candidate(x);
        const Trial trial = problem.evaluate(profile);
        if (!trial.feasible()) continue;
        const std::string number = fmt::format("{:02}", made.points.size() + 1);
        profile = renamed(std::move(profile), "-" + number);
        const pipeline::Evaluation result = pipeline::evaluate(profile, pipeline::Depth::kFiles);
        if (!result.passed()) {
            ++made.dropped;
            for (const core::Finding& f : result.all())
                if (f.severity == core::Severity::kError) made.rules.insert(f.rule);
            continue;
        }
        const std::string file = "pareto/" + number + ".toml";
        made.points.push_back({file, trial.figure, trial.dead_band, trial.travel, trial.stiffness, trial.radius, profile.rig.capstan_radius,
                               limits_text(trial)});
        made.profiles.push_back({file, profile::to_toml(moved(profile, folder / "pareto"))});
    }
    return made;
}

ParetoReport pareto_report_of(const profile::Profile& profile, const Problem& problem, const Front& front, const Made& made) {
    ParetoReport report;
    report.provenance = {profile.name + "-design", profile.sha256, "method=pareto"};
    report.against_size = against_size(problem);
    report.torques = problem.options().torques;
    report.loads = problem.options().loads;
    report.points = made.points;
    report.dropped = made.dropped;
    report.dropped_by = {made.rules.begin(), made.rules.end()};
    report.evaluations = front.evaluations;
    report.population = profile.search.population;
    report.generations = front.generations;
    report.seed = profile.search.seed;
    report.interrupted = front.interrupted;
    return report;
}

Front search_pareto(const Problem& problem, const Problem& demanded, const RunOptions& run) {
    FrontOptions options;
    options.bounds = problem.bounds();
    options.population = problem.base().search.population;
    options.generations = problem.base().search.generations;
    options.seed = static_cast<unsigned>(problem.base().search.seed);
    options.jobs = run.jobs;
    options.progress = run.progress;
    options.stop = run.stop;
    std::size_t before = 0;
    for (const double share : against_size(demanded) ? kRadii : kTravels) {
        design::EvolutionResult member = best_of(Problem(with_share(demanded, share)), run);
        options.seeds.push_back(std::move(member.best));
        before += member.evaluations;
    }
    Front front = find_front([&problem](std::span<const double> x) { return costs_of(problem, problem.evaluate(x)); }, options);
    front.evaluations += before;
    return front;
}

}  // namespace

RunResult run_pareto(const profile::Profile& profile, const RunOptions& options) {
    const Problem demanded(profile);
    const Problem problem(with_share(demanded, against_size(demanded) ? kRadii.front() : kTravels.front()));
    const Front front = search_pareto(problem, demanded, options);
    RunResult result;
    result.interrupted = front.interrupted;
    Made made = make_all(problem, front, result_folder(profile, options));
    if (made.points.empty()) {
        result.findings = broken(problem.evaluate(front.members.front()));
        return result;
    }
    const ParetoReport& report = result.pareto.emplace(pareto_report_of(profile, problem, front, made));
    result.profiles = std::move(made.profiles);
    const ParetoPoint &least = report.points.front(), &most = report.points.back();
    result.summary = {
        fmt::format("{} designs from {:.2f} deg at {:.3g} rad of travel, radius {:.3g} mm, to {:.2f} deg at {:.3g} rad, {:.3g} mm",
                    report.points.size(), core::deg_from_rad(least.figure), least.travel, core::mm_from_m(least.radius),
                    core::deg_from_rad(most.figure), most.travel, core::mm_from_m(most.radius)),
        fmt::format("{} dropped: they could not be made", report.dropped)};
    return result;
}

}  // namespace fusee::search::codesign
