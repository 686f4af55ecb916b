#include "words.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/drawing/inspection.h"
#include "view.h"

namespace fusee::drawing {

namespace {

std::string mm(double metres, int digits = 3) { return decimals(core::mm_from_m(metres), digits); }
std::string deg(double rad, int digits = 1) { return decimals(core::deg_from_rad(rad), digits); }

Words key_words(const solid::HubOptions& hub) {
    const checks::KeySize* size = checks::key_size(hub.bore_diameter);
    constexpr double kSame = 1e-9;  // [m]: rounding of a profile's millimetres
    const bool standard = size && std::abs(size->width - hub.key_width) < kSame && std::abs(size->hub_depth - hub.key_depth) < kSame;
    return {standard ? "keyway DIN 6885-1" : "keyway, not DIN 6885-1", fmt::format("b {} P9 (loose: JS9)", mm(hub.key_width)),
            fmt::format("t2 {}, bore + t2 = {}", mm(hub.key_depth), mm(hub.bore_diameter + hub.bore_clearance + hub.key_depth))};
}

std::string cable_note(const Subject& subject) {
    const CableLength length = cable_length(subject.part.cam);
    return fmt::format("Cable \u00d8{}, {}: {:.2f} mm on the working arc, {:.2f} mm from there to the anchor (centreline).",
                       mm(subject.part.cam.options.cable_diameter), subject.cable.construction, core::mm_from_m(length.working),
                       core::mm_from_m(length.to_anchor));
}

std::string travel_note(const cam::Cam& cam) {
    return fmt::format("From the least load to the largest the part turns by {} deg, {} seen from +z.",
                       deg(cam.working.back().arm.angle, 2), cam.rotation_sign > 0 ? "counter-clockwise" : "clockwise");
}

/// Of a helix.
std::string rise_note(const cam::Cam& cam) {
    return fmt::format("The groove rises from z {} to z {} over {} deg.", mm(cam.path(cam.groove_psi.low).z),
                       mm(cam.path(cam.groove_psi.high).z), deg(cam.groove_psi.width()));
}

std::string spring_note(const spring::BaseSpring& spring) {
    if (spring.kind == spring::BaseKind::kTorsion)
        return fmt::format("Base spring: torsion, {:g} Nm/rad, wound by {:g} rad at the least load.", spring.rate, spring.preload);
    return fmt::format("Base spring: compression, {:g} N/m, pressed by {} mm at the least load.", spring.rate, mm(spring.preload));
}

}  // namespace

Words bore_words(const Subject& subject) {
    const solid::HubOptions& hub = subject.part.options.hub;
    const core::Range fit = checks::process_limits(subject.process).fit;
    return {fmt::format("bore \u00d8{} {}", mm(hub.bore_diameter + hub.bore_clearance),
                        hub.kind == solid::HubKind::kThrough ? "through" : "blind"),
            fmt::format("for a shaft of \u00d8{}:", mm(hub.bore_diameter)),
            fmt::format("\u00d8{} to \u00d8{}", mm(hub.bore_diameter + fit.low), mm(hub.bore_diameter + fit.high))};
}

Words lock_words(const solid::HubOptions& hub) {
    const double radius = 0.5 * (hub.bore_diameter + hub.bore_clearance);
    switch (hub.lock) {
        case solid::HubLock::kPlain:
        case solid::HubLock::kSetScrew:
            return {};
        case solid::HubLock::kKeyway:
            return key_words(hub);
        case solid::HubLock::kDFlat:
            return {fmt::format("flat {} from the axis,", mm(radius - hub.flat_depth)),
                    fmt::format("{} over bore and flat", mm(2.0 * radius - hub.flat_depth))};
    }
    return {};
}

Words slot_words(const solid::FeatureOptions& f) {
    return {fmt::format("slot {} x {},", mm(f.leg_slot_width), mm(f.leg_slot_length)),
            fmt::format("{} deep, its middle", mm(f.leg_slot_depth)),
            fmt::format("at R {}, {} deg", mm(f.leg_slot_radius), deg(f.leg_slot_angle))};
}

Words mark_words(const solid::FeatureOptions& f) {
    return {"timing mark at 0 deg,", fmt::format("{} wide, {} deep", mm(f.mark_width), mm(f.mark_depth))};
}

Words notes(const Subject& subject) {
    const cam::Cam& cam = subject.part.cam;
    const bool roller = cam.has_roller();
    const core::Range arc = working_angles(cam);
    Words all{
        "Lengths in mm. Body angles from the timing mark (0 deg, +x), counter-clockwise seen from +z, as the front view shows.",
        fmt::format(
            "The contour is that of the part's files; this sheet states the checks. A mesh deviates from it by at most {} mm (chordal "
            "error).",
            decimals(subject.part.chordal_error_mm, 4)),
        fmt::format("Radii: from the axis to the {}, {}. w: working arc, {} to {} deg, which carries the law{}.",
                    roller ? "rim" : "lowest point of the groove's floor", cam.closed() ? "at z 0" : "at the height z", deg(arc.low, 2),
                    deg(arc.high, 2), roller ? "" : "; h: within the anchor hole"),
        travel_note(cam)};
    if (!cam.closed()) all.push_back(rise_note(cam));
    if (!roller) all.push_back(cable_note(subject));
    all.push_back(spring_note(subject.spring));
    all.emplace_back(roller ? "Deburr the edges; leave the rim as cut." : "Deburr the lips; leave the groove's floor as cut.");
    return all;
}

}  // namespace fusee::drawing
