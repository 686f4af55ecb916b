#include <array>
#include <nlohmann/json.hpp>

#include "fusee/core/json.h"
#include "fusee/diagnosis/diagnosis.h"

namespace fusee::diagnosis {

namespace {

using Json = nlohmann::ordered_json;  // NaN is written as null

Json range(const core::Range& r) { return Json::array({r.low, r.high}); }

Json causes_json(const std::vector<inference::Cause>& causes) {
    Json all = Json::array();
    for (const inference::Cause& cause : causes) all.push_back({{"id", cause.id}, {"side", cause.side}});
    return all;
}

Json parameter_json(const Parameter& parameter) {
    return {{"value", parameter.value}, {"ci95", range(parameter.ci95)}, {"unit", parameter.unit}};
}

Json effect_json(const FoundEffect& effect) {
    Json j{{"id", effect.cause.id},
           {"side", effect.cause.side},
           {"probability", effect.probability},
           {"parameter", parameter_json(effect.parameter)}};
    for (const auto& [name, value] : effect.extra) j["extra"][name] = value;
    return j;
}

Json effects_json(const std::vector<FoundEffect>& effects) {
    Json all = Json::array();
    for (const FoundEffect& effect : effects) all.push_back(effect_json(effect));
    return all;
}

Json term_json(const UnknownTerm& term) {
    Json j = effect_json(term.found);
    j["port"] = term.port;
    j["depends_on"] = term.depends_on;
    j["law"] = term.law;
    j["sentence"] = term.sentence;
    j["log_odds"] = term.log_odds;
    j["curve"] = {{"x_name", term.x_name}, {"y_name", term.y_name}, {"x", term.x}, {"y", term.y}};
    return j;
}

/// The first term, the second as its member; null without terms.
Json unknown_term_json(const std::vector<UnknownTerm>& terms) {
    if (terms.empty()) return nullptr;
    Json j = term_json(terms.front());
    if (terms.size() > 1) j["second"] = term_json(terms[1]);
    return j;
}

Json where_json(const std::vector<GapContribution>& where) {
    Json all = Json::array();
    for (const GapContribution& part : where) {
        Json j{{"experiment", part.experiment},
               {"share", part.share},
               {"region", {{"variable", part.variable}, {"from", part.region.low}, {"to", part.region.high}}}};
        if (!part.component.empty()) j["component"] = part.component;
        all.push_back(std::move(j));
    }
    return all;
}

Json gap_json(const Gap& gap) {
    return {{"before", gap.before},
            {"after", gap.after},
            {"noise_floor", gap.noise_floor},
            {"heldout_before", gap.heldout_before},
            {"heldout_after", gap.heldout_after},
            {"heldout_after_95", range(gap.heldout_after_95)},
            {"unit", "sigma"}};
}

Json alternatives_json(const std::vector<Alternative>& alternatives) {
    Json all = Json::array();
    for (const Alternative& other : alternatives)
        all.push_back({{"effects", causes_json(other.effects)}, {"probability", other.probability}});
    return all;
}

Json experiments_json(const std::vector<ExperimentGap>& experiments) {
    Json all = Json::array();
    for (const ExperimentGap& e : experiments) {
        Json j{
            {"experiment", e.experiment}, {"rows", e.rows}, {"gap", gap_json(e.gap)}, {"forecast", e.forecast}, {"held_out", e.held_out}};
        if (!e.unit.empty())
            j["in_unit"] = {
                {"before", e.before_in_unit}, {"after", e.after_in_unit}, {"heldout_after", e.heldout_in_unit}, {"unit", e.unit}};
        all.push_back(std::move(j));
    }
    return all;
}

Json map_json(const std::vector<GapCell>& map) {
    Json all = Json::array();
    for (const GapCell& cell : map)
        all.push_back({{"experiment", cell.experiment},
                       {"region", {{"variable", cell.variable}, {"from", cell.region.low}, {"to", cell.region.high}}},
                       {"before", cell.before},
                       {"after", cell.after},
                       {"rows", cell.rows}});
    return all;
}

Json ranking_json(const std::vector<Hypothesis>& ranking) {
    Json all = Json::array();
    for (const Hypothesis& hypothesis : ranking) {
        Json parameters = Json::array();
        for (const Parameter& parameter : hypothesis.parameters) parameters.push_back(parameter_json(parameter));
        all.push_back({{"effects", causes_json(hypothesis.effects)},
                       {"log_evidence", hypothesis.log_evidence},
                       {"probability", hypothesis.probability},
                       {"chi2", hypothesis.chi2},
                       {"left_out", hypothesis.left_out},
                       {"parameters", std::move(parameters)}});
    }
    return all;
}

Json isolability_json(const Isolability& isolability) {
    return {{"causes", causes_json(isolability.causes)},
            {"signature_similarity", isolability.signature_similarity},
            {"detectable", isolability.detectable},
            {"units", isolability.units},
            {"classes", isolability.classes}};
}

Json power_json(const std::vector<Power>& power) {
    Json all = Json::array();
    for (const Power& own : power)
        all.push_back({{"id", own.cause.id},
                       {"side", own.cause.side},
                       {"least", own.least},
                       {"usual", own.usual},
                       {"unit", own.unit},
                       {"shown", own.shown}});
    return all;
}

Json transfer_json(const std::vector<Transfer>& transfer) {
    Json all = Json::array();
    for (const Transfer& t : transfer) {
        Json values = Json::array();
        for (const Parameter& parameter : t.parameters) values.push_back({{"value", parameter.value}, {"unit", parameter.unit}});
        all.push_back({{"effects", causes_json(t.effects)},
                       {"fitted", t.fitted},
                       {"heldout", t.heldout},
                       {"fit_before", t.fit_before},
                       {"fit_after", t.fit_after},
                       {"heldout_before", t.heldout_before},
                       {"heldout_after", t.heldout_after},
                       {"parameters", std::move(values)},
                       {"unit", t.unit}});
    }
    return all;
}

Json absorption_json(const std::optional<Absorption>& absorption) {
    if (!absorption) return nullptr;
    Json parameters = Json::array();
    for (const Absorption::Moved& own : absorption->moved)
        parameters.push_back(
            {{"name", own.name}, {"value", own.value}, {"tolerances", own.tolerances}, {"with_cause", own.with_cause}, {"unit", own.unit}});
    return {{"parameters", std::move(parameters)},
            {"after", absorption->after},
            {"heldout_after", absorption->heldout_after},
            {"unit", "sigma"}};
}

Json against_json(const Against& against) {
    Json causes = Json::array();
    for (const Against::Carried& own : against.causes)
        causes.push_back({{"id", own.cause.id},
                          {"side", own.cause.side},
                          {"here", parameter_json(own.here)},
                          {"there", parameter_json(own.there)},
                          {"survival", to_string(own.survival)}});
    return {{"case", against.case_name},
            {"case_sha256", against.case_sha256},
            {"causes", std::move(causes)},
            {"gap",
             {{"before", against.before},
              {"carried", against.carried},
              {"refitted", against.refitted},
              {"own", against.own},
              {"unit", "sigma"}}},
            {"verdict", to_string(against.verdict)},
            {"effects", effects_json(against.effects)}};
}

Json next_json(const std::vector<NextExperiment>& next) {
    Json all = Json::array();
    for (const NextExperiment& n : next)
        all.push_back({{"text", n.text},
                       {"experiment", n.experiment},
                       {"variable", n.variable},
                       {"set_points", n.set_points},
                       {"information_bit", n.information},
                       {"cost_min", n.cost}});
    return all;
}

}  // namespace

const char* to_string(VerdictKind verdict) {
    static constexpr std::array<const char*, 6> kNames{"identified", "none", "ambiguous", "unknown", "inconclusive", "partly_explained"};
    return kNames.at(static_cast<std::size_t>(verdict));
}

std::string diagnosis_json(const Diagnosis& d) {
    Json build = Json::object();
    for (const auto& [name, parameter] : d.build) build[name] = parameter_json(parameter);
    Json j{{"verdict", to_string(d.verdict)},
           {"effects", effects_json(d.effects)},
           {"unknown_term", unknown_term_json(d.unknown_terms)},
           {"alternatives", alternatives_json(d.alternatives)},
           {"where", where_json(d.where)},
           {"gap", gap_json(d.gap)},
           {"next_experiment", d.next_experiment},
           {"next", next_json(d.next)},
           {"build", std::move(build)},
           {"experiments", experiments_json(d.experiments)},
           {"map", map_json(d.map)},
           {"ranking", ranking_json(d.ranking)},
           {"transfer", transfer_json(d.transfer)},
           {"absorption", absorption_json(d.absorption)},
           {"isolability", isolability_json(d.isolability)},
           {"power", power_json(d.power)},
           {"remarks", d.remarks},
           {"case", d.case_name},
           {"case_sha256", d.case_sha256}};
    if (!d.doubts.empty()) j["doubts"] = d.doubts;
    if (d.against) j["against"] = against_json(*d.against);
    core::keep_old_spelling(j, {{"alike", "signature_similarity"}});
    // A folder's name may be no UTF-8.
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::diagnosis
