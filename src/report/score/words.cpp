#include "score/words.h"

#include <fmt/format.h>

#include <cmath>

#include "data/figures.h"

namespace fusee::report {

std::string per_cent(double share) { return std::isnan(share) ? number(share) : fmt::format("{:.1f} %", 100.0 * share); }

std::string per_cent(const core::Range& range) {
    if (std::isnan(range.low) || std::isnan(range.high)) return number(range.low - range.high);
    return fmt::format("{:.1f} to {:.1f} %", 100.0 * range.low, 100.0 * range.high);
}

std::string interval_text(const blind::Share& share) { return share.of == 0 ? "" : per_cent(share.wilson95()); }

std::string wanted_text(const core::Range& wanted) {
    const bool low = wanted.low > 0.0, high = wanted.high < 1.0;
    if (!low && !high) return "";
    if (low && high) return fmt::format("{:.0f} to {:.0f} %", 100.0 * wanted.low, 100.0 * wanted.high);
    if (wanted.low == 1.0) return "100 %";
    return low ? fmt::format("at least {:.0f} %", 100.0 * wanted.low) : fmt::format("at most {:.0f} %", 100.0 * wanted.high);
}

}  // namespace fusee::report
