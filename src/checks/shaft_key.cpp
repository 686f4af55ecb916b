#include <fmt/format.h>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"

namespace fusee::checks {

namespace {

/// A size that ought to be exactly `wanted`: the bound is the side on which it misses.
core::Finding exactly(double measured, double wanted, const std::string& what, const std::string& key) {
    core::Finding f = at_least(core::mm_from_m(measured), {{}, core::mm_from_m(wanted)}, "mm");
    if (f.severity == core::Severity::kPass) f = at_most(core::mm_from_m(measured), {{}, core::mm_from_m(wanted)}, "mm");
    f.what = what;
    f.suggestion = fmt::format("{} = {:g}", key, core::mm_from_m(wanted));
    return f;
}

core::Findings run(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (hub.lock != solid::HubLock::kKeyway) return {};
    const std::string keys = name(design) + ".hub.";
    const double bore = core::mm_from_m(hub.bore_diameter);
    if (const KeySize* size = key_size(hub.bore_diameter))
        return {
            exactly(hub.key_width, size->width, fmt::format("width b of the keyway in a {:g} mm bore", bore), keys + "key_width_mm"),
            exactly(hub.key_depth, size->hub_depth, fmt::format("depth t2 of the keyway in a {:g} mm bore", bore), keys + "key_depth_mm")};
    const double least = core::mm_from_m(key_table().front().above), most = core::mm_from_m(key_table().back().up_to);
    core::Finding f = bore < least ? at_least(bore, {{}, least}, "mm") : at_most(bore, {{}, most}, "mm");
    f.what = "bore with a keyway: the table has no key for this shaft";
    f.suggestion = bore < least ? fmt::format("{0}lock = \"d_flat\", or {0}bore_mm = {1:g}", keys, least)
                                : fmt::format("{}bore_mm = {:g}", keys, most);
    return {f};
}

}  // namespace

Rule shaft_key() { return {"shaft.key", "a keyway that no bought key fits", "DIN 6885-1", run}; }

}  // namespace fusee::checks
