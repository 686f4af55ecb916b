#include <fmt/format.h>

#include <cmath>

#include "codesign/problem.h"
#include "draft.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"

// The searched numbers, and the effect of each on a design (docs/theory/co_design.md, table 1).
namespace fusee::search::codesign {

namespace {

constexpr double kMilli = 1e3;                   // mm in a metre
constexpr core::Range kStartShare{0.6, 1.0};     // of the least load that stiction allows
constexpr core::Range kEndShare{1.0, 1.15};      // of the greatest: the edges of a dead-band lie beyond it
constexpr core::Range kBuiltEndShare{1.0, 1.4};  // edges of built joints lie even farther out
constexpr core::Range kStartTransmission{0.02, 0.98}, kUShare{0.0, 1.0};
constexpr core::Range kLogit{-5.0, 3.0};  // T of the free curve: 0.7 % to 95 %

double natural(double logarithm) { return std::exp(logarithm); }
double logistic(double logit) { return 1.0 / (1.0 + std::exp(-logit)); }
core::Range logarithm(double middle, double span) { return {std::log(middle / span), std::log(middle * span)}; }

/// S/tau^2 of a profile's own law at the middle of its loads: the scale of the searched stiffness.
double own_k(const profile::Profile& p) {
    if (const auto* law = std::get_if<spring::StictionLawOptions>(&p.law.curves)) return law->k;
    const auto own = pipeline::resolve(p);
    if (!own) return p.co_design.stiff / (2.0 * std::pow(p.rig.overdrive_torque, 2));
    const core::Range loads = own->law()->loads();
    const double middle = std::sqrt(loads.low * loads.high);
    return own->law()->at_load(middle).s / (middle * middle);
}

/// Another base spring: the figures of the profile's wire are not valid for it, nor the rating of that wire.
void set_rate(spring::BaseSpring& spring, double rate) {
    spring.rate = rate;
    if (spring.wire_diameter > 0.0) spring.max_state = spring.max_load = 0.0;
    spring.wire_diameter = spring.coil_diameter = spring.active_coils = spring.free_length = spring.tensile_strength = 0.0;
}

}  // namespace

void Problem::add(std::string name, std::string unit, core::Range bounds, std::function<void(Draft&, double)> set,
                  double (*shown)(double)) {
    variables_.push_back({std::move(name), std::move(unit), bounds, std::move(set), shown});
}

Problem::Shown Problem::show(std::size_t i, double x) const {
    const Variable<Draft>& v = variables_[i];
    return {v.name, v.unit, {v.shown(v.bounds.low), v.shown(v.bounds.high)}, v.shown(x)};
}

void Problem::add_rig() {
    const core::Range radius = options().capstan_radius;
    const double ratio = base_.rig.joint_radius / base_.rig.capstan_radius;
    if (radius.high > 0.0)
        add("r_c", "m", radius, [ratio](Draft& d, double x) {
            d.profile.rig.capstan_radius = rounded(x, 1.0, kMilli);
            d.profile.rig.joint_radius = rounded(ratio * d.profile.rig.capstan_radius, 1.0, kMilli);
        });
    const spring::FrictionLaw friction = pipeline::gear_friction(base_);
    const double least = friction.resting_loads(base_.rig.least_torque).low;
    const double greatest = friction.resting_loads(base_.rig.overdrive_torque).high;
    add("start", "Nm", {kStartShare.low * least, kStartShare.high * least}, [](Draft& d, double x) { d.start = x; });
    const core::Range end = options().figure == design::DeadBandFigure::kPercentile95 ? kBuiltEndShare : kEndShare;
    add("end", "Nm", {end.low * greatest, end.high * greatest}, [](Draft& d, double x) { d.end = x; });
    add("lead-in", "rad", options().lead_in, [](Draft& d, double x) { d.profile.law.lead_in_travel = rounded(x, core::kPi, 180.0); });
}

void Problem::add_spring(profile::PartSpec profile::Profile::*part, const std::string& name, core::Range preload) {
    const spring::BaseSpring& own = (base_.*part).spring;
    const bool torsion = own.kind == spring::BaseKind::kTorsion;
    const auto& rows = options().catalogue.of(own.kind);
    if (rows.empty()) {
        add(
            "rate of " + name, torsion ? "Nm/rad" : "N/m", logarithm(own.rate, options().span),
            [part](Draft& d, double x) { set_rate((d.profile.*part).spring, rounded(std::exp(x))); }, natural);
    } else {
        add("row of " + name, "", {0.0, static_cast<double>(rows.size())}, [part, &rows](Draft& d, double x) {
            const auto row = std::min(rows.size() - 1, static_cast<std::size_t>(std::max(0.0, x)));
            (d.profile.*part).spring = rows[row].spring;
        });
    }
    add("preload of " + name, torsion ? "rad" : "m", preload,
        [part, torsion](Draft& d, double x) { (d.profile.*part).spring.preload = torsion ? rounded(x) : rounded(x, 1.0, kMilli); });
}

void Problem::add_stiction_law() {
    add(
        "k", "1/(Nm rad)", logarithm(own_k(base_), options().span), [](Draft& d, double x) { d.k = std::exp(x); }, natural);
    add("T at the start", "", kStartTransmission, [](Draft& d, double x) { d.transmission = x; });
    add("share of u in it", "", kUShare, [](Draft& d, double x) { d.share_u = x; });
}

void Problem::add_free_curve() {
    const auto knots = static_cast<std::size_t>(options().knots);
    const core::Range k = logarithm(own_k(base_), options().span * options().span);
    for (std::size_t i = 0; i < knots; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(knots - 1);
        add(
            fmt::format("S/tau^2 at knot {}", i + 1), "1/(Nm rad)", k,
            [share](Draft& d, double x) {
                const double load = d.start * std::pow(d.end / d.start, share);
                d.series_stiffness.push_back(std::exp(x) * load * load);
            },
            natural);
        add(
            fmt::format("T at knot {}", i + 1), "", kLogit, [](Draft& d, double x) { d.transmissions.push_back(logistic(x)); }, logistic);
    }
}

profile::Profile Problem::candidate(std::span<const double> x) const {
    return finished(entered(Draft{base_, 0.0, 0.0, 0.0, 0.0, 0.0, {}, {}}, variables_, x));
}

}  // namespace fusee::search::codesign
