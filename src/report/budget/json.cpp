#include "budget/json.h"

#include "fusee/core/units.h"
#include "fusee/report/budget.h"

namespace fusee::report {

namespace {

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
