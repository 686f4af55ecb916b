#include "fusee/spring/enclosure.h"

#include <algorithm>

namespace fusee::spring {

std::vector<LawSegment> segments(const SpringLaw& law) {
    const auto* enclosed = dynamic_cast<const EnclosedLaw*>(&law);
    return enclosed ? enclosed->segments() : std::vector<LawSegment>{};
}

std::vector<double> cuts(core::Range range, const std::vector<double>& places) {
    std::vector<double> all{range.low, range.high};
    std::copy_if(places.begin(), places.end(), std::back_inserter(all), [range](double at) { return range.low < at && at < range.high; });
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace fusee::spring
