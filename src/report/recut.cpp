#include "fusee/report/recut.h"

#include <cmath>

namespace fusee::report {

namespace {

/// Mean of |width - promised|/promised over the levels at which both were read.
double mean_off(const std::vector<RecutLevel>& levels, DeadBandWidths RecutLevel::*which) {
    double sum = 0.0;
    int known = 0;
    for (const RecutLevel& level : levels) {
        const double off = std::abs((level.*which).read / level.promised.read - 1.0);
        if (!std::isfinite(off)) continue;
        sum += off;
        ++known;
    }
    return known > 0 ? sum / known : gap::kNoFigure;
}

}  // namespace

double Recut::off_with_old_cams() const { return mean_off(levels, &RecutLevel::old_cams); }
double Recut::off_with_new_cams() const { return mean_off(levels, &RecutLevel::new_cams); }

}  // namespace fusee::report
