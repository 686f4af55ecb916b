#include "means.h"

namespace fusee::checks {

namespace {

/// A size that should be that of the standard.
core::Finding exactly(const Design& design, const char* key, double measured, const EffectiveLimit& least, const EffectiveLimit& most,
                      const std::string& what) {
    core::Finding f = compare(mm_from_m(measured), {least, most});
    f.what = what;
    f.suggestion = change(design, key, number(f.allowed));
    return f;
}

core::Findings measure_shaft_key(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kKeyway) return {};

    const double bore = mm_from_m(hub.bore_diameter);
    if (const KeySize* size = key_size(hub.bore_diameter)) {
        const double b = mm_from_m(size->width), t2 = mm_from_m(size->hub_depth);
        return {exactly(design, "hub.key_width_mm", hub.key_width, allowed("least_width_review", b), allowed("width_review", b),
                        fmt::format("width b of the keyway in a {:g} mm bore", bore)),
                exactly(design, "hub.key_depth_mm", hub.key_depth, allowed("least_depth_review", t2), allowed("depth_review", t2),
                        fmt::format("depth t2 of the keyway in a {:g} mm bore", bore))};
    }
    const double least = mm_from_m(key_table().front().above), most = mm_from_m(key_table().back().up_to);
    core::Finding f = compare(bore, {allowed("least_bore_review", least), allowed("bore_review", most)});
    f.what = "bore with a keyway: the table has no key for this shaft";
    if (bore < least) f.suggestion = change(design, "hub.lock", quoted("d_flat"));
    f.suggestion.or_else(change(design, "hub.bore_mm", number(bore < least ? least : most)));
    return {f};
}

}  // namespace

Rule shaft_key() {
    return {"shaft.key",
            "a keyway that no bought key fits",
            "b and t2 of the keyway; its bore, where the table has no key",
            "DIN 6885-1",
            {review(kAtLeast, "mm", "table 4", "least_width_review"), review(kAtMost, "mm", "table 4", "width_review"),
             review(kAtLeast, "mm", "table 4", "least_depth_review"), review(kAtMost, "mm", "table 4", "depth_review"),
             review(kAtLeast, "mm", "table 4", "least_bore_review"), review(kAtMost, "mm", "table 4", "bore_review")},
            measure_shaft_key};
}

}  // namespace fusee::checks
