#include "fusee/gap_case/likely_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fusee::gap_case {

std::string likely_unit(double ratio, const std::vector<OtherUnit>& units) {
    const auto far = [ratio](const OtherUnit& unit) { return std::abs(std::log(ratio / unit.count)); };
    const auto nearest =
        std::min_element(units.begin(), units.end(), [&](const OtherUnit& a, const OtherUnit& b) { return far(a) < far(b); });
    return ratio > 0.0 && nearest != units.end() ? fmt::format("; {}?", nearest->question) : "";
}

bool counted_in(const std::vector<double>& readings, double step) {
    constexpr double kOff = 0.05;          // of a step: by chance one reading in ten is as near
    constexpr std::size_t kDifferent = 8;  // counts: an axis that stays where it is may stand near one or two
    std::set<double> counts;
    for (const double reading : readings) {
        const double count = std::round(reading / step);
        if (std::abs(reading / step - count) > kOff) return false;
        counts.insert(count);
    }
    return counts.size() >= kDifferent;
}

}  // namespace fusee::gap_case
