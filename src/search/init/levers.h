#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fusee/search/init.h"

namespace fusee::search::init {

/// Conditions that every joint of these answers must meet, before a candidate is judged: first a measured law that is a pair of springs and
/// reaches the dead-band's edges, then springs that hold its work, then contours that the cable and the bed allow. Empty: no obstacle.
/// @throws core::Stopped
[[nodiscard]] core::Findings broken_at_once(const Answers& answers, const InitOptions& options);

/// For each answer that can do so alone, its least change with which `broken_at_once` is empty: by bisection towards the end of its range,
/// 3 digits; of cables the next size or kind. The smallest change first. @pre `broken` is what is broken now
[[nodiscard]] std::vector<OtherAnswers> find_levers(const Answers& answers, const core::Findings& broken, const InitOptions& options);

struct Changed {
    Answers answers;
    OtherAnswers other;
};
/// With the bed, and the size where one is wanted, that a contour of this radius [m] needs; whole millimetres.
[[nodiscard]] Changed with_room(const Answers& answers, double contour_radius);
/// With one answer entered anew; none if the others exclude it, or if it is the present one.
[[nodiscard]] std::optional<Changed> changed(const Answers& answers, const std::string& option, const std::string& text);

}  // namespace fusee::search::init
