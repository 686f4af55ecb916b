#include "design/stretch.h"

#include <fmt/format.h>

#include "fusee/core/units.h"
#include "fusee/report/simulation.h"

namespace fusee::report {

std::string stretch_text(const cam::ArmPoint& at) {
    return fmt::format("{:.3g} mm at {:.3g} N: {:.3g} of the capstan's {:.3g} deg, {:.2g} %", core::mm_from_m(at.elongation.length),
                       at.tension, core::deg_from_rad(at.elongation.turn), core::deg_from_rad(at.elongation.travel),
                       100.0 * at.elongation.share());
}

std::string stretch_remark(const Simulation& s) {
    std::string text = "Cable elongation at the law's largest load, which both cams compensate: ";
    for (const StretchSide& side : s.stretches)
        text += fmt::format("{}{} by {}", &side == &s.stretches.front() ? "" : "; ", cam::to_string(side.part), stretch_text(side.at));
    return text + ".";
}

}  // namespace fusee::report
