#include "words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/drawing/inspection.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/stack.h"
#include "tolerances.h"
#include "view.h"

namespace fusee::drawing {

namespace {

constexpr double kPlay = 0.1e-3;  // of a key in its way, as an example [m]

std::string mm(double metres, int digits = 3) { return decimals(core::mm_from_m(metres), digits); }
std::string deg(double rad, int digits = 1) { return decimals(core::deg_from_rad(rad), digits); }

/// One fit: what the process leaves, the tight one of the standard where it holds that, or by hand. The depth's deviation is that of DIN
/// 6885-1, or the process's.
Words key_words(const Subject& subject) {
    constexpr double kHoldsP9 = 12.5e-6, kWide = 6e-3;  // half of IT9 up to 3 mm (ISO 286); b from which t2 may be 0.2 mm deeper
    const solid::HubOptions& hub = subject.part.options.hub;
    const bool by_hand = hub.key_fit == solid::KeyFit::kByHand;
    const double tolerance = checks::process_limits(subject.process).tolerance, deeper = hub.key_width > kWide ? 0.2e-3 : 0.1e-3;
    const std::string fit = by_hand ? ", fitted by hand" : tolerance <= kHoldsP9 ? " P9" : fmt::format(" \u00b1{}", mm(tolerance));
    const checks::KeySize* size = checks::key_size(hub.bore_diameter);
    constexpr double kSame = 1e-9;  // [m]: rounding of a profile's millimetres
    const bool standard = size && std::abs(size->width - hub.key_width) < kSame && std::abs(size->hub_depth - hub.key_depth) < kSame;
    return {standard ? "keyway DIN 6885-1" : "keyway, not DIN 6885-1", fmt::format("b {}{}", mm(hub.key_width), fit),
            fmt::format("t2 {} +{}/0,", mm(hub.key_depth), mm(by_hand ? deeper : std::max(deeper, tolerance))),
            fmt::format("bore + t2 = ({})", mm(hub.bore_diameter + hub.bore_clearance + hub.key_depth))};
}

std::string cable_note(const Subject& subject) {
    const CableLength length = cable_length(subject.part.cam);
    return fmt::format("Cable \u00d8{}, {}: {:.2f} mm on the working arc, {:.2f} mm from there to the anchor (centreline).",
                       mm(subject.part.cam.options.cable_diameter), subject.cable.construction, core::mm_from_m(length.working),
                       core::mm_from_m(length.to_anchor));
}

std::string travel_note(const Subject& subject) {
    const cam::Cam& cam = subject.part.cam;
    return fmt::format("From the {} to the {} the part turns by {} deg, {} seen from +z.", beginning_of(subject), end_of(subject),
                       deg(cam.working.back().arm.angle, 2), cam.rotation_sign > 0 ? "counter-clockwise" : "clockwise");
}

/// The note on the rise of a helix.
std::string rise_note(const cam::Cam& cam) {
    return fmt::format("The groove rises from z {} to z {} over {} deg.", mm(cam.path(cam.groove_psi.low).z),
                       mm(cam.path(cam.groove_psi.high).z), deg(cam.groove_psi.width()));
}

std::string spring_note(const Subject& subject) {
    const spring::BaseSpring& spring = subject.spring;
    if (spring.kind == spring::BaseKind::kTorsion)
        return fmt::format("Base spring: torsion, {:g} Nm/rad, wound by {:g} rad at the {}.", spring.rate, spring.preload,
                           beginning_of(subject));
    return fmt::format("Base spring: compression, {:g} N/m, pressed by {} mm at the {}.", spring.rate, mm(spring.preload),
                       beginning_of(subject));
}

/// The plates of a stack, from below.
std::string plates_note(const Subject& subject) {
    const double rib = subject.part.options.groove.rib;
    return fmt::format(
        "Cut as plates 1 to 3, from below {0}, {1} and {0} thick: {2}_plate_1.dxf to {2}_plate_3.dxf. In line on the dowels and bonded.",
        mm(rib), mm(solid::core_thickness(subject.part)), subject.name);
}

/// Names of the title block's fields without a value.
Words empty_fields(const TitleOptions& title) {
    Words empty;
    for (const auto& [name, value] : {std::pair{"legal owner", &title.owner},
                                      {"identification number", &title.number},
                                      {"revision", &title.revision},
                                      {"date of issue", &title.date},
                                      {"created by", &title.created_by},
                                      {"approved by", &title.approved_by}})
        if (value->empty()) empty.emplace_back(name);
    return empty;
}

}  // namespace

bool is_of_spring(const Subject& subject) { return subject.name.starts_with("cam"); }
bool pulls_back(const Subject& subject) { return subject.name == "cam_back"; }
const char* beginning_of(const Subject& subject) { return pulls_back(subject) ? "last angle" : subject.beginning(); }
const char* end_of(const Subject& subject) { return pulls_back(subject) ? "first" : is_of_spring(subject) ? "last" : "largest"; }

Words bore_words(const Subject& subject) {
    const solid::HubOptions& hub = subject.part.options.hub;
    const core::Range fit = checks::process_limits(subject.process).fit;
    return {fmt::format("bore \u00d8{} {}", mm(hub.bore_diameter + hub.bore_clearance),
                        hub.kind == solid::HubKind::kThrough ? "through" : "blind"),
            fmt::format("for a shaft of \u00d8{}:", mm(hub.bore_diameter)),
            fmt::format("\u00d8{} to \u00d8{}", mm(hub.bore_diameter + fit.low), mm(hub.bore_diameter + fit.high))};
}

std::vector<Badge> bore_badges(const Subject& subject) {
    const Tolerances t = tolerances_of(subject);
    return {{Symbol::kDatum, {"A"}}, roughness_badge(t, t.fine_roughness)};
}

std::vector<Badge> lock_badges(const Subject& subject) {
    return {frame(Symbol::kPosition, tolerances_of(subject).position, kDatumA), {Symbol::kDatum, {"B"}}};
}

Words flat_words(const solid::HubOptions& hub) {
    const double radius = 0.5 * (hub.bore_diameter + hub.bore_clearance);
    return {fmt::format("flat {} from the axis,", mm(radius - hub.flat_depth)),
            fmt::format("{} over bore and flat", mm(2.0 * radius - hub.flat_depth))};
}

Words lock_words(const Subject& subject) {
    const solid::HubOptions& hub = subject.part.options.hub;
    switch (hub.lock) {
        case solid::HubLock::kPlain:
        case solid::HubLock::kSetScrew:
            return {};
        case solid::HubLock::kKeyway:
            return key_words(subject);
        case solid::HubLock::kDFlat:
            return flat_words(hub);
    }
    return {};
}

std::string deep_words(const solid::Part& part, const char* opening, double depth_mm) {
    if (!solid::is_stack(part.cam, part.options)) return decimals(depth_mm) + " deep";
    const std::vector<solid::Plate> plates = solid::stack_plates(part);
    const auto through = std::count_if(plates.begin(), plates.end(), [&](const solid::Plate& plate) {
        return std::any_of(plate.openings.begin(), plate.openings.end(), [&](const solid::Opening& o) { return o.name == opening; });
    });
    return through == 1 ? "plate 3" : through == 2 ? "plates 2 and 3" : "all plates";
}

Words slot_words(const solid::Part& part) {
    const solid::FeatureOptions& f = part.options.features;
    return {fmt::format("slot {} x {},", mm(f.leg_slot_width), mm(f.leg_slot_length)),
            deep_words(part, "leg_slot", core::mm_from_m(f.leg_slot_depth)) + ", its middle",
            fmt::format("at R {}, {} deg", mm(f.leg_slot_radius), deg(f.leg_slot_angle))};
}

Words mark_words(const solid::Part& part) {
    const solid::FeatureOptions& f = part.options.features;
    return {fmt::format("timing mark at {} deg,", deg(solid::mark_angle(part), 0)),
            solid::is_stack(part.cam, part.options) ? "scribed on plate 3"
                                                    : fmt::format("{} wide, {} deep", mm(f.mark_width), mm(f.mark_depth))};
}

Words notes(const Subject& subject) {
    const cam::Cam& cam = subject.part.cam;
    Words all{
        fmt::format(
            "Lengths in mm. Body angles from +x (0 deg; the timing mark is at {} deg), counter-clockwise seen from +z, as the front "
            "view shows.",
            deg(solid::mark_angle(subject.part), 0)),
        fmt::format("The contour is that of the part's files; this drawing states the checks. A mesh deviates from it by at most {} mm.",
                    decimals(subject.part.chordal_error_mm, 4)),
        travel_note(subject)};
    if (!cam.closed()) all.push_back(rise_note(cam));
    if (solid::is_stack(cam, subject.part.options)) all.push_back(plates_note(subject));
    if (!cam.has_roller()) all.push_back(cable_note(subject));
    all.push_back(spring_note(subject));
    if (const Words empty = empty_fields(subject.title); !empty.empty())
        all.push_back(fmt::format("Not stated in the profile, [drawing]: {}.", fmt::join(empty, ", ")));
    return all;
}

Words tolerance_notes(const Subject& subject) {
    const cam::Cam& cam = subject.part.cam;
    const auto ends = arc_ends(subject.part);
    const CheckRow &from = ends.front(), &to = ends.back();  // as the rows and the marks P and Q
    const auto angle = [&](const CheckRow& row) { return cam.closed() ? core::within_turn(row.angle, 0.0) : row.angle; };
    const Tolerances t = tolerances_of(subject);
    const bool roller = cam.has_roller();
    Words all{fmt::format("Tolerances ISO 1101, datums ISO 5459, ISO 8015. A: axis of the bore. B: {}.", t.datum_b),
              fmt::format(
                  "P to Q: working arc, {} to {} deg, which carries the law. Its profile {} is the accuracy of the process, \u00b1{}, not "
                  "what the law needs.",
                  deg(angle(from), 2), deg(angle(to), 2), mm(t.contour), mm(t.process))};
    if (!roller && !cam.working.empty()) {
        const auto least = std::min_element(cam.working.begin(), cam.working.end(),
                                            [](const cam::Contact& a, const cam::Contact& b) { return a.arm.arm < b.arm.arm; });
        all.push_back(fmt::format("\u00b1{} is \u00b1{:.1f} % of the least arm, {}: an error of 1 % of the arm needs a profile of {}.",
                                  mm(t.process), 100.0 * t.process / least->arm.arm, mm(least->arm.arm), mm(0.02 * least->arm.arm)));
        const double turned = kPlay / (0.5 * subject.part.options.hub.bore_diameter);
        all.push_back(
            fmt::format("Every {} of play across B at the bore turns the contour by {:.2f} deg: the arm is off by up to {:.1f} %. Set the "
                        "zero by the mark.",
                        mm(kPlay), core::deg_from_rad(turned), 100.0 * turned * arm_error_per_turn(cam)));
    }
    all.push_back(fmt::format("Roughness ISO 21920: Ra {} where nothing else is stated. Edges ISO 13715.", decimals(1e6 * t.roughness)));
    all.emplace_back(roller ? "Deburr the edges; leave the rim as cut." : "Deburr the lips; leave the groove's floor as cut.");
    return all;
}

Words check_notes(const solid::Part& part) {
    const bool roller = part.cam.has_roller();
    Words all{fmt::format("X, Y: {}. normal: direction of the outward normal. tilt: of the normal against the radius.",
                          roller              ? "of the rim"
                          : part.cam.closed() ? "of the groove's floor at its lowest, at z 0"
                                              : "of the groove's floor at its lowest")};
    if (roller)
        all.emplace_back("The arm of a roller cam follows the slope of the rim: an equal error everywhere does not change it.");
    else
        all.emplace_back(
            "Measure along the normal: there a deviation is an error of the arm of the same size. A radius that is off by dr at the same "
            "angle "
            "is an arm that is off by dr x cos(tilt), the last column.");
    all.push_back(fmt::format("Radii of the {}: w: working arc{}.", roller ? "rim" : "floor", roller ? "" : "; h: within the anchor hole"));
    all.emplace_back("The inspection sheet (k_xx_inspection.csv) holds these rows to fill in; `fusee calibrate` reads it.");
    return all;
}

}  // namespace fusee::drawing
