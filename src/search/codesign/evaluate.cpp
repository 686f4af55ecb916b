#include "fusee/pipeline/evaluate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "codesign/problem.h"
#include "shape.h"

// The cost of a candidate (docs/theory/co_design.md).
namespace fusee::search::codesign {

namespace {

constexpr double kLargestExcess = 10.0;
constexpr double kUnmade = 0.05;  // a refusal counts at least this share, so that it is never mistaken for a design
// Violation of a candidate for each step that it does not reach: above the limits of that step, so that no search stops before it.
constexpr double kNoLaw = 100.0, kNoCams = 20.0;
constexpr double kBroken = 1e-6;  // a broken rule counts at least this
constexpr int kSearchRows = 200;  // working positions; the finished design has those of its profile

using core::Bound;

/// Measures one candidate step by step; each step needs the one before.
class Evaluation {
public:
    Evaluation(const design::CoDesignOptions& options, const profile::Profile& p)
        : options_(options), p_(p), ratio_(p.rig.joint_radius / p.rig.capstan_radius) {}

    Trial judge() {
        auto resolved = pipeline::resolve_for_search(p_);
        if (!resolved) {
            refuse(resolved.refusal(), "law");
            trial_.violation += kNoLaw;
            return std::move(trial_);
        }
        design_ = std::move(resolved).value();
        law_ = design_->law();
        judge_law();
        judge_dead_band();
        for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) judge_shape(kind);
        if (!trial_.feasible()) {
            trial_.violation += kNoCams;
            return std::move(trial_);
        }
        trial_.radius = 0.0;
        for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) judge_part(kind);
        return std::move(trial_);
    }

private:
    void keep(Limit limit) {
        trial_.violation += std::max(0.0, limit.excess());
        trial_.limits.push_back(std::move(limit));
    }
    void refuse(const core::Findings& findings, const std::string& of) {
        for (const core::Finding& f : findings) {
            Limit limit{f.rule + " " + of, f.unit, f.measured, f.allowed, f.bound};
            trial_.violation += std::max(kUnmade, limit.excess());
            trial_.limits.push_back(std::move(limit));
        }
    }

    void judge_law() {
        const core::Range wanted = options_.loads, covered = law_->loads();
        keep({"demand.loads_low", "Nm", covered.low, wanted.low, Bound::kAtMost});
        keep({"demand.loads_high", "Nm", covered.high, wanted.high, Bound::kAtLeast});
        const spring::LawPoint low = law_->at_load(wanted.low), high = law_->at_load(wanted.high);
        trial_.travel = high.theta - low.theta;
        trial_.stiffness = {2.0 * ratio_ * ratio_ * low.s, 2.0 * ratio_ * ratio_ * high.s};
        keep({"demand.travel", "rad", trial_.travel, options_.travel, Bound::kAtLeast});
        keep({"demand.soft", "Nm/rad", trial_.stiffness.low, options_.soft, Bound::kAtMost});
        keep({"demand.stiff", "Nm/rad", trial_.stiffness.high, options_.stiff, Bound::kAtLeast});
    }

    /// The exact dead-band where it counts, and the law's reach over every edge from the least co-contraction to the greatest.
    void judge_dead_band() {
        const spring::FrictionLaw friction = pipeline::gear_friction(p_);
        const core::Range angles = law_->angles();
        double lowest = angles.high, highest = 0.0;
        const auto edges_at = [&](double torque) {
            const auto edges = find_edges(*law_, friction.resting_loads(torque)).value_or(Edges{NAN, NAN});
            if (!(edges.low >= lowest)) lowest = edges.low;
            if (!(edges.high <= highest)) highest = edges.high;
            return edges;
        };
        for (const double torque : options_.torques) trial_.dead_band.push_back(edges_at(torque).width(ratio_));
        (void)edges_at(p_.rig.least_torque);
        (void)edges_at(p_.rig.overdrive_torque);
        // In shares of the whole travel: angles begin at 0.
        keep({"cover.least", "of the travel", 1.0 + lowest / angles.width(), 1.0, Bound::kAtLeast});
        keep({"cover.greatest", "of the travel", highest / angles.width(), 1.0, Bound::kAtMost});
        if (options_.figure == design::DeadBandFigure::kPercentile95) judge_scatter();
        trial_.figure = figure();
    }

