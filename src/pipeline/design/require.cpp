#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

void require_parts(const profile::Profile& profile) {
    if (profile.rig.arrangement != actuator::Arrangement::kPnrvsa)
        throw core::InvalidInput("rig.arrangement", to_string(profile.rig.arrangement),
                                 "\"pnrvsa\" to make parts; the others can be simulated");
    if (!profile.has_parts)
        throw core::InvalidInput(
            "k_se.spring.rate_Nm_per_rad", "missing",
            "[cable], [process], [k_se.spring] and [k_pe.spring] to make parts; without them a profile can be simulated");
    if (profile.outputs.has("dxf") && profile.outputs.kerf > 0.0)
        for (const profile::PartSpec* spec : {&profile.k_se, &profile.k_pe})
            exchange::require_kerf(core::mm_from_m(profile.outputs.kerf), spec->solid.hub);
}

}  // namespace fusee::pipeline
