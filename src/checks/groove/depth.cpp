#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_groove_depth(const Design& design, const Allowed& allowed) {
    core::Finding f = compare(design.part.options.groove.depth_ratio, {allowed("required"), allowed("review")});
    f.what = "depth of the groove below its lips";
    f.suggestion = change("groove.depth_ratio", up(f.allowed));
    return {f};
}

}  // namespace

Rule groove_depth() {
    return {"groove.depth",
            "the cable jumping out of its groove",
            "depth of the lips above the floor",
            "Unirope/Python: drum at least 0.375 d, sheave about 1.5 d",
            {required(kAtLeast, "d", 0.375), review(kAtLeast, "d", 1.5)},
            measure_groove_depth};
}

}  // namespace fusee::checks