    /// The dead-band of built joints, and the share of them whose springs cover all of it: a percentile over the others alone would reward
    /// springs that end early.
    void judge_scatter() {
        const design::DrawnJoint drawn = design_->drawn_joint();
        double least = 1.0;
        for (const double torque : options_.torques) {
            trial_.bands.push_back(design::robust_dead_band(drawn, torque, options_.scatter));
            least = std::min(least, trial_.bands.back().covered_share);
        }
        if (options_.covered_share > 0.0) keep({"demand.covered_share", "of built joints", least, options_.covered_share, Bound::kAtLeast});
    }

    /// If a drawing does not cover its edges, its percentiles are unknown and `cover` is broken: the drawing's own widths are used.
    [[nodiscard]] double figure() const {
        std::vector<double> all = trial_.dead_band;
        if (options_.figure == design::DeadBandFigure::kWorst) return *std::max_element(all.begin(), all.end());
        for (std::size_t i = 0; i < trial_.bands.size(); ++i)
            if (const double high = trial_.bands[i].band.high; !std::isnan(high)) all[i] = high;
        return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
    }

    void judge_shape(cam::PartKind kind) {
        const std::string part = to_string(kind);
        const Shape shape = shape_of(design_->arm(kind), design_->spec(kind).cam);
        const double least_rho = kind == cam::PartKind::kSeries ? options_.least_rho_se : options_.least_rho_pe;
        trial_.radius = trial_.arc_radius = std::max(trial_.radius, shape.radius);
        keep({"limit.rho " + part, "mm", core::mm_from_m(shape.least_rho), core::mm_from_m(least_rho), Bound::kAtLeast});
        keep({"limit.contour_radius " + part, "mm", core::mm_from_m(shape.radius), core::mm_from_m(options_.contour_radius),
              Bound::kAtMost});
        if (design_->spec(kind).cam.path.kind == cam::PathKind::kPlanar)
            keep({"limit.wrap " + part, "rad", shape.wrap, kPlanarWrap, Bound::kAtMost});
    }

    void judge_part(cam::PartKind kind) {
        const std::string part = to_string(kind);
        (kind == cam::PartKind::kSeries ? design_->profile.k_se : design_->profile.k_pe).cam.target_rows = kSearchRows;
        const pipeline::EvaluatedPart seen = pipeline::evaluate_part(kind, *design_, pipeline::Depth::kOutline);
        if (seen.cam) trial_.radius = std::max(trial_.radius, contour_radius(*seen.cam));
        if (seen.reached < pipeline::Depth::kOutline) return refuse(seen.findings, part);
        for (const core::Finding& f : seen.findings) {
            if (f.severity == core::Severity::kNotJudged) continue;  // measures nothing
            const bool broken = f.severity == core::Severity::kError ||
                                (f.severity == core::Severity::kWarning && options_.reviews == design::Reviews::kAvoid);
            Limit limit{f.rule + " " + part, f.unit, f.measured, f.allowed, f.bound};
            limit.review = f.severity == core::Severity::kWarning && !broken;
            if (broken) trial_.violation += std::max(kBroken, limit.excess());
            trial_.limits.push_back(std::move(limit));
        }
    }

    static constexpr double kPlanarWrap = 2.0 * core::kPi - 0.2;  // rule cam.wrap

    const design::CoDesignOptions& options_;
    const profile::Profile& p_;
    double ratio_;
    std::optional<pipeline::ResolvedDesign> design_;  // none: no law
    spring::SpringLawPtr law_;
    Trial trial_;
};

}  // namespace

double Limit::excess() const {
    const double scale = std::max(std::abs(allowed), 1e-9);
    const double share = (bound == Bound::kAtMost ? measured - allowed : allowed - measured) / scale;
    return std::isnan(share) ? kLargestExcess : std::clamp(share, -kLargestExcess, kLargestExcess);
}

double cost(const Trial& trial) {
    constexpr double kInfeasible = 1000.0;  // [deg] more than any joint turns
    return trial.feasible() ? core::deg_from_rad(trial.figure) : kInfeasible * (1.0 + trial.violation);
}

Trial avoiding_reviews(Trial trial, double least_rho) {
    double bends = 0.0, reviews = 0.0;
    for (Limit& limit : trial.limits) {
        if (limit.review) reviews += std::max(kBroken, limit.excess());
        if (!limit.name.starts_with("limit.rho ")) continue;
        limit.allowed = core::mm_from_m(least_rho);
        bends += std::max(0.0, limit.excess());
    }
    trial.violation += bends > 0.0 ? bends + kNoCams : reviews;
    if (bends > 0.0) trial.radius = trial.arc_radius;
    return trial;
}

Trial Problem::evaluate(const profile::Profile& candidate) const { return Evaluation(options(), candidate).judge(); }

}  // namespace fusee::search::codesign
