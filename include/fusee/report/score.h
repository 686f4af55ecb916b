#pragma once
#include <optional>
#include <string>

#include "fusee/blind/score.h"

/// The score of a sealed benchmark, for a person (docs/benchmark.md). score.json is written by blind::score_json.
namespace fusee::report {

/// One page in one file that opens offline: its scripts inside, no request. @param model score of cases that the model itself made, shown
/// for comparison
[[nodiscard]] std::string score_html(const blind::Score& score, const std::optional<blind::Score>& model = {});
/// The figures with their targets, their control and the model's figures, for a terminal.
[[nodiscard]] std::string score_text(const blind::Score& score, const std::optional<blind::Score>& model = {});

}  // namespace fusee::report
