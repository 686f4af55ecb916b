#include "fusee/report/redesign.h"

#include <cmath>

namespace fusee::report {

namespace {

/// Mean of |width - promised|/promised over the levels at which both were measured.
double mean_off(const std::vector<RedesignLevel>& levels, DeadBandWidths RedesignLevel::*which) {
    double sum = 0.0;
    int known = 0;
    for (const RedesignLevel& level : levels) {
        const double off = std::abs((level.*which).measured_width / level.promised.measured_width - 1.0);
        if (!std::isfinite(off)) continue;
        sum += off;
        ++known;
    }
    return known > 0 ? sum / known : gap::kNoFigure;
}

}  // namespace

double Redesign::off_with_old_cams() const { return mean_off(levels, &RedesignLevel::old_cams); }
double Redesign::off_with_new_cams() const { return mean_off(levels, &RedesignLevel::new_cams); }

}  // namespace fusee::report
