#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithm_1_judge.h"
#include "curves.h"
#include "evolution.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/search/design.h"
#include "fusee/search/design_report.h"

namespace fusee::search::codesign {

namespace {

constexpr int kCurvePoints = 401, kBoxParts = 60;

/// Observes all candidates of the search.
class Watch {
public:
    explicit Watch(const design::Algorithm1& algorithm) : algorithm_(algorithm), bounds_(algorithm.bounds()) {
        lowest_.assign(bounds_.size(), std::vector<double>(kBoxParts, std::numeric_limits<double>::quiet_NaN()));
    }

    void see(std::span<const double> x, double cost) {
        for (std::size_t j = 0; j < bounds_.size(); ++j) {
            if (bounds_[j].width() == 0.0) continue;
            const double share = (x[j] - bounds_[j].low) / bounds_[j].width();
            double& lowest = lowest_[j][static_cast<std::size_t>(std::min(share * kBoxParts, kBoxParts - 1.0))];
            lowest = std::fmin(lowest, cost);
        }
        const design::Algorithm1Terms terms = algorithm_.terms(x);
        const double gain = terms.initial_dead_band - terms.final_dead_band;
        if (!terms.feasible || !(gain > 0.0)) return;
        const double other_cost = terms.cost + algorithm_.options().weight_dead_band * gain;  // W1 and W3
        least_weight_ = std::fmin(least_weight_, other_cost / gain);
    }

    /// Middles of the parts of variable j's box and the lowest cost of the candidates in each; NaN where there was none.
    [[nodiscard]] std::vector<double> middles(std::size_t j) const {
        std::vector<double> all;
        for (int i = 0; i < kBoxParts; ++i) all.push_back(bounds_[j].low + bounds_[j].width() * (i + 0.5) / kBoxParts);
        return all;
    }
    [[nodiscard]] const std::vector<double>& lowest(std::size_t j) const { return lowest_[j]; }
    /// The W2 at which the cost of the best feasible candidate is 0; NaN if none was feasible.
    [[nodiscard]] double least_weight() const { return least_weight_; }

private:
    const design::Algorithm1& algorithm_;
    std::vector<core::Range> bounds_;
    std::vector<std::vector<double>> lowest_;
    double least_weight_ = std::numeric_limits<double>::quiet_NaN();
};

/// All figures that the cost depends on: a checkpoint with other figures is refused.
std::string identity(const design::Algorithm1& algorithm) {
    const design::Algorithm1Options& o = algorithm.options();
    const design::Algorithm1Rig& r = algorithm.rig();
    return fmt::format("algorithm_1 mu {} ratio {} torques {} {} {} load {} travel {} range {} weights {} {} {}", r.mu, r.ratio, o.torques,
                       r.torques.low, r.torques.high, r.highest_load, o.wanted_travel, o.joint_range, o.weight_travel, o.weight_dead_band,
                       o.weight_sensitivity);
}

design::EvolutionResult search_algorithm_1(const design::Algorithm1& algorithm, const profile::Profile& profile, const RunOptions& run,
                                           Watch& watch) {
    design::EvolutionOptions options = evolution_of(profile, algorithm.bounds(), run);
    keep_checkpoint(options, profile, run, identity(algorithm));
    options.observe = [&watch](std::span<const double> x, double cost) { watch.see(x, cost); };
    return design::evolve(algorithm, options);
}

/// No springs found: either no candidate was feasible, or vanishing springs cost less.
core::Finding not_found(const design::Algorithm1& algorithm, const design::Algorithm1Terms& best, double least_weight) {
    const double start = algorithm.rig().torques.low, weight = algorithm.options().weight_dead_band;
    core::Finding f;
    f.source = "docs/theory/algorithm_1.md, eq. 3 and 8";
    f.where = "[algorithm_1]";
    f.severity = core::Severity::kError;
    f.bound = core::Bound::kAtLeast;
    if (std::isnan(least_weight)) {
        f.rule = "design.feasible";
        f.what = "no candidate (k, u, C) gives both springs a stiffness above 0 at every load";
        f.measured = best.least_stiffness;
        f.unit = "Nm/rad";
        f.suggestion = core::change("algorithm_1.u_Nm", fmt::format("[0, {:.3g}]", 0.5 * start * std::sqrt(algorithm.rig().mu)))
                           .with("algorithm_1.c_Nm", fmt::format("[0, {:.3g}]", 0.5 * start));
        return f;
    }
    f.rule = "design.weight";
    f.what = "the weight W2 is too small: springs without stiffness would cost less than the best ones (paper, section VI.B)";
    f.measured = weight;
    f.allowed = least_weight;
    f.unit = "1/rad";
    f.suggestion = core::change("algorithm_1.weight_dead_band_per_rad", core::number(1.5 * least_weight, 3));
    return f;
}

std::vector<CostCurve> cost_curves(const design::Algorithm1& algorithm, const std::vector<double>& best, const Watch& watch) {
    static constexpr const char* kUnits[] = {"1/(Nm rad)", "Nm", "Nm"};
    std::vector<CostCurve> curves;
    auto scans = design::scan_costs(algorithm, best, kCurvePoints);
    for (std::size_t j = 0; j < scans.size(); ++j)
        curves.push_back({scans[j].variable, kUnits[j], std::move(scans[j].value), std::move(scans[j].cost), std::move(scans[j].feasible),
                          watch.middles(j), watch.lowest(j), best[j]});
    return curves;
}

}  // namespace

RunResult run_algorithm_1(const profile::Profile& profile, const RunOptions& options) {
    const Judge judge(profile);
    const design::Algorithm1& algorithm = judge.algorithm();
    Watch watch(algorithm);
    const design::EvolutionResult found = search_algorithm_1(algorithm, profile, options, watch);
    RunResult result;
    result.interrupted = found.interrupted;
    const design::Algorithm1Terms terms = algorithm.terms(found.best);
    if (!terms.feasible) {
        result.findings = {not_found(algorithm, terms, watch.least_weight())};
        return result;
    }
    const profile::Profile best = judge.best(found.best, result_folder(profile, options));
    SearchReport& report = result.search.emplace(judge.report(found.best, best));
    note_search(report, profile, found);
    report.costs = cost_curves(algorithm, found.best, watch);
    for (const CamCurve& cam : report.cams)
        if (!cam.part) core::append(result.findings, cam.findings);
    core::append(result.findings, report.findings);
    result.summary = report.remarks;
    result.profiles = {{best.name + ".toml", profile::to_toml(best)}};
    return result;
}

}  // namespace fusee::search::codesign
