#include "fusee/solid/companions.h"
#include "means.h"

namespace fusee::checks {

namespace {

bool has_blind_keyway(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return is_milled(design) && hub.kind == solid::HubKind::kOverhung && hub.lock == solid::HubLock::kKeyway;
}

core::Findings measure_shaft_blind_keyway(const Design& design, const Allowed& allowed) {
    core::Finding f = compare(0.0, {allowed("review")});  // a blind bore has its keyway up to its end
    f.what = "length behind the keyway of a blind bore into which a broach or a slotting tool can run out";
    f.suggestion = solid::set_screw_change(name(design), design.part.options.hub);
    f.suggestion.or_else(fmt::format("a groove of {:g} mm turned behind the keyway, deeper than it", f.allowed))
        .or_else("the keyway sunk by erosion");
    return {f};
}

}  // namespace

Rule shaft_blind_keyway() {
    return {"shaft.blind_keyway",
            "a keyway in a blind bore, which no tool can leave",
            "milled, overhung: space behind the keyway for the tool's run-out; fusee draws none",
            "cncbroachtools: a blind keyway ends in a groove or cross hole, 0.08 in beyond its end; a broach bar needs an open bore",
            {review(kAtLeast, "mm", 2.0)},
            measure_shaft_blind_keyway,
            has_blind_keyway};
}

}  // namespace fusee::checks
