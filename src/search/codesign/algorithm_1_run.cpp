#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>

#include "draft.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/joint.h"
#include "fusee/core/error.h"
#include "fusee/design/algorithm_1.h"
#include "fusee/spring/laws.h"
#include "run.h"

namespace fusee::search::codesign {

namespace {

/// Algorithm 1 for one profile, and its results: a profile, springs compared with the profile's own, cams.
class Judge {
public:
    /// @throws InvalidInput naming the key: friction that is not in proportion to the load, another arrangement, a wanted travel that
    /// would come from a law that cannot be made
    explicit Judge(const profile::Profile& profile);

    [[nodiscard]] const design::Algorithm1& algorithm() const { return *algorithm_; }
    /// The profile with the law found, to be written into `folder`.
    [[nodiscard]] profile::Profile best(std::span<const double> found, const std::filesystem::path& folder) const;
    /// Variables, figures, curves, cams and remarks. @param best as above
    [[nodiscard]] SearchReport report(std::span<const double> found, const profile::Profile& best) const;

private:
    void compare(SearchReport& report, std::span<const double> found) const;
    void judge(SearchReport& report, const profile::Profile& best) const;
    void remark(SearchReport& report, std::span<const double> found) const;

    const profile::Profile& profile_;
    std::optional<pipeline::ResolvedDesign> own_;  ///< none: the profile's law cannot be made
    std::optional<design::Algorithm1> algorithm_;
};

/// mu; Algorithm 1 is closed for friction in proportion to the load, P(10).
double proportional_friction(const profile::Profile& profile) {
    const spring::FrictionLaw gear = pipeline::gear_friction(profile);
    if (!gear.is_proportional())
        throw core::InvalidInput("rig.gear_friction_constant_Nm", "friction that is not in proportion to the load",
                                 "gear_friction alone for Algorithm 1; design.method = \"co_design\" accepts any");
    return gear.mu();
}

design::Algorithm1 algorithm_of(const profile::Profile& profile, const spring::SpringLawPtr& own) {
    if (profile.rig.arrangement != actuator::Arrangement::kPnrvsa)
        throw core::InvalidInput("rig.arrangement", to_string(profile.rig.arrangement), "\"pnrvsa\": Algorithm 1 designs its springs");
    design::Algorithm1Rig rig;
    rig.mu = proportional_friction(profile);
    rig.ratio = profile.rig.joint_radius / profile.rig.capstan_radius;
    rig.torques = {profile.law.start_torque, profile.rig.peak_torque};
    rig.highest_load = std::max(profile.law.end_torque, profile.rig.peak_torque);
    design::Algorithm1Options options = profile.algorithm_1;
    if (options.wanted_travel == 0.0) {
        const core::Range loads = own ? own->loads() : core::Range{};
        if (!loads.holds(rig.torques.low) || !loads.holds(rig.torques.high))
            throw core::InvalidInput("algorithm_1.wanted_travel_deg", "0",
                                     "above 0, since the profile's own law does not go from law.start_torque_Nm to rig.peak_torque_Nm");
        options.wanted_travel = own->at_load(rig.torques.high).theta - own->at_load(rig.torques.low).theta;
    }
    return {options, rig};
}

std::optional<pipeline::ResolvedDesign> own_design(const profile::Profile& profile) {
    auto design = pipeline::resolve(profile);
    if (!design) return std::nullopt;
    return std::move(design).value();
}

std::string degrees(double rad) { return fmt::format("{:.3g} deg", core::deg_from_rad(rad)); }

Judge::Judge(const profile::Profile& profile) : profile_(profile), own_(own_design(profile)) {
    algorithm_ = algorithm_of(profile, own_ ? own_->law() : nullptr);
}

profile::Profile Judge::best(std::span<const double> found, const std::filesystem::path& folder) const {
    profile::Profile best = renamed(moved(profile_, folder), "-best");
    const design::Algorithm1Rig& rig = algorithm_->rig();
    best.law.curves = spring::StictionLawOptions{found[0], std::abs(found[1]), found[2], rig.mu, rig.torques.low, rig.highest_load};
    best.law.end_torque = rig.highest_load;
    return best;
}

/// The searched numbers and Algorithm 1's terms, compared with those of the profile's own law.
void Judge::compare(SearchReport& report, std::span<const double> found) const {
    static constexpr const char *kNames[] = {"k", "u", "C"}, *kUnits[] = {"1/(Nm rad)", "Nm", "Nm"};
    const auto* own = std::get_if<spring::StictionLawOptions>(&profile_.law.curves);
    const double values[] = {own ? own->k : NAN, own ? own->u : NAN, own ? own->c : NAN};
    const std::vector<core::Range> bounds = algorithm_->bounds();
    for (std::size_t j = 0; j < bounds.size(); ++j) report.variables.push_back({kNames[j], kUnits[j], bounds[j], found[j], values[j]});

    const design::Algorithm1Terms terms = algorithm_->terms(found);
    const double range = algorithm_->options().joint_range;
    double travel = NAN, initial = NAN, final = NAN, sensitivity = NAN;
    if (!report.own.dead_band.empty()) {
        const actuator::DeadBand &first = report.own.dead_band.front(), &last = report.own.dead_band.back();
        travel = last.theta - first.theta;
        initial = std::min(first.linear, range);
        final = std::min(last.linear, range);
        sensitivity = 1.0 / last.free_joint_stiffness;
    }
    report.figures = {{"cost", "", terms.cost, algorithm_->weighed(travel, initial, final, sensitivity)},
                      {"capstan travel, least to peak torque", "deg", core::deg_from_rad(terms.travel), core::deg_from_rad(travel)},
                      {"linear dead-band at the least torque, at most the joint's range", "deg",
                       core::deg_from_rad(terms.initial_dead_band), core::deg_from_rad(initial)},
                      {"linear dead-band at the peak torque", "deg", core::deg_from_rad(terms.final_dead_band), core::deg_from_rad(final)},
                      {"joint's sensitivity at the peak torque, capstans free", "deg/Nm", core::deg_from_rad(terms.sensitivity),
                       core::deg_from_rad(sensitivity)},
                      {"least stiffness of both springs", "Nm/rad", terms.least_stiffness, NAN}};
}

/// The law with its lead-in, then the cams on the profile's base springs; a refusal is a finding and ends the sequence.
void Judge::judge(SearchReport& report, const profile::Profile& best) const {
    const core::Range torques = algorithm_->rig().torques;
    const auto design = pipeline::resolve(best);
    if (!design) {
        report.findings = design.refusal();
        const auto bare = spring::make_stiction_law(std::get<spring::StictionLawOptions>(best.law.curves));
        report.found = law_curves(pipeline::actuator_of(best, *bare), torques);
        return;
    }
    report.findings = design->findings;
    report.found = law_curves(design->actuator, torques);
    if (!profile_.has_parts) return;
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) report.cams.push_back(cam_curve(kind, *design));
}

void Judge::remark(SearchReport& report, std::span<const double> found) const {
    const design::Algorithm1Terms terms = algorithm_->terms(found);
    const core::Range torques = algorithm_->rig().torques;
    std::vector<std::string>& all = report.remarks;
    all.push_back(fmt::format("k = {:.6g} 1/(Nm rad), u = {:.6g} Nm, C = {:.6g} Nm: cost {:.6g}", found[0], std::abs(found[1]), found[2],
                              terms.cost));
    all.push_back(fmt::format("linear dead-band from {} at {:g} Nm to {} at {:g} Nm, capstan travel {} ({} wanted)",
                              degrees(terms.initial_dead_band), torques.low, degrees(terms.final_dead_band), torques.high,
                              degrees(terms.travel), degrees(algorithm_->options().wanted_travel)));
    if (terms.initial_dead_band == algorithm_->options().joint_range)
        all.push_back("the first of these is limited to the range of the joint");
    if (terms.cost >= 0.0) all.push_back("the cost is not below 0, the cost of vanishing springs: W2 must be larger");
    for (std::size_t j = 0; j < report.variables.size(); ++j) {
        const SearchedVariable& v = report.variables[j];
        const double edge = 1e-6 * v.box.width();
        const bool low = v.found - v.box.low <= edge;
        if (low || v.box.high - v.found <= edge)
            all.push_back(fmt::format("{} is at the edge of its box, {:.6g} {}", v.name, low ? v.box.low : v.box.high, v.unit));
    }
    for (const CamCurve& cam : report.cams)
        all.push_back(cam.part ? fmt::format("{} can be cut on the profile's base spring", cam::to_string(cam.kind))
                               : fmt::format("{} cannot be cut on the profile's base spring: see the findings; --method co_design also "
                                             "searches the base springs",
                                             cam::to_string(cam.kind)));
}

SearchReport Judge::report(std::span<const double> found, const profile::Profile& best) const {
    SearchReport report;
    report.provenance = {profile_.name + "-design", profile_.sha256, "method=algorithm_1"};
    report.method = "algorithm_1";
    if (own_) report.own = law_curves(own_->actuator, algorithm_->rig().torques);
    compare(report, found);
    judge(report, best);
    remark(report, found);
    return report;
}

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
