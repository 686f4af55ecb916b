#include <algorithm>
#include <cmath>

#include "fusee/report/report.h"

namespace fusee::report {

namespace {
// The ends of a law come out of a root search in the angle: loads agree to better than this share.
constexpr double kSameLoad = 1e-9;
}  // namespace

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

}  // namespace fusee::report
