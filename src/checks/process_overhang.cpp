#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"

namespace fusee::checks {

namespace {

constexpr double kShortest = 1e-3;  // [mm]: shorter faces of the section are roundings

/// Steepest lean from the vertical among the faces of the groove's upper half, which look down when the axis stands upright [rad]. A flank
/// of throat T lies at T/2 from the horizontal, so it leans 90 deg - T/2. Section points go from the lower to the upper lip.
double steepest_lean(const std::vector<solid::SectionPoint>& section) {
    double lean = 0.0;
    for (std::size_t i = 1; i < section.size(); ++i) {
        const double out = section[i].offset_mm - section[i - 1].offset_mm, rise = section[i].z_mm - section[i - 1].z_mm;
        if (out > 0.0 && std::hypot(out, rise) > kShortest) lean = std::max(lean, std::atan2(out, rise));
    }
    return lean;
}

core::Findings run(const Design& design) {
    const double limit = process_limits(design.process).overhang;
    if (design.process.kind != ProcessKind::kFdm || limit <= 0.0 || design.part.section.size() < 2) return {};
    core::Finding f = at_most(core::deg_from_rad(steepest_lean(design.part.section)), {core::deg_from_rad(limit), {}}, "deg");
    f.what = "overhang of the groove's upper flank, from the vertical, printed with the axis upright";
    f.where = name(design) + " all along the groove";
    f.suggestion = fmt::format("groove.throat_deg = {:g}", 180.0 - 2.0 * f.allowed);
    return {f};
}

}  // namespace

Rule process_overhang() {
    return {"process.overhang", "a flank that sags in printing", "FDM 45 deg: 3dservicesusa, cifproto, arti90, layerx3d", run};
}

}  // namespace fusee::checks
