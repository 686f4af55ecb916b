#include "both_ways.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/spring/law.h"

namespace fusee::pipeline {

namespace {

constexpr double kAllowed = 1e-3;  // of the largest torque, as readback.arm allows of an arm

/// Torques of one cable by the arms of a file [Nm], by rising cam angle.
std::vector<double> torques_by(const PartReport& part, const readback::ArmError& reading, const cam::Allowance& allowance) {
    std::vector<double> all;
    for (std::size_t i = 0; i < reading.arms_mm.size(); ++i)
        all.push_back(part.part->cam.working[i].arm.tension * (core::m_from_mm(reading.arms_mm[i]) + allowance.on_arms()));
    return all;
}

/// The law's torque by one reading of each part; both have as many rows, evenly over the same travel.
std::vector<double> difference(const DesignReport& report, const ResolvedDesign& design, const readback::ArmError& forth,
                               const readback::ArmError& back) {
    std::vector<double> found = torques_by(report.parts[0], forth, design.ways[0].profile.k_pe.allowance);
    const std::vector<double> against = torques_by(report.parts[1], back, design.ways[1].profile.k_pe.allowance);
    for (std::size_t i = 0; i < found.size(); ++i) found[i] -= against[against.size() - 1 - i];
    return found;
}

core::Finding judge(const TorqueOfBoth& of, const std::vector<double>& found, const readback::ArmError& forth,
                    const readback::ArmError& back) {
    double largest = 0.0, worst = 0.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < of.wanted.size(); ++i) {
        largest = std::max(largest, std::abs(of.wanted[i]));
        const double error = std::abs(found[i] - of.wanted[i]);
        if (!(error <= worst)) worst = error, at = i;  // NaN is the worst
    }
    core::Finding f;
    f.rule = "readback.torque";
    f.what = fmt::format("the difference of both cables' torques, recomputed from {} and {} (read by {}), must be the law's", forth.file,
                         back.file, forth.reader);
    f.measured = 100.0 * worst / largest;
    f.bound = core::Bound::kAtMost;
    f.allowed = 100.0 * kAllowed;
    f.unit = "%";
    f.where =
        fmt::format("law at {:.1f} deg, of the largest torque, worst of {} angles", core::deg_from_rad(of.angle[at]), of.angle.size());
    f.suggestion = "a smaller tolerances.chordal_error_mm, or a smaller cam.least_torque_Nm";
    f.source = "docs/part-file.md: arms and tensions of both parts";
    return core::judged(std::move(f), forth.when_broken);
}

}  // namespace

core::Range law_angles(const ResolvedDesign& design) {
    const double first = std::get<profile::OneSpring>(design.profile.law.curves).first_angle();
    return {first, first + design.law()->angles().width()};
}

void judge_both_ways(DesignReport& report, const ResolvedDesign& design) {
    TorqueOfBoth of;
    for (const cam::Contact& c : report.parts[0].part->cam.working) {
        of.angle.push_back(law_angles(design).low + c.arm.angle);
        of.wanted.push_back(design.law()->at_angle(c.arm.angle).tau);
        of.forth.push_back(design.ways[0].law()->at_angle(c.arm.angle).tau);
        of.back.push_back(design.ways[1].law()->at_angle(law_angles(design).width() - c.arm.angle).tau);
    }
    for (const readback::ArmError& forth : report.parts[0].arm_errors) {
        const std::string ending = forth.file.substr(report.parts[0].name.size());
        for (const readback::ArmError& back : report.parts[1].arm_errors) {
            if (back.file != report.parts[1].name + ending || back.reader != forth.reader) continue;
            const std::vector<double> found = difference(report, design, forth, back);
            report.findings.push_back(judge(of, found, forth, back));
            if (of.found.empty()) of.found = found;
        }
    }
    report.of_both = std::move(of);
}

}  // namespace fusee::pipeline
