#pragma once
#include <optional>
#include <string>

#include "fusee/codesign/run.h"

namespace fusee::codesign {

/// Values of one call that replace those of [design].
struct SearchChanges {
    std::optional<std::string> method = {};  ///< one of design::kMethodNames
    std::optional<int> population = {}, generations = {}, seed = {};
};

/// @throws InvalidInput for a method that has another name
void change_search(design::SearchOptions& search, const SearchChanges& changes);

/// Searches springs by the method of the profile's [design]: run_algorithm_1, run_co_design or run_pareto.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult find_springs(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::codesign
