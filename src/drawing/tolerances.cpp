#include "tolerances.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "view.h"

namespace fusee::drawing {

namespace {

constexpr double kMostEdge = 0.3e-3, kEdgeOfRib = 0.25;  // the lips beside the cable stay as high as drawn

/// Permissible deviations of ISO 2768-1 [m]: sizes of 0.5 to 3 mm and of 3 to 6 mm; those of larger sizes are wider.
struct Class {
    char letter;
    double to_3, to_6;
};
constexpr std::array kClasses{Class{'f', 0.05e-3, 0.05e-3}, Class{'m', 0.1e-3, 0.1e-3}, Class{'c', 0.2e-3, 0.3e-3},
                              Class{'v', 0.0, 0.5e-3}};

/// The finest class that the process keeps; sizes that it does not keep are stated.
std::string general_class(double process) {
    const double kept = process * (1.0 - 1e-9);
    const auto found = std::find_if(kClasses.begin(), kClasses.end(), [kept](const Class& c) { return c.to_6 >= kept; });
    const std::string own = fmt::format("\u00b1{}", decimals(core::mm_from_m(process)));
    if (found == kClasses.end()) return own;
    return fmt::format("ISO 2768-1 {}{}", found->letter, found->to_3 >= kept ? "" : "; to 3 mm " + own);
}

const char* datum_b_of(solid::HubLock lock) {
    switch (lock) {
        case solid::HubLock::kKeyway:
            return "middle of the keyway";
        case solid::HubLock::kDFlat:
            return "flat of the bore";
        case solid::HubLock::kSetScrew:
            return "axis of the set screw";
        case solid::HubLock::kPlain:
            return "timing mark";
    }
    return "";
}

}  // namespace

Tolerances tolerances_of(const Subject& subject) {
    const checks::ProcessLimits limits = checks::process_limits(subject.process);
    Tolerances t;
    t.process = limits.tolerance;
    t.contour = t.position = t.runout = 2.0 * limits.tolerance;
    t.face = limits.tolerance;
    t.edge = std::min(kMostEdge, kEdgeOfRib * subject.part.options.groove.rib);
    t.roughness = limits.roughness;
    t.fine_roughness = limits.fine_roughness;
    t.removal = !checks::is_printed(subject.process);
    t.general = general_class(limits.tolerance);
    t.datum_b = datum_b_of(subject.part.options.hub.lock);
    t.mark_is_b = subject.part.options.hub.lock == solid::HubLock::kPlain;
    return t;
}

Badge roughness_badge(const Tolerances& tolerances, double value) {
    return {tolerances.removal ? Symbol::kRoughnessCut : Symbol::kRoughness, {fmt::format("Ra {}", decimals(1e6 * value))}};
}

}  // namespace fusee::drawing
