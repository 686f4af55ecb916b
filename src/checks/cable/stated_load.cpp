#include "means.h"

namespace fusee::checks {

namespace {

bool states_load(const Design& design) { return design.cable.breaking_load > 0.0; }

core::Findings measure_cable_stated_load(const Design& design, const Allowed& allowed) {
    const Cable& cable = design.cable;
    const double strongest = strongest_cable(cable.construction, cable.diameter);
    core::Finding f = compare(cable.breaking_load, {allowed("required", strongest)});
    f.what = fmt::format("stated breaking load against that of the strongest {:.3g} mm {} cable on sale", mm_from_m(cable.diameter),
                         cable.construction);
    f.where = at_anchor(design);
    f.suggestion = change("cable.breaking_load_N", down(f.allowed));
    f.source = cable_sizes(cable.construction).source;
    return {f};
}

}  // namespace

Rule cable_stated_load() {
    return {"cable.stated_load",
            "a breaking load that no cable of this diameter has",
            "cable.breaking_load_N",
            "fibre 2070 N/mm^2 of d^2: oceanbluefishing, UHMWPE braid, 138 lb at 0.545 mm; wire 900: MIL-DTL-83420",
            {required(kAtMost, "N", "strongest cable on sale of this construction and diameter")},
            measure_cable_stated_load,
            states_load};
}

}  // namespace fusee::checks
