#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/core/units.h"

/// What several JSON files say in the same way. A NaN is written as null.
namespace fusee::report {

using Json = nlohmann::ordered_json;

/// What made a file: fusee, name, profile_sha256, options.
[[nodiscard]] Json provenance_json(const core::Provenance& made_by);
[[nodiscard]] Json range_json(const core::Range& range);
/// Findings as every JSON file shows them (docs/report.md).
[[nodiscard]] Json findings_json(const core::Findings& findings);
/// Numbers of passed, not judged, warnings and errors, in all and by group.
[[nodiscard]] Json rules_json(const core::Findings& findings);

/// Fields renamed in this version: old name, new name.
using RenamedFields = std::vector<std::pair<std::string, std::string>>;
inline const RenamedFields kRenamedCounts{{"required", "errors"}, {"review", "warnings"}};
/// The bytes of a file; renamed fields keep their old spelling too. An invalid byte in a text is replaced.
[[nodiscard]] std::string json_text(Json json, const RenamedFields& renamed = {});

/// One entry a row.
template <class Row, class ToJson>
[[nodiscard]] Json json_list(const std::vector<Row>& rows, const ToJson& to_json) {
    Json all = Json::array();
    for (const Row& row : rows) all.push_back(to_json(row));
    return all;
}

}  // namespace fusee::report
