#include "measure.h"
#include "rules.h"

namespace fusee::checks {

namespace {

core::Findings run(const Design& design) {
    core::Finding f = at_least(design.part.options.groove.depth_ratio, {0.375, 1.5}, "d");
    f.what = "depth of the groove below its lips";
    f.suggestion = "groove.depth_ratio = " + up(f.allowed);
    return {f};
}

}  // namespace

Rule groove_depth() {
    return {"groove.depth", "the cable jumping out of its groove", "Unirope/Python: drum at least 0.375 d, sheave about 1.5 d", run};
}

}  // namespace fusee::checks
