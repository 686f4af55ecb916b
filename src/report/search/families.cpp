#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/figures.h"
#include "data/json.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
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
    return fmt::format("  {:10} {:>12} {:>6.1f} {:>12.1f} {:>9} {:>7} {:>7} {:>8}\n", family.name,
                       fmt::format("{:.1f} x {:.1f}", core::mm_from_m(f.diameter), core::mm_from_m(f.height)), 1e6 * f.volume,
                       1e6 * f.spring_volume, fmt::format("+-{:.1f} %", 100.0 * f.built_error),
                       std::isnan(f.stress_share) ? "-" : fmt::format("{:.0f} %", 100.0 * f.stress_share),
                       std::isnan(f.fatigue_safety) ? "-" : fmt::format("{:.2f}", f.fatigue_safety),
                       std::isnan(f.guide_friction) ? "-" : fmt::format("{:.1f} %", 100.0 * f.guide_friction));
}

/// Rate and preload have the units of their spring.
Json candidate_json(const search::one_spring::Family::Candidate& c, bool torsion) {
    return {{"room_cm3", 1e6 * c.room()},
            {"torque_error_built_percent", 100.0 * c.built_error},
            {"guide_friction_percent", std::isnan(c.guide_friction) ? Json() : Json(100.0 * c.guide_friction)},
            {torsion ? "rate_Nm_per_rad" : "rate_N_per_m", c.rate},
            {torsion ? "preload_rad" : "preload_mm", torsion ? c.preload : core::mm_from_m(c.preload)}};
}

/// A lever's value in the unit in which a person reads it, and that unit.
std::pair<double, const char*> shown(const std::string& what, double value) {
    if (what == "torque") return {value, "Nm"};
    return what == "range" ? std::pair{core::deg_from_rad(value), "deg"} : std::pair{core::mm_from_m(value), "mm"};
}

Json family_json(const search::one_spring::Family& family) {
    Json j{{"family", family.name}, {"found", family.found()}, {"judged", family.judged}, {"findings", findings_json(family.findings)}};
    for (const auto& [what, value, was] : family.levers) {
        const auto [now, unit] = shown(what, value);
        j["levers"].push_back({{"what", what}, {std::string("value_") + unit, now}, {std::string("was_") + unit, shown(what, was).first}});
    }
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
    for (const search::one_spring::Family::Candidate& c : family.front) j["front"].push_back(candidate_json(c, family.name == "spool"));
    if (family.changed)
        j["changed_law"] = {{"angle_rad", family.changed->angle},
                            {"wanted_Nm", family.changed->wanted},
                            {"now_Nm", family.changed->now},
                            {"mean_Nm", family.changed->mean},
                            {"greatest_Nm", family.changed->greatest}};
    return j;
}

/// Of each front its ends.
std::string fronts_text(const std::vector<search::one_spring::Family>& families) {
    std::string text;
    for (const search::one_spring::Family& family : families) {
        if (family.front.size() < 2) continue;
        const auto [least, most] = std::minmax_element(family.front.begin(), family.front.end(),
                                                       [](const auto& a, const auto& b) { return a.built_error < b.built_error; });
        const auto shown = [](const auto& c) {
            const std::string friction = std::isnan(c.guide_friction) ? "" : fmt::format(", friction {:.1f} %", 100.0 * c.guide_friction);
            return fmt::format("{:.1f} cm3 (+-{:.2f} %{})", 1e6 * c.room(), 100.0 * c.built_error, friction);
        };
        text += fmt::format("  {}: {} parts on the front, from {} to {}\n", family.name, family.front.size(), shown(family.front.front()),
                            shown(*least));
    }
    return text.empty() ? text : "room of part and spring against error as built and friction, springs not wound (front.csv):\n" + text;
}

/// The law of the smallest part beside the wanted one, if it was changed.
std::string changed_text(const std::vector<search::one_spring::Family>& families) {
    constexpr std::size_t kRows = 11;
    std::string text;
    for (const search::one_spring::Family& family : families) {
        if (!family.changed) continue;
        double largest = 0.0;
        for (const double torque : family.changed->wanted) largest = std::max(largest, std::abs(torque));
        text +=
            fmt::format("  {}: the law is changed by {:.2g} % of its largest torque (root mean square over the angle), at most {:.3g} Nm\n",
                        family.name, 100.0 * family.changed->mean / largest, family.changed->greatest);
    }
    const search::one_spring::Family* best = search::one_spring::smallest(families);
    if (best == nullptr || !best->changed) return text;
    const search::one_spring::Family::ChangedLaw& law = *best->changed;
    text += fmt::format("  the law of the {}, points of its profile:\n  {:>12} {:>12} {:>12} {:>12}\n", best->name, "angle [deg]",
                        "wanted [Nm]", "now [Nm]", "change [Nm]");
    for (std::size_t i = 0; i < kRows; ++i) {
        const std::size_t at = i * (law.angle.size() - 1) / (kRows - 1);
        text += fmt::format("  {:>12.1f} {:>12.4f} {:>12.4f} {:>12.4f}\n", core::deg_from_rad(law.angle[at]), law.wanted[at], law.now[at],
                            law.now[at] - law.wanted[at]);
    }
    return text;
}

