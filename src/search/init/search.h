#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "codesign/problem.h"
#include "fusee/core/finding.h"
#include "fusee/search/init.h"
#include "scale.h"

namespace fusee::search::init {

/// The best candidate of one search.
struct Searched {
    profile::Profile profile;
    bool makeable = false;   ///< no rule that needs no mesh has an error; base springs have no wire yet
    core::Findings binding;  ///< of a candidate that is not: the limits that it breaks, the worst first
    std::size_t judged = 0;
};

/// How long and from where a search runs.
struct Effort {
    int generations = 250;  ///< at most; ends earlier when it stops improving
    std::uint64_t seed = 1;
    bool first = false;  ///< ends at the first design without errors
};

/// Searches the numbers of `Scale` for the least dead-band and size without errors, then without warnings, by differential evolution.
Searched search_scales(const std::string& name, const Answers& answers, const Effort& effort, const Options& options);

}  // namespace fusee::search::init
