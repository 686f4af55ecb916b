#include <nlohmann/json.hpp>

#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/effects/term.h"

namespace fusee::diagnosis {

namespace {

using core::JsonNode;

constexpr double kProbabilityRounding = 1e-9;  // of a sum of probabilities
const std::vector<std::string> kKeys{"verdict",        "effects",  "alternatives", "where",    "gap",         "next_experiment",
                                     "next",           "build",    "experiments",  "map",      "ranking",     "isolability",
                                     "power",          "transfer", "remarks",      "case",     "case_sha256", "unknown_term",
                                     "renamed_fields", "doubts",   "fusee",        "sentence", "probability", "meanings",
                                     "term_units",     "traces",   "absorption",   "against"};

Parameter parameter_of(const JsonNode& node) {
    node.allow_keys({"value", "ci95", "unit"});
    Parameter parameter{node["value"].number(), {kNoFigure, kNoFigure}, node.has("unit") ? node["unit"].text() : ""};
    if (node.has("ci95")) {
        const std::vector<JsonNode> ends = node["ci95"].cells();
        if (ends.size() != 2) node["ci95"].refuse("two numbers, the lower first");
        parameter.ci95 = {ends[0].number_or_null(), ends[1].number_or_null()};
    }
    return parameter;
}

FoundEffect effect_of(const JsonNode& node, const std::vector<std::string>& more = {}) {
    std::vector<std::string> keys{"id", "side", "probability", "parameter", "extra"};
    keys.insert(keys.end(), more.begin(), more.end());
    node.allow_keys(keys);
    FoundEffect effect{{node["id"].text(), node.has("side") ? node["side"].text() : "none"}, 1.0, parameter_of(node["parameter"]), {}};
    if (node.has("probability") && !node["probability"].is_null())
        effect.probability = node["probability"].number_within(0.0, 1.0 + kProbabilityRounding);
    if (node.has("extra"))
        for (const auto& [name, value] : node["extra"].members()) effect.extra.emplace_back(name, value.number());
    return effect;
}

UnknownTerm term_of(const JsonNode& node) {
    UnknownTerm term;
    term.found = effect_of(node, {"port", "depends_on", "law", "sentence", "log_odds", "curve", "second"});
    const effects::Term* const law = effects::term_or_none(term.found.cause.id);
    if (law == nullptr) node["id"].refuse("the id of a generic term");
    term.port = law->port;
    term.depends_on = law->depends_on;
    term.law = law->effect.law;
    if (node.has("sentence")) term.sentence = node["sentence"].text();
    return term;
}

NextExperiment next_of(const JsonNode& node) {
    node.allow_keys({"text", "experiment", "variable", "set_points", "information_bit", "cost_min"});
    NextExperiment next{node["text"].text(),     node["experiment"].text(),        {},
                        node["variable"].text(), node["information_bit"].number(), node["cost_min"].number()};
    for (const JsonNode& point : node["set_points"].cells()) next.set_points.push_back(point.number());
    return next;
}

VerdictKind parse_verdict(const JsonNode& node) {
    for (const VerdictKind verdict : {VerdictKind::kIdentified, VerdictKind::kNone, VerdictKind::kAmbiguous, VerdictKind::kUnknown,
                                      VerdictKind::kInconclusive, VerdictKind::kPartlyExplained})
        if (node.text() == to_string(verdict)) return verdict;
    node.refuse("identified, none, ambiguous, unknown, inconclusive or partly_explained");
}

}  // namespace

Diagnosis parse_diagnosis(std::string_view json, const std::string& file) {
    const nlohmann::ordered_json parsed = core::parse_json(json, file);
    const JsonNode root(parsed, file + ": diagnosis");
    root.allow_keys(kKeys);
    Diagnosis diagnosis;
    for (const JsonNode& effect : root["effects"].cells()) diagnosis.effects.push_back(effect_of(effect));
    diagnosis.verdict = diagnosis.effects.empty() ? VerdictKind::kNone : VerdictKind::kIdentified;
    if (root.has("verdict")) diagnosis.verdict = parse_verdict(root["verdict"]);
    if (root.has("unknown_term") && !root["unknown_term"].is_null()) {
        const JsonNode first = root["unknown_term"];
        diagnosis.unknown_terms.push_back(term_of(first));
        if (first.has("second")) diagnosis.unknown_terms.push_back(term_of(first["second"]));
    }
    if (root.has("build"))
        for (const auto& [name, parameter] : root["build"].members()) diagnosis.build.emplace_back(name, parameter_of(parameter));
    if (root.has("next"))
        for (const JsonNode& next : root["next"].cells()) diagnosis.next.push_back(next_of(next));
    if (root.has("next_experiment")) diagnosis.next_experiment = root["next_experiment"].text();
    if (root.has("case")) diagnosis.case_name = root["case"].text();
    if (root.has("case_sha256")) diagnosis.case_sha256 = root["case_sha256"].text();
    return diagnosis;
}

Diagnosis read_diagnosis(const std::filesystem::path& file) { return parse_diagnosis(core::read_file(file, kLargestFile), file.string()); }

}  // namespace fusee::diagnosis
