#pragma once
#include <functional>
#include <ostream>
#include <vector>

#include "checks/fixture.h"

/// Parts that break one rule each, with the value computed by hand: the table of known_bad_test.cpp.
namespace fusee::checks {

struct Case {
    const char* rule;
    const char* name;
    Fixture (*twin)();                    ///< passes every rule
    std::function<void(Fixture&)> spoil;  ///< makes the bad part of it
    core::Severity severity;
    double measured, allowed;
    double tolerance = 1e-6;             ///< absolute: digits of the hand calculation; larger where the contour is sampled
    std::vector<const char*> also = {};  ///< other rules that are broken too; every rule has a case without
};
inline void PrintTo(const Case& c, std::ostream* out) { *out << c.rule << ' ' << c.name; }

std::vector<Case> cable_cases();
std::vector<Case> groove_cases();
std::vector<Case> spring_cases();
std::vector<Case> structure_cases();
std::vector<Case> roller_cases();
std::vector<Case> shaft_cases();
std::vector<Case> process_cases();
std::vector<Case> machine_cases();
std::vector<Case> assembly_cases();

inline std::vector<Case> all_cases() {
    std::vector<Case> all;
    for (const auto cases : {cable_cases, groove_cases, spring_cases, structure_cases, shaft_cases, roller_cases, process_cases,
                             machine_cases, assembly_cases})
        for (Case& c : cases()) all.push_back(std::move(c));
    return all;
}

inline Fixture bad(const Case& c) {
    Fixture b = c.twin();
    c.spoil(b);
    return b;
}

inline constexpr core::Severity kRequired = core::Severity::kError, kReview = core::Severity::kWarning;

inline void without_hole(Fixture& b) { b.part.options.features.anchor_hole_diameter = 0.0; }
inline void without_slot(Fixture& b) { b.part.options.features.leg_slot_width = 0.0; }
/// Cables with the same fleet angle to both sides.
inline void lean(Fixture& b, double fleet_deg) {
    b.part.cam.working[7].fleet = -core::rad_from_deg(fleet_deg);
    b.part.cam.working[8].fleet = core::rad_from_deg(fleet_deg);
}

}  // namespace fusee::checks
