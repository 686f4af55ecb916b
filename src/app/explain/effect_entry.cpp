#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "explain/entry.h"
#include "fusee/core/lists.h"
#include "fusee/search/redesign.h"

namespace fusee::app {

namespace {

std::vector<std::string> names(const std::vector<effects::Experiment>& experiments) {
    return core::each<std::string>(experiments, [&](const effects::Experiment experiment) { return to_string(experiment); });
}

/// The experiments that change by one of two effects alone.
std::vector<std::string> telling(const effects::Effect& one, const effects::Effect& other) {
    std::vector<effects::Experiment> alone;
    for (const effects::Experiment experiment : gap_case::kAllExperiments) {
        const auto sees = [experiment](const effects::Effect& effect) {
            return std::find(effect.seen_by.begin(), effect.seen_by.end(), experiment) != effect.seen_by.end();
        };
        if (sees(one) != sees(other)) alone.push_back(experiment);
    }
    return names(alone);
}

Json parameters_json(const effects::Effect& effect) {
    Json all = Json::array();
    for (const effects::EffectParameter& p : effect.parameters)
        all.push_back({{"name", p.name}, {"unit", p.unit}, {"usual", p.scale}, {"allowed", {p.allowed.low, p.allowed.high}}});
    return all;
}

}  // namespace

Entry effect_entry(const effects::Effect& effect) {
    std::vector<std::string> keys;  // a generic term has none
    if (effects::effect_or_none(effect.id) != nullptr) keys = search::redesign::keys_of_effect(effect.id);
    Entry entry{"effect", effect.id, {}, {}};
    entry.json = {{"kind", "effect"},
                  {"name", effect.id},
                  {"law", effect.law},
                  {"meaning", effect.meaning},
                  {"sided", effect.sided},
                  {"parameters", parameters_json(effect)},
                  {"seen_by", names(effect.seen_by)},
                  {"distinguished_by", Json::object()},
                  {"advice", effect.advice},
                  {"keys", keys}};
    entry.lines = {{"law", effect.law}, {"on a rig", effect.meaning}};
    entry.lines.emplace_back("acts on", effect.sided ? "agonist, antagonist or both" : "the whole joint");
    for (const effects::EffectParameter& p : effect.parameters)
        entry.lines.emplace_back("parameter", fmt::format("{} [{}], usual size {:g}, allowed {:g} to {:g}", p.name, p.unit, p.scale,
                                                          p.allowed.low, p.allowed.high));
    entry.lines.emplace_back("seen by", fmt::format("{}", fmt::join(names(effect.seen_by), ", ")));
    for (const std::string& id : effect.confused_with) {
        const effects::Effect* other = effects::effect_or_none(id);
        if (other == nullptr) continue;
        const std::vector<std::string> by = telling(effect, *other);
        entry.json["distinguished_by"][id] = by;
        entry.lines.emplace_back("distinguished from " + id,
                                 by.empty() ? "by the size in each experiment; fusee diagnose names the next experiment"
                                            : fmt::format("by {}", fmt::join(by, ", ")));
    }
    if (!keys.empty())
        entry.lines.emplace_back("profile key", fmt::format("{}; fusee diagnose --write-profile sets it", fmt::join(keys, ", ")));
    if (keys.empty() || effect.advice != effects::Effect{}.advice) entry.lines.emplace_back("advice", effect.advice);
    return entry;
}

Entry generic_entry(const effects::Term& term) {
    Entry entry = effect_entry(term.effect);
    entry.kind = "generic term";
    entry.json["kind"] = "generic term";
    entry.json["port"] = term.port;
    entry.json["depends_on"] = term.depends_on;
    entry.lines.emplace_back("enters at", term.port);
    entry.lines.emplace_back("depends on", term.depends_on);
    return entry;
}

}  // namespace fusee::app
