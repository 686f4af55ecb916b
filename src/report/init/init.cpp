#include "fusee/report/init.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::report {

namespace {

using core::mm_from_m;

/// A word for the shell, quoted only where it must be.
std::string word(const std::string& text) {
    const auto plain = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-' || c == '/'); };
    return !text.empty() && text[0] != '-' && std::all_of(text.begin(), text.end(), plain) ? text : core::shell_word(text);
}

std::string coil_line(const char* part, const char* kind, const spring::BaseSpring& s) {
    return fmt::format("  {}: {} spring, wire {:g} mm, mean coil {:g} mm, {:g} turns, length {:g} mm\n", part, kind,
                       mm_from_m(s.wire_diameter), mm_from_m(s.coil_diameter), s.active_coils, mm_from_m(s.free_length));
}

std::string dead_band_range_text(const pipeline::ResolvedDesign& design, double tau) {
    return fmt::format("{:.1f} deg at {:g} Nm", core::deg_from_rad(actuator::dead_band(design.actuator, tau).exact_width), tau);
}

/// Radius that each cam sweeps, and the torque that the joint bears from outside.
std::string size_text(const pipeline::ResolvedDesign& design) {
    std::string text = "  largest radius of the cable on";
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const auto made = pipeline::design_cam(kind, design);
        if (!made) return "";
        double largest = 0.0;
        for (const cam::Contact& c : made->working) largest = std::max(largest, std::hypot(c.path.x(), c.path.y()));
        text += fmt::format("{} {} {:.3g} mm", kind == cam::PartKind::kSeries ? "" : ",", to_string(kind), mm_from_m(largest));
    }
    const double torque = pipeline::simulate(design, {.levels = 2}).survey.torque;
    return text + fmt::format("\n  greatest torque from outside within the laws of the springs: {:.3g} Nm\n", torque);
}

std::string figures(const search::init::Design& found) {
    const profile::Profile& p = found.profile;
    const auto design = pipeline::resolve(p);
    std::string text;
    if (design)
        text += fmt::format("  dead-band, full width at the joint: {}, {}, {}\n", dead_band_range_text(*design, p.rig.least_torque),
                            dead_band_range_text(*design, p.rig.peak_torque), dead_band_range_text(*design, p.rig.overdrive_torque));
    if (design) text += size_text(*design);
    text += fmt::format("  radius of capstan {:.4g} mm, of the joint's pulley {:.4g} mm\n", mm_from_m(p.rig.capstan_radius),
                        mm_from_m(p.rig.joint_radius));
    text += coil_line("K_SE", "torsion", p.k_se.spring) + coil_line("K_PE", "compression", p.k_pe.spring);
    if (p.k_se.solid.features.leg_slot_width <= 0.0)
        text +=
            "  K_SE has no slot for its spring's leg, since the coil is narrower than bore and wall: put the spring on a shaft of its "
            "own,\n"
            "  or choose a thinner --shaft\n";
    return text;
}

std::string open_findings(const core::Findings& findings) {
    std::string text = fmt::format("  {} to review, {} not judged; fusee make lists them\n",
                                   core::counted(core::count(findings, core::Severity::kWarning), "warning"),
                                   core::counted(core::count(findings, core::Severity::kNotJudged), "rule"));
    return text;
}

std::string nearest_text(const search::init::Result& result, const std::string& file, const std::string& more) {
    if (!result.nearest) return "no change of a single answer was found that gives a joint; nothing is written\n";
    const search::init::NearestChange& n = *result.nearest;
    return fmt::format("nearest joint that can be made: {} {} instead of {}\n  fusee init {} {}{}\nnothing is written\n", n.answer.key,
                       word(n.answer.value), word(n.answer.was), word(file), n.options, more);
}

}  // namespace

std::string init_summary(const search::init::Design& found) {
    return "this joint can be made:\n" + figures(found) + open_findings(found.findings);
}

std::string init_text(const search::init::Result& result, const std::string& file, const std::string& more) {
    if (!result.design) {
        std::string text = "this joint cannot be made; the limits that bind:\n";
        for (std::size_t i = 0; i < std::min<std::size_t>(3, result.binding.size()); ++i)
            text += "  " + core::to_line(result.binding[i]) + "\n";
        return text + nearest_text(result, file, more);
    }
    return fmt::format("written: {}\n{}{}next:\n  fusee make {}\n  fusee watch {}\n", core::printable(file), figures(*result.design),
                       open_findings(result.design->findings), word(file), word(file));
}

}  // namespace fusee::report
