#include "fusee/pipeline/budget.h"

#include <fmt/format.h>

#include <cmath>

#include "data/figures.h"
#include "design/parts.h"
#include "fusee/core/units.h"
#include "fusee/report/budget.h"

namespace fusee::report {

namespace {

using design::budget::Budget, design::budget::PartBudget, design::budget::Source, design::budget::TorqueError, design::budget::WidthBudget;

std::string percent_band(const core::Range& band) { return fmt::format("{:+.1f} to {:+.1f} %", 100.0 * band.low, 100.0 * band.high); }
std::string degree_band(const core::Range& band) {
    return fmt::format("{:.1f} to {:.1f} deg", core::deg_from_rad(band.low), core::deg_from_rad(band.high));
}
double half_band(double sigma) { return design::budget::kPercentile * sigma; }

/// "mill, edm"; "none"
std::string names(const std::vector<std::string>& all) { return all.empty() ? "none" : fmt::format("{}", fmt::join(all, ", ")); }

std::string part_text(const PartBudget& part, int draws, double wanted) {
    const TorqueError& worst = part.worst();
    std::string text = fmt::format("\n{}: torque {}", part.name, percent_band(worst.band));
    if (draws > 0) text += fmt::format(" (sampled {})", percent_band(worst.sampled));
    text += fmt::format(" at {:.1f} deg of travel, {:.3g} Nm\n    {:10} {:>10} {:>14} {:>18} {:>12}\n", core::deg_from_rad(worst.travel),
                        worst.torque, "source", "limit", "torque", fmt::format("+-{:g} %: alone", 100.0 * wanted), "shared");
    double contour = 0.0;
    for (const design::budget::Needed& n : tolerances_for_torque(part, wanted)) {
        if (n.source == Source::kContour) contour = n.shared;
        text += fmt::format("    {:10} {:>10} {:>14} {:>18} {:>12}\n", to_string(n.source), limit_text(part, n.source, n.stated),
                            fmt::format("+-{:.2f} %", 100.0 * half_band(worst.sigma[static_cast<std::size_t>(n.source)])),
                            limit_text(part, n.source, n.alone), limit_text(part, n.source, n.shared));
    }
    return text + fmt::format("    processes that hold a contour of {}: {}\n", limit_text(part, Source::kContour, contour),
                              names(pipeline::processes_within(contour)));
}

std::string width_text(const WidthBudget& width, int draws) {
    if (std::isnan(width.nominal)) return fmt::format("\ndead-band at {:g} Nm: the springs do not cover it\n", width.tau);
    std::string text = fmt::format("\ndead-band at {:g} Nm: {:.1f} deg as designed, {} as built", width.tau,
                                   core::deg_from_rad(width.nominal), degree_band(width.band));
    if (draws > 0) text += fmt::format(" (sampled {})", degree_band(width.sampled));
    text += "\n   ";
    for (std::size_t i = 0; i < design::budget::kSources; ++i)
        if (width.sigma[i] > 0.0)
            text += fmt::format(" {} +-{:.1f}", to_string(static_cast<Source>(i)), core::deg_from_rad(half_band(width.sigma[i])));
    return text + " deg\n";
}

using design::budget::Budget, design::budget::PartBudget, design::budget::Source;

Json sources_json(const std::array<double, design::budget::kSources>& values, double scale) {
    Json j = Json::object();
    for (std::size_t i = 0; i < values.size(); ++i) j[to_string(static_cast<Source>(i))] = scale * values[i];
    return j;
}

/// The limit of each source in words; null where the source does not reach this part.
Json limits_json(const PartBudget& part) {
    Json limits = Json::object();
    for (std::size_t i = 0; i < design::budget::kSources; ++i) {
        const auto source = static_cast<Source>(i);
        const bool reaches = source != Source::kFriction || part.name == "k_pe";
        limits[to_string(source)] = reaches ? Json(limit_text(part, source, part.limits[i])) : Json();
    }
    return limits;
}

Json part_json(const PartBudget& part) {
    return {{"part", part.name},
            {"limits", limits_json(part)},
            {"worst_place", &part.worst() - part.places.data()},
            {"places", json_list(part.places, [](const design::budget::TorqueError& place) {
                 return Json{{"travel_deg", core::deg_from_rad(place.travel)},
                             {"torque_Nm", place.torque},
                             {"sigma_percent", sources_json(place.sigma, 100.0)},
                             {"band_percent", {100.0 * place.band.low, 100.0 * place.band.high}},
                             {"sampled_percent", {100.0 * place.sampled.low, 100.0 * place.sampled.high}}};
             })}};
}

}  // namespace

std::string limit_text(const PartBudget& part, Source source, double limit) {
    const auto in = [&](double value, const char* unit) { return fmt::format("{:.3g} {}", value, unit); };
    switch (source) {
        case Source::kContour:
        case Source::kRunout:
            return in(core::mm_from_m(limit), "mm");
        case Source::kGuide:
            return part.parallel ? in(core::deg_from_rad(limit), "deg") : in(core::mm_from_m(limit), "mm");
        case Source::kZero:
            return in(core::deg_from_rad(limit), "deg");
        case Source::kRate:
        case Source::kPreload:
        case Source::kCable:
        case Source::kFriction:
            return in(100.0 * limit, "%");
    }
    return "";
}

std::string budget_text(const BudgetTitle& title, const Budget& budget, double wanted) {
    const bool joint = budget.parts.size() > 1;
    std::string text = fmt::format("{} by {}: 5 to 95 % of {}, first order{}\n", title.name, title.process,
                                   joint ? "joints as built" : "springs as built, in shares of the largest torque",
                                   budget.draws > 0 ? fmt::format(" and {} sampled joints", budget.draws) : "");
    for (const PartBudget& part : budget.parts) text += part_text(part, budget.draws, wanted);
    for (const WidthBudget& width : budget.widths) text += width_text(width, budget.draws);
    return text + "\nNot counted: friction of the cable, elasticity of the frame, shrinkage that a coupon would show.\n";
}

Json budget_to_json(const Budget& budget) {
    const auto degrees = [](const core::Range& r) { return Json{core::deg_from_rad(r.low), core::deg_from_rad(r.high)}; };
    return {{"draws", budget.draws},
            {"percentile", design::budget::kPercentile},
            {"parts", json_list(budget.parts, &part_json)},
            {"dead_bands", json_list(budget.widths, [&](const design::budget::WidthBudget& width) {
                 return Json{{"tau_Nm", width.tau},
                             {"nominal_deg", core::deg_from_rad(width.nominal)},
                             {"sigma_deg", sources_json(width.sigma, core::deg_from_rad(1.0))},
                             {"band_deg", degrees(width.band)},
                             {"sampled_deg", degrees(width.sampled)}};
             })}};
}

std::string budget_json(const BudgetTitle& title, const Budget& budget, double wanted) {
    Json j = budget_to_json(budget);
    j["name"] = title.name;
    j["process"] = title.process;
    j["wanted_percent"] = 100.0 * wanted;
    for (std::size_t i = 0; i < budget.parts.size(); ++i)
        j["parts"][i]["tolerances"] = json_list(tolerances_for_torque(budget.parts[i], wanted), [&](const design::budget::Needed& n) {
            const auto text = [&](double limit) { return limit_text(budget.parts[i], n.source, limit); };
            return Json{{"source", to_string(n.source)}, {"stated", text(n.stated)}, {"alone", text(n.alone)}, {"shared", text(n.shared)}};
        });
    return json_text(std::move(j));
}

}  // namespace fusee::report
