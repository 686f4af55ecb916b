#include "algorithm_1_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "curves.h"
#include "draft.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/search/design.h"
#include "fusee/spring/laws.h"

namespace fusee::search::codesign {

namespace {

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

}  // namespace

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

}  // namespace fusee::search::codesign
