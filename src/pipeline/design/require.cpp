#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

void require_joint(const profile::Profile& profile, const char* what) {
    if (profile.is_spring())
        throw core::InvalidInput("kind", "\"spring\"", fmt::format("\"joint\" for {}: it needs both springs and their rig", what));
}

void require_one_cable(const profile::Profile& profile, const char* what) {
    if (profile.has_two_cables())
        throw core::InvalidInput("cam.family", "\"two_cables\"",
                                 fmt::format("another family for {}: both cables have equal springs, and what suits one need not suit the "
                                             "other; `fusee design` finds them for both",
                                             what));
}

void require_parts(const profile::Profile& profile) {
    if (profile.rig.arrangement != actuator::Arrangement::kPnrvsa)
        throw core::InvalidInput("rig.arrangement", to_string(profile.rig.arrangement),
                                 "\"pnrvsa\" to make parts; the others can be simulated");
    if (!profile.has_parts && profile.is_spring())
        throw core::InvalidInput("cam.family", "missing", "[cable], [process], [cam] and [cam.spring] to make the part");
    if (!profile.has_parts)
        throw core::InvalidInput(
            "k_se.spring.rate_Nm_per_rad", "missing",
            "[cable], [process], [k_se.spring] and [k_pe.spring] to make parts; without them a profile can be simulated");
    if (profile.has_two_cables() && profile.k_pe.solid.hub.kind == solid::HubKind::kOverhung)
        throw core::InvalidInput("cam.hub.kind", "\"overhung\"", "\"through\" for two cables: both parts are on one shaft");
    if (profile.outputs.has("dxf") && profile.outputs.kerf > 0.0)
        for (const cam::PartKind kind : profile.part_kinds())
            exchange::require_kerf(core::mm_from_m(profile.outputs.kerf), profile.part(kind).solid.hub);
}

}  // namespace fusee::pipeline
