#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "codesign/problem.h"
#include "fusee/core/finding.h"
#include "fusee/search/init.h"
#include "scale.h"
#include "variables.h"

namespace fusee::search::init {

/// The best candidate of one search.
struct Searched {
    profile::Profile profile;
    bool makeable = false;   ///< no rule that needs no mesh has an error; base springs have no wire yet
    core::Findings binding;  ///< of a candidate that is not: the limits that it breaks, the worst first
    double missing = 0.0;    ///< of such a candidate: the sum of the shares by which it breaks them
    std::size_t judged = 0;
};

/// How long and from where a search runs.
struct Effort {
    int generations = 250;  ///< at most; ends earlier when it stops improving
    int hopeless = 100;     ///< generations after which it ends if none has given a design without errors
    std::uint64_t seed = 1;
    bool first = false;  ///< ends at the first design without errors
};

/// The numbers of `Scale` that are searched.
[[nodiscard]] std::vector<Variable<Scale>> variables_of(const Answers& answers);
/// What no search changes: the loads of a measured law. @pre a measured law is a pair of springs
[[nodiscard]] Scale start_of(const Answers& answers);
/// Largest radius of a cable's centreline on a cam that the bed and the wanted size allow [m].
[[nodiscard]] double contour_limit(const Answers& answers);
/// "limit.size" for each of capstan, pulley and cams that is larger than wanted; a cam that cannot be drawn is not judged.
[[nodiscard]] core::Findings too_large(const profile::Profile& profile, const Answers& answers);
/// Side of the bed and wanted size for that radius [m].
struct Room {
    double bed = 0.0, size = 0.0;
};
[[nodiscard]] Room room_for(double contour_radius, const Answers& answers);

/// Searches the numbers of `Scale` for the least dead-band and size without errors, then without warnings, by differential evolution.
Searched search_scales(const std::string& name, const Answers& answers, const Effort& effort, const InitOptions& options);

}  // namespace fusee::search::init
