#include "reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "codesign/shape.h"
#include "fusee/spring/friction.h"
#include "fusee/spring/potential.h"

namespace fusee::search::init {

namespace {

constexpr int kPlaces = 400;              // at which the measured springs are looked at
constexpr double kLeastShare = 0.05;      // of the file's angles
constexpr double kLeastStiffness = 1e-3;  // of the mean of both springs
constexpr double kInside = 1e-4;          // of the run, off its ends

/// Both measured springs over the file's angles.
struct Rows {
    spring::PotentialPtr series, parallel;
    double least_stiffness = 0.0;  ///< below it a torque does not rise [Nm/rad]

    [[nodiscard]] double stiffness(double x) const { return std::min(series->stiffness(x), parallel->stiffness(x)); }
    [[nodiscard]] bool are_springs(double x) const {
        return std::min(series->force(x), parallel->force(x)) > 0.0 && stiffness(x) > least_stiffness;
    }
    [[nodiscard]] double load(double x) const { return series->force(x) + parallel->force(x); }
};

core::Range longest_run(const Rows& rows, core::Range angles) {
    core::Range longest{angles.low, angles.low}, run = longest;
    bool inside = false;
    for (int i = 0; i <= kPlaces; ++i) {
        const double x = angles.low + angles.width() * i / kPlaces;
        const bool good = rows.are_springs(x);
        if (good) run = {inside ? run.low : x, x};
        inside = good;
        if (good && run.width() > longest.width()) longest = run;
    }
    return longest;
}

core::Finding no_springs(const Rows& rows, core::Range angles) {
    double worst = angles.low;
    for (int i = 0; i <= kPlaces; ++i)
        if (const double x = angles.low + angles.width() * i / kPlaces; rows.stiffness(x) < rows.stiffness(worst)) worst = x;
    const bool parallel = rows.parallel->stiffness(worst) < rows.series->stiffness(worst);
    core::Finding f = core::error_finding(
        "law.stiffness",
        fmt::format("nowhere do both measured torques rise with the angle, as those of a joint of two sides must; least stiffness of {}",
                    parallel ? "parallel_Nm" : "series_Nm"),
        rows.stiffness(worst), core::Bound::kAtLeast, rows.least_stiffness, "Nm/rad");
    f.where = fmt::format("--law at {:.4g} rad", worst);
    f.suggestion = "a file in which series_Nm and parallel_Nm rise with angle_rad";
    f.source = "docs/theory/springs.md, eq. 1";
    return f;
}

core::Finding not_reached(bool least, double load, double angle, double has, double last) {
    core::Finding f = core::error_finding(
        least ? "cover.least" : "cover.greatest",
        fmt::format("stiction holds a capstan {} {:.4g} rad of the measured springs, which {} at {:.4g} rad; load there",
                    least ? "down to" : "up to", angle, least ? "begin" : "end", last),
        has, least ? core::Bound::kAtMost : core::Bound::kAtLeast, load, "Nm");
    f.where = fmt::format("--law at the {} co-contraction", least ? "least" : "greatest");
    f.source = "docs/theory/dead_band.md, eq. 5-7";
    return f;
}

}  // namespace

core::Outcome<MeasuredLaw> MeasuredLaw::of(const profile::TablePair& table) {
    Rows rows{spring::make_tabulated(table.angle, table.series, table.smoothing),
              spring::make_tabulated(table.angle, table.parallel, table.smoothing)};
    const core::Range angles{table.angle.front(), table.angle.back()};
    rows.least_stiffness = kLeastStiffness * std::abs(rows.load(angles.high) - rows.load(angles.low)) / angles.width();
    core::Range run = longest_run(rows, angles);
    if (run.width() < kLeastShare * angles.width()) return no_springs(rows, angles);
    run = {run.low + kInside * run.width(), run.high - kInside * run.width()};
    auto law = spring::make_pair_law(rows.series, rows.parallel, rows.load(run.low), rows.load(run.high));
    if (!law) return law.refusal();
    return MeasuredLaw(*law, run.low);
}

double MeasuredLaw::load_at(double theta) const {
    const double inside = std::clamp(theta, 0.0, law_->angles().high);
    const spring::LawPoint p = law_->at_angle(inside);
    return p.tau + (theta - inside) * (p.s + p.p);
}

MeasuredLaw::Asked MeasuredLaw::asked(const Answers& answers) const {
    const spring::FrictionLaw friction = spring::FrictionLaw::affine(answers.friction_constant, answers.friction);
    const codesign::Edges none{NAN, NAN};
    const auto least = codesign::find_edges(*law_, friction.resting_loads(answers.least_torque())).value_or(none);
    const auto most = codesign::find_edges(*law_, friction.resting_loads(answers.overdrive_torque())).value_or(none);
    return {{load_at(least.low), load_at(most.high)}, {first_angle_ + least.low, first_angle_ + most.high}};
}

core::Findings MeasuredLaw::missing(const Answers& answers) const {
    const Asked a = asked(answers);
    core::Findings findings;
    if (!(a.loads.low >= loads().low)) findings.push_back(not_reached(true, a.loads.low, a.angles.low, loads().low, angles().low));
    if (!(a.loads.high <= loads().high)) findings.push_back(not_reached(false, a.loads.high, a.angles.high, loads().high, angles().high));
    return findings;
}

}  // namespace fusee::search::init
