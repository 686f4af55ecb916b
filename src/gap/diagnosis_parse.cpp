#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/error.h"
#include "fusee/gap/diagnosis.h"

namespace fusee::gap {

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kLongestShown = 80;  // of a refused value

/// A value with its path, so that each refusal names the key.
class Node {
public:
    Node(const Json& json, std::string path) : json_(json), path_(std::move(path)) {}

    [[nodiscard]] bool has(const std::string& key) const { return json_.is_object() && json_.contains(key); }
    [[nodiscard]] Node operator[](const std::string& key) const {
        if (!json_.is_object()) refuse("an object");
        if (!json_.contains(key)) throw core::InvalidInput(path_ + "." + key, "missing", "this key");
        return {json_.at(key), path_ + "." + key};
    }
    [[nodiscard]] std::string text() const { return json_.is_string() ? json_.get<std::string>() : refuse("a text"); }
    [[nodiscard]] double number() const { return json_.is_number() ? json_.get<double>() : (refuse("a number"), 0.0); }
    /// null is what NaN is written as.
    [[nodiscard]] double number_or_null() const { return json_.is_null() ? kNoFigure : number(); }
    [[nodiscard]] std::vector<Node> cells() const {
        if (!json_.is_array()) refuse("an array");
        std::vector<Node> cells;
        for (std::size_t i = 0; i < json_.size(); ++i) cells.emplace_back(json_[i], fmt::format("{}[{}]", path_, i));
        return cells;
    }
    [[nodiscard]] std::vector<std::pair<std::string, Node>> members() const {
        if (!json_.is_object()) refuse("an object");
        std::vector<std::pair<std::string, Node>> members;
        for (const auto& [key, value] : json_.items()) members.emplace_back(key, Node(value, path_ + "." + key));
        return members;
    }
    [[noreturn]] std::string refuse(const std::string& allowed) const {
        throw core::InvalidInput(path_, json_.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, kLongestShown), allowed);
    }

private:
    const Json& json_;
    std::string path_;
};

Parameter parameter_of(const Node& node) {
    Parameter parameter{node["value"].number(), {kNoFigure, kNoFigure}, node.has("unit") ? node["unit"].text() : ""};
    if (node.has("ci95")) {
        const std::vector<Node> ends = node["ci95"].cells();
        if (ends.size() != 2) node["ci95"].refuse("two numbers, the lower first");
        parameter.ci95 = {ends[0].number_or_null(), ends[1].number_or_null()};
    }
    return parameter;
}

FoundEffect effect_of(const Node& node) {
    FoundEffect effect{{node["id"].text(), node.has("side") ? node["side"].text() : "none"}, 1.0, parameter_of(node["parameter"]), {}};
    if (node.has("probability")) effect.probability = node["probability"].number_or_null();
    if (node.has("extra"))
        for (const auto& [name, value] : node["extra"].members()) effect.extra.emplace_back(name, value.number());
    return effect;
}

Verdict verdict_of(const Node& node) {
    for (const Verdict verdict : {Verdict::kIdentified, Verdict::kNone, Verdict::kAmbiguous, Verdict::kUnknown})
        if (node.text() == to_string(verdict)) return verdict;
    node.refuse("identified, none, ambiguous or unknown");
}

Json parse(std::string_view json, const std::string& file) {
    try {
        return Json::parse(json);
    } catch (const Json::parse_error& e) {
        throw core::InvalidInput(file, fmt::format("no valid JSON at byte {}", e.byte), "a diagnosis.json");
    }
}

}  // namespace

Diagnosis parse_diagnosis(std::string_view json, const std::string& file) {
    const Json parsed = parse(json, file);
    const Node root(parsed, file + ": diagnosis");
    Diagnosis diagnosis;
    for (const Node& effect : root["effects"].cells()) diagnosis.effects.push_back(effect_of(effect));
    diagnosis.verdict = diagnosis.effects.empty() ? Verdict::kNone : Verdict::kIdentified;
    if (root.has("verdict")) diagnosis.verdict = verdict_of(root["verdict"]);
    if (root.has("build"))
        for (const auto& [name, parameter] : root["build"].members()) diagnosis.build.emplace_back(name, parameter_of(parameter));
    if (root.has("case")) diagnosis.case_name = root["case"].text();
    if (root.has("case_sha256")) diagnosis.case_sha256 = root["case_sha256"].text();
    return diagnosis;
}

}  // namespace fusee::gap
