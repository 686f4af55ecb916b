#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_process_hole(const Design& design, const Allowed& allowed) {
    const Hole least = smallest_hole(design.part);
    core::Finding f = compare(mm_from_m(least.diameter), {allowed("required", mm_from_m(process_limits(design.process).hole))});
    f.what = fmt::format("diameter of the smallest hole: {}", least.what);
    f.suggestion = change(design, least.key, up(f.allowed));
    return {f};
}

}  // namespace

Rule process_hole() {
    return {"process.hole",
            "a hole too small to make",
            "diameter of the smallest of bore, anchor hole and screw hole",
            "the process's least hole",
            {of_process(required(kAtLeast, "mm", "the process's hole"))},
            measure_process_hole};
}

}  // namespace fusee::checks
