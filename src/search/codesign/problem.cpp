#include "codesign/problem.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "draft.h"
#include "fusee/core/error.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"

// The searched numbers, and the effect of each on a design (docs/theory/co_design.md, table 1).
namespace fusee::search::codesign {

namespace {

constexpr int kDefaultLevels = 6;  // of co-contraction, where the profile names none

std::vector<double> levels(const profile::Rig& rig) {
    std::vector<double> torques;
    for (int i = 0; i < kDefaultLevels; ++i)
        torques.push_back(rig.least_torque + (rig.overdrive_torque - rig.least_torque) * i / (kDefaultLevels - 1));
    return torques;
}

void require_rising(const char* key, core::Range range, double unit) {
    if (!(range.low < range.high))
        throw core::InvalidInput(key, fmt::format("{:g}, {:g}", range.low / unit, range.high / unit), "the second above the first");
}

/// Ranges that are searched; two equal numbers fix the value.
void require_ordered(const char* key, core::Range range, double unit) {
    if (range.low > range.high)
        throw core::InvalidInput(key, fmt::format("{:g}, {:g}", range.low / unit, range.high / unit), "the second not below the first");
}

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

Problem::Problem(const profile::Profile& base) : base_(base) {
    pipeline::require_joint(base_, "co-design");
    pipeline::require_parts(base_);
    design::CoDesignOptions& o = base_.co_design;
    if (o.loads.high <= 0.0) o.loads = {base_.rig.least_torque, base_.rig.overdrive_torque};
    require_rising("co_design.loads_Nm", o.loads, 1.0);
    require_ordered("co_design.capstan_radius_mm", o.capstan_radius, 1e-3);
    require_ordered("co_design.lead_in_deg", o.lead_in, core::rad_from_deg(1.0));
    require_ordered("co_design.winding_rad", o.winding, 1.0);
    require_ordered("co_design.compression_mm", o.compression, 1e-3);
    if (o.torques.empty()) o.torques = levels(base_.rig);
    complete_demands();
    add_rig();
    add_spring(&profile::Profile::k_se, "K_SE", o.winding);
    add_spring(&profile::Profile::k_pe, "K_PE", o.compression);
    if (o.law == design::SearchedLaw::kStiction) {
        core::require_positive("rig.gear_friction", pipeline::gear_friction(base_).mu());
        add_stiction_law();
    } else {
        add_free_curve();
    }
}

void Problem::complete_demands() {
    design::CoDesignOptions& o = base_.co_design;
    if (o.travel > 0.0 && o.soft > 0.0 && o.stiff > 0.0) return;
    const auto own = pipeline::resolve(base_);
    if (!own)
        throw core::InvalidInput("co_design.travel_rad", "0, and soft_Nm_per_rad or stiff_Nm_per_rad too",
                                 fmt::format("values above 0: 0 takes them from the profile's own law, which cannot be made: {}",
                                             core::to_line(own.refusal().front())));
    const spring::LawPoint low = own->law()->at_load(o.loads.low), high = own->law()->at_load(o.loads.high);
    const double ratio = base_.rig.joint_radius / base_.rig.capstan_radius;
    if (o.travel <= 0.0) o.travel = high.theta - low.theta;
    if (o.soft <= 0.0) o.soft = 2.0 * ratio * ratio * low.s;
    if (o.stiff <= 0.0) o.stiff = 2.0 * ratio * ratio * high.s;
}

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

double rounded(double value, double numerator, double denominator) {
    // Multiplied and divided as the profile's reader does, so that the written text gives the same bits.
    return std::strtod(fmt::format("{:.6g}", value * denominator / numerator).c_str(), nullptr) * numerator / denominator;
}

profile::Profile finished(Draft draft) {
    profile::Profile p = std::move(draft.profile);
    p.law.start_torque = rounded(draft.start);
    p.law.end_torque = rounded(draft.end);
    if (draft.series_stiffness.empty()) {
        spring::StictionLawOptions law;
        law.mu = p.rig.rest_friction();
        law.start_torque = p.law.start_torque;
        law.end_torque = p.law.end_torque;
        // T(start) = u^2/(mu start^2) + C/start
        law.k = rounded(draft.k);
        law.u = rounded(std::sqrt(law.mu * draft.share_u * draft.transmission) * law.start_torque);
        law.c = rounded((1.0 - draft.share_u) * draft.transmission * law.start_torque);
        p.law.curves = law;
        return p;
    }
    spring::FreeCurveOptions law;
    const std::size_t knots = draft.series_stiffness.size();
    for (std::size_t i = 0; i < knots; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(knots - 1);
        law.loads.push_back(rounded(draft.start * std::pow(draft.end / draft.start, share)));
        law.series_stiffness.push_back(rounded(draft.series_stiffness[i]));
        law.transmission.push_back(rounded(draft.transmissions[i]));
    }
    p.law.curves = std::move(law);
    return p;
}

profile::Profile renamed(profile::Profile profile, const std::string& ending) {
    profile.name = profile::derived_name(profile.name, ending);
    return profile;
}

}  // namespace fusee::search::codesign
