#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cable_termination(const Design& design, const Allowed& allowed) {
    const TerminationLimits& end = termination_limits(design.cable);
    core::Finding f = compare(100.0 * end.strength, {allowed("review")});
    f.what = fmt::format("share of its breaking load that a {} of {} holds with a {}", end.fibre ? "cord" : "wire rope",
                         design.cable.construction, to_string(end.kind));
    f.where = at_anchor(design);
    Cable crimped = design.cable;
    crimped.termination = Termination::kCrimp;
    f.suggestion = change("cable.termination", quoted("crimp"))
                       .noted(fmt::format(": a sleeve holds {:.0f} %", 100.0 * termination_limits(crimped).strength));
    f.source = end.source;
    return {f};
}

}  // namespace

Rule cable_termination() {
    return {"cable.termination",
            "an end that the construction does not bear",
            "share of its breaking load that the cable holds at its end",
            "table 6; half of it (practice)",
            {review(kAtLeast, "%", 50.0)},
            measure_cable_termination};
}

}  // namespace fusee::checks