/// What would have to change for a part, where there is none.
std::string possible_text(const std::vector<search::one_spring::Family>& families) {
    std::string text;
    for (const search::one_spring::Family& family : families) {
        if (family.levers.empty()) continue;
        text += fmt::format("each of these alone makes a part possible ({}), the smallest change first:\n", family.name);
        for (const auto& [what, value, was] : family.levers) {
            const double now = shown(what, value).first, before = shown(what, was).first;
            if (what == "torque")
                text +=
                    fmt::format("  a largest torque of {:.3g} Nm instead of {:.3g} Nm: the law times {:.3g}\n", now, before, now / before);
            if (what == "range") text += fmt::format("  a law up to {:.1f} deg instead of {:.1f} deg\n", now, before);
            if (what == "bed")
                text += fmt::format("  a bed of {:.0f} mm instead of {:.0f} mm (--bed, process.build_mm)\n", std::ceil(now), before);
        }
    }
    return text;
}

/// What `fusee make` will warn of: in whole lines of the smallest part, by rule of the others.
std::string warnings_text(const std::vector<search::one_spring::Family>& families) {
    std::string text;
    for (const search::one_spring::Family& family : families) {
        std::string rules, lines;
        for (const core::Finding& f : family.findings) {
            if (!family.found() || f.severity != core::Severity::kWarning) continue;
            rules += (rules.empty() ? "" : ", ") + f.rule;
            lines += fmt::format("    {}\n", core::to_line(f));
        }
        if (rules.empty()) continue;
        text += &family == search::one_spring::smallest(families) ? fmt::format("  {}, to review and accept:\n{}", family.name, lines)
                                                                  : fmt::format("  {}, to review and accept: {}\n", family.name, rules);
    }
    return text;
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

std::string families_text(const std::string& name, const std::vector<search::one_spring::Family>& families, bool may_repair) {
    const bool bought = std::any_of(families.begin(), families.end(), [](const auto& family) { return !family.bought.empty(); });
    std::string text =
        fmt::format("{}: the smallest part of each family with a spring {}\n  {:10} {:>12} {:>6} {:>12} {:>9} {:>7} {:>7} {:>8}\n", name,
                    bought ? "of the catalogue" : "that can be wound", "family", "part [mm]", "[cm3]", "spring [cm3]", "as built", "stress",
                    "fatigue", "friction");
    std::string said;  // why a family cannot be made, so that the same reason stands once
    for (const search::one_spring::Family& family : families) {
        const std::string why = family.found() || family.findings.empty() ? "" : family.findings.front().what;
        text += !why.empty() && why == said ? fmt::format("  {:10} cannot be made: as the one above\n", family.name) : family_line(family);
        said = why;
    }
    for (const search::one_spring::Family& family : families)
        if (!family.bought.empty()) text += fmt::format("  {}: spring {}\n", family.name, core::printable(family.bought));
    text += fronts_text(families) + changed_text(families) + warnings_text(families) + possible_text(families) + cost_line(families);
    const bool found = std::any_of(families.begin(), families.end(), [](const auto& family) { return family.found(); });
    return found || !may_repair ? text : text + "with --repair the nearest law that can be made is searched\n";
}

std::string fronts_csv(const std::vector<search::one_spring::Family>& families) {
    std::string text =
        "family,room_cm3,diameter_mm,height_mm,spring_cm3,torque_error_built_percent,guide_friction_percent,"
        "rate_N_per_m,preload_mm,rate_Nm_per_rad,preload_rad\n";
    for (const search::one_spring::Family& family : families) {
        for (const search::one_spring::Family::Candidate& c : family.front) {
            const bool torsion = family.name == "spool";
            text += fmt::format("{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{},{}\n", family.name, 1e6 * c.room(), core::mm_from_m(c.diameter),
                                core::mm_from_m(c.height), 1e6 * c.spring_volume, 100.0 * c.built_error,
                                std::isnan(c.guide_friction) ? "" : fmt::format("{:.4g}", 100.0 * c.guide_friction),
                                torsion ? fmt::format(",,{:.4g},{:.4g}", c.rate, c.preload)
                                        : fmt::format("{:.4g},{:.4g},,", c.rate, core::mm_from_m(c.preload)));
        }
    }
    return text;
}

std::string families_json(const std::vector<search::one_spring::Family>& families) { return json_text(json_list(families, &family_json)); }

}  // namespace fusee::report
