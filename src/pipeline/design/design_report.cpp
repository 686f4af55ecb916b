#include "fusee/pipeline/design_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fusee/assembly/assembly.h"
#include "fusee/assembly/rule.h"
#include "fusee/pipeline/export.h"

namespace fusee::pipeline {

namespace {

// The ends of a law come from a root search in the angle; their loads agree to better than this share.
constexpr double kSameLoad = 1e-9;

Misfit misfit_of_rows(const std::vector<TableRow>& rows, double TableRow::*smooth, double TableRow::*measured) {
    std::vector<double> differences;
    for (const TableRow& row : rows) differences.push_back(row.*smooth - row.*measured);
    return misfit_of(differences);
}

}  // namespace

Misfit SmoothedTable::series() const { return misfit_of_rows(rows, &TableRow::series_smooth, &TableRow::series); }
Misfit SmoothedTable::parallel() const { return misfit_of_rows(rows, &TableRow::parallel_smooth, &TableRow::parallel); }

bool LawReport::covers_stiction() const {
    if (samples.empty()) return false;
    return samples.front().tau <= stiction_loads.low * (1.0 + kSameLoad) && samples.back().tau >= stiction_loads.high * (1.0 - kSameLoad);
}

std::vector<const PartReport*> DesignReport::sides() const {
    std::vector<const PartReport*> all;
    for (const auto* list : {&parts, &mirrored})
        for (const PartReport& part : *list) all.push_back(&part);
    return all;
}

std::vector<const readback::ArmError*> DesignReport::arm_errors() const {
    std::vector<const readback::ArmError*> all;
    for (const PartReport* part : sides())
        for (const readback::ArmError& error : part->arm_errors) all.push_back(&error);
    for (const readback::ArmError& error : plate_errors) all.push_back(&error);
    return all;
}

core::Findings DesignReport::all_findings() const {
    core::Findings all = findings;
    for (const PartReport* part : sides()) core::append(all, part->findings);
    return all;
}

double DesignReport::worst_arm_error() const {
    double worst = std::numeric_limits<double>::quiet_NaN();
    for (const readback::ArmError* error : arm_errors())
        if (error->when_broken == core::Severity::kError) worst = std::fmax(worst, error->worst_relative);
    return worst;
}

core::Severity verdict(const DesignReport& design) {
    core::Severity worst = core::Severity::kPass;
    for (const core::Finding& finding : design.all_findings()) worst = std::max(worst, finding.severity);
    for (const readback::ArmError* error : design.arm_errors())
        if (!error->passed()) worst = std::max(worst, error->when_broken);
    return worst;
}

double AsExported::worst_change() const {
    double worst = std::numeric_limits<double>::quiet_NaN();
    for (const JointAsExported& joint : joints)
        for (std::size_t i = 0; joint.binding && i < torques.size(); ++i) {
            if (std::isnan(nominal[i])) continue;  // the law as designed ends earlier, too
            const double change = std::abs(joint.dead_band[i] / nominal[i] - 1.0);
            if (std::isnan(change)) return change;
            worst = std::fmax(worst, change);
        }
    return worst;
}

Assembled assemble(const ResolvedDesign& design, std::shared_ptr<const solid::Part> k_se, std::shared_ptr<const solid::Part> k_pe) {
    const profile::Profile& profile = design.profile;
    auto made =
        assembly::assemble({std::move(k_se), std::move(k_pe), profile.k_se.spring, profile.k_pe.spring, profile.cable, profile.process},
                           profile.rig.capstan_radius, profile.rig.joint_radius, profile.assembly);
    if (!made) return {nullptr, made.refusal()};
    const auto joint = std::make_shared<const assembly::Assembly>(std::move(made).value());
    return {joint, assembly::check(*joint, profile.limits)};
}

Pair pair_of(DesignedPart agonist, bool both) {
    Pair pair{std::make_shared<const DesignedPart>(std::move(agonist)), nullptr};
    if (both) pair.antagonist = std::make_shared<const DesignedPart>(DesignedPart{solid::mirrored(pair.agonist->part), {}});
    return pair;
}

spring::BaseSpring mirrored(spring::BaseSpring spring) {
    if (spring.hand != spring::Hand::kUnknown)
        spring.hand = spring.hand == spring::Hand::kRight ? spring::Hand::kLeft : spring::Hand::kRight;
    return spring;
}

}  // namespace fusee::pipeline
