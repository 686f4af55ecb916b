#include "fusee/checks/support.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_fdm_bridge(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (design.process.kind != ProcessKind::kFdm || hub.kind != solid::HubKind::kOverhung) return {};
    core::Finding f = compare(mm_from_m(2.0 * bore_radius(hub)), {allowed("review")});
    f.what = "span of the ceiling over the blind bore, printed with its boss on the bed";
    f.suggestion = change(design, "hub.bore_mm", down(f.allowed - mm_from_m(hub.bore_clearance)));
    return {f};
}

core::Findings measure_fdm_elephant_foot(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kFdm) return {};
    core::Finding f = compare(mm_from_m(design.part.options.hub.bore_clearance), {allowed("review")});
    f.what = "clearance of the bore, which the squeezed first layer reduces";
    f.where = name(design) + " at the bore's mouth";
    f.suggestion = change(design, "hub.clearance_mm", number(f.allowed)).or_else("a chamfer there");
    return {f};
}

core::Findings measure_fdm_layers(const Design& design, const Allowed& allowed) {
    const double layer = process_limits(design.process).layer;
    if (design.process.kind != ProcessKind::kFdm || layer <= 0.0) return {};
    const double radius = design.part.options.groove.radius_ratio * design.cable.diameter;
    core::Finding f = compare(radius / layer, {allowed("review")});
    f.what = fmt::format("number of {:g} mm layers that make up the groove's floor, radius {:.3f} mm", mm_from_m(layer), mm_from_m(radius));
    f.where = along_groove(design);
    f.suggestion = change("process.layer_mm", down(mm_from_m(radius / f.allowed)));
    return {f};
}

core::Findings measure_fdm_support(const Design& design, const Allowed& allowed) {
    const double limit = process_limits(design.process).overhang;
    const solid::Mesh& mesh = design.part.mesh;
    if (design.process.kind != ProcessKind::kFdm || limit <= 0.0 || mesh.triangles.empty()) return {};
    const double upright = unsupported_mm2(mesh, limit, false), flipped = unsupported_mm2(mesh, limit, true);
    core::Finding f = compare(std::min(upright, flipped), {allowed("review")});
    f.what = fmt::format(
        "faces that need support, more than {:g} deg from the vertical, with the {} on the bed as in plate.3mf ({:.0f} mm^2 with the {} "
        "on the bed{})",
        deg_from_rad(limit), upright <= flipped ? "bottom" : "top", std::max(upright, flipped), upright <= flipped ? "top" : "bottom",
        upright <= flipped ? "" : ", as in the part's own files");
    f.suggestion = fmt::format("turn on supports, {} mm^2", up(f.measured));
    return {f};
}

core::Findings measure_sla_drain(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (design.process.kind != ProcessKind::kSla || hub.kind != solid::HubKind::kOverhung) return {};
    const double bore = 2.0 * bore_radius(hub);
    core::Finding f = compare(bore_length(design.part) / bore, {allowed("review")});
    f.what = "depth of the blind bore over its diameter: resin stays in it";
    f.suggestion = "a drain hole at its end";
    f.suggestion.or_else(
        change(design, "hub.boss_height_mm", down(mm_from_m(hub.boss_height) - (f.measured - f.allowed) * mm_from_m(bore))));
    return {f};
}

core::Findings measure_sla_support(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kSla || design.part.section.size() < 2) return {};
    core::Finding f = compare(deg_from_rad(largest_overhang(design.part)), {allowed("review")});
    f.what = "angle of the groove's upper flank from the vertical; above the limit it needs supports where the cable runs";
    f.where = along_groove(design);
    f.suggestion = change("groove.throat_deg", number(180.0 - 2.0 * f.allowed));
    return {f};
}

core::Findings measure_sls_groove(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kSls || design.part.section.size() < 2) return {};
    const double width = 2.0 * half_width_at_cable(design.part);
    core::Finding f = compare(mm_from_m(width), {allowed("review")});
    f.what = "width of the groove at the height of the cable's centreline";
    f.where = along_groove(design);
    f.suggestion = change("cable.diameter_mm", up(mm_from_m(design.cable.diameter) * f.allowed / f.measured));
    return {f};
}

core::Findings measure_sls_hole_depth(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kSls) return {};
    return {judge_slenderest_hole(design, {allowed("review")})};
}

}  // namespace

Rules printed_rules() {
    return {
        {"fdm.bridge",
         "a blind bore whose ceiling sags",
         "FDM, overhung: span of the ceiling over the blind bore",
         "no sag below 5 mm, at most 0.2 mm up to 20 mm (3dorchard): the shaft ends a layer earlier; 10 mm: 3dservicesusa, cifproto, "
         "arti90, "
         "layerx3d",
         {review(kAtMost, "mm", 10.0)},
         measure_fdm_bridge},
        {"fdm.elephant_foot",
         "a bore narrowed by the squeezed first layer",
         "FDM: clearance of the bore, which opens on the bed",
         "0.1 mm a side (practice)",
         {review(kAtLeast, "mm", 0.2)},
         measure_fdm_elephant_foot},
        on_cable({"fdm.layers",
                  "a groove's floor printed as steps",
                  "FDM: layers in the radius of the groove's floor",
                  "two layers (practice)",
                  {review(kAtLeast, "layers", 2.0)},
                  measure_fdm_layers}),
        {"fdm.support",
         "ceilings that a printer cannot bridge",
         "area of downward faces beyond the overhang + 1 deg, in the better of both orientations",
         "FDM bridge 5-10 mm: 3dservicesusa, cifproto, arti90, layerx3d; a square of 5 mm",
         {review(kAtMost, "mm^2", 25.0)},
         measure_fdm_support,
         nullptr,
         {},
         true},
        {"sla.drain",
         "a blind bore that traps resin",
         "SLA, overhung: depth of the blind bore, in its diameters",
         "one diameter (practice)",
         {review(kAtMost, "diameters", 1.0)},
         measure_sla_drain},
        on_cable({"sla.support",
                  "supports that scar the groove",
                  "SLA, axis upright: angle of the groove's upper flank from the vertical",
                  "addema, iamrapid: guides for SLA: faces without support at least 19 deg from level; addema adds that they be shorter "
                  "than 1 mm, "
                  "which this rule does not judge",
                  {review(kAtMost, "deg", 71.0)},
                  measure_sla_support}),
        on_cable({"sls.groove",
                  "a groove that sintered powder closes",
                  "SLS: width of the groove at the cable's height",
                  "clearance 0.2-0.5 mm: 3dservicesusa, cifproto, arti90, layerx3d",
                  {review(kAtLeast, "mm", 0.5)},
                  measure_sls_groove}),
        {"sls.hole_depth",
         "a hole that traps powder",
         "SLS: depth of the slenderest hole, in its diameters",
         "5 diameters (practice)",
         {review(kAtMost, "diameters", 5.0)},
         measure_sls_hole_depth},
    };
}

}  // namespace fusee::checks
