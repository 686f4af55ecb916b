#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/figures.h"
#include "data/json.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/report/findings.h"
#include "fusee/report/search.h"
#include "fusee/spring/coil.h"
#include "init/cost.h"

namespace fusee::report {

namespace {

std::string family_line(const search::one_spring::Family& family) {
    if (!family.found()) {
        const std::string why = family.findings.empty() ? "no candidate is a part" : core::to_line(family.findings.front());
        return fmt::format("  {:10} cannot be made: {}\n", family.name, why);
    }
    const search::one_spring::Figures& f = family.figures;
    return fmt::format("  {:10} {:>13} {:>6.1f} {:>12.1f} {:>9} {:>7} {:>8} {:>8}\n", family.name,
                       fmt::format("{:.1f} x {:.1f}", core::mm_from_m(f.diameter), core::mm_from_m(f.height)), 1e6 * f.volume,
                       1e6 * f.spring_volume, fmt::format("+-{:.1f} %", 100.0 * f.built_error),
                       std::isnan(f.stress_share) ? "-" : fmt::format("{:.0f} %", 100.0 * f.stress_share),
                       std::isnan(f.fatigue_safety) ? "-" : fmt::format("{:.2f}", f.fatigue_safety),
                       std::isnan(f.guide_friction) ? "-" : fmt::format("{:.1f} %", 100.0 * f.guide_friction));
}

Json family_json(const search::one_spring::Family& family) {
    Json j{
        {"family", family.name}, {"found", family.found()}, {"judged", family.judged}, {"findings", findings_list_json(family.findings)}};
    if (!family.found()) return j;
    const search::one_spring::Figures& f = family.figures;
    j["diameter_mm"] = core::mm_from_m(f.diameter);
    j["height_mm"] = core::mm_from_m(f.height);
    j["volume_cm3"] = 1e6 * f.volume;
    j["spring_volume_cm3"] = 1e6 * f.spring_volume;
    j["torque_error_built_percent"] = 100.0 * f.built_error;
    j["spring_stress_percent"] = 100.0 * f.stress_share;
    j["spring_fatigue_safety"] = f.fatigue_safety;
    if (!std::isnan(f.guide_friction)) j["guide_friction_percent"] = 100.0 * f.guide_friction;
    if (!family.bought.empty()) j["spring"] = family.bought;
    return j;
}

/// What the smallest part costs in material; "" if none was found.
std::string cost_line(const std::vector<search::one_spring::Family>& families) {
    const search::one_spring::Family* best = search::one_spring::smallest(families);
    if (best == nullptr) return "";
    const profile::Profile& p = *best->profile;
    const spring::BaseSpring& s = p.part(p.part_kinds().front()).spring;
    const checks::Material material = checks::material_of(p.process);
    std::string spring = "a spring of the catalogue";
    if (best->bought.empty()) {
        const double wire = spring::wire_length(s);
        spring = fmt::format("{} of {:.2g} m of wire, {:.0f} g", p.has_two_cables() ? "each of two springs" : "a spring", wire,
                             1e3 * spring::wire_mass(s, wire));
    }
    return fmt::format("  cost of the {} in material: {}, {}; {}\n    {}\n", best->name, material.name,
                       solid_amount(1e9 * best->figures.volume, material), spring, kNoPrices);
}

}  // namespace

std::string families_text(const std::string& name, const std::vector<search::one_spring::Family>& families) {
    const bool bought = std::any_of(families.begin(), families.end(), [](const auto& family) { return !family.bought.empty(); });
    std::string text =
        fmt::format("{}: the smallest part of each family with a spring {}\n  {:10} {:>13} {:>6} {:>12} {:>9} {:>7} {:>8} {:>8}\n", name,
                    bought ? "of the catalogue" : "that can be wound", "family", "part [mm]", "[cm3]", "spring [cm3]", "as built", "stress",
                    "fatigue", "friction");
    for (const search::one_spring::Family& family : families) text += family_line(family);
    for (const search::one_spring::Family& family : families)
        if (!family.bought.empty()) text += fmt::format("  {}: spring {}\n", family.name, core::printable(family.bought));
    return text + cost_line(families);
}

std::string families_json(const std::vector<search::one_spring::Family>& families) { return json_text(json_list(families, &family_json)); }

}  // namespace fusee::report
