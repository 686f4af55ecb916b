#include <nlohmann/json.hpp>

#include "fusee/blind/score.h"
#include "fusee/core/json.h"
#include "fusee/core/provenance.h"

namespace fusee::blind {

namespace {

using Json = nlohmann::ordered_json;  // NaN is written as null

Json range(const core::Range& r) { return Json::array({r.low, r.high}); }

Json share_json(const Share& share) {
    return {{"hits", share.hits}, {"of", share.of}, {"value", share.value()}, {"wilson95", range(share.wilson95())}};
}

Json figures_json(const Score& score) {
    Json all = Json::object();
    for (const Figure& figure : score.figures) {
        Json j = share_json(figure.share);
        j["name"] = figure.name;
        j["wanted"] = range(figure.wanted);
        j["shuffled"] = figure.shuffled;
        j["shuffled95"] = range(figure.shuffled95);
        all[figure.key] = std::move(j);
    }
    return all;
}

Json calibration_json(const Score& score) {
    Json all = Json::array();
    for (const CalibrationBin& bin : score.calibration) {
        Json j = share_json(bin.right);
        j["stated"] = range(bin.stated);
        j["mean_stated"] = bin.mean_stated;
        all.push_back(std::move(j));
    }
    return all;
}

Json causes_json(const std::vector<effects::Cause>& causes) {
    Json all = Json::array();
    for (const effects::Cause& cause : causes) all.push_back({{"id", cause.id}, {"side", cause.side}});
    return all;
}

Json truth_json(const Label& label) {
    Json all = Json::array();
    for (const LabelEffect& effect : label.effects) all.push_back({{"id", effect.id}, {"side", effect.side}, {"size", effect.size}});
    return all;
}

Json answer_json(const Answer& answer) {
    Json effects = Json::array(), alternatives = Json::array();
    for (const diagnosis::FoundEffect& e : answer.effects)
        effects.push_back({{"id", e.cause.id},
                           {"side", e.cause.side},
                           {"probability", e.probability},
                           {"value", e.parameter.value},
                           {"ci95", range(e.parameter.ci95)}});
    for (const diagnosis::Alternative& other : answer.alternatives)
        alternatives.push_back({{"effects", causes_json(other.effects)}, {"probability", other.probability}});
    return {{"verdict", answer.failure.empty() ? to_string(answer.verdict) : "failed"},
            {"effects", std::move(effects)},
            {"alternatives", std::move(alternatives)},
            {"held_out_before", answer.held_out_before},
            {"held_out_after", answer.held_out_after}};
}

Json misses_json(const Score& score) {
    Json all = Json::array();
    for (const Miss& miss : score.misses)
        all.push_back(
            {{"case", miss.truth.case_name}, {"what", miss.what}, {"truth", truth_json(miss.truth)}, {"answer", answer_json(miss.answer)}});
    return all;
}

Json score_object(const Score& score) {
    Json coverage = Json::object(), shrink = Json::array();
    for (const auto& [id, share] : score.coverage) coverage[id] = share_json(share);
    for (const ShrinkRow& row : score.shrink)
        shrink.push_back({{"case", row.case_name},
                          {"claimed", row.claimed},
                          {"measured", row.measured},
                          {"measured_as_claimed", row.as_claimed},
                          {"claimed_of_runs", row.of_runs}});
    return {{"seal", "sha256:" + score.seal},
            {"cases", score.cases},
            {"figures", figures_json(score)},
            {"confusion", score.confusion},
            {"calibration", calibration_json(score)},
            {"coverage", std::move(coverage)},
            {"shrink", std::move(shrink)},
            {"seconds", {{"median", score.median_seconds}, {"worst", score.worst_seconds}}},
            {"misses", misses_json(score)}};
}

}  // namespace

std::string score_json(const Score& score, const std::optional<Score>& model) {
    Json j = score_object(score);
    j["model"] = model ? score_object(*model) : Json();
    j["fusee"] = core::version();
    core::keep_old_spelling(
        j, {{"kept_back_halved", "held_out_halved"}, {"kept_back_before", "held_out_before"}, {"kept_back_after", "held_out_after"}});
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::blind
