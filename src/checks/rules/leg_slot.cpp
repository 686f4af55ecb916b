#include "means.h"

namespace fusee::checks {

namespace {

constexpr int kAlong = 8;  // points along the slot

struct Walls {
    double inner = 0.0, outer = 0.0;  ///< to the bore, to groove floor or rim [m]
    bool bored = false;
};

/// Above the groove the slot may extend to the rim; beside the groove only to its floor.
double outer_offset(const Design& design) {
    const solid::Part& part = design.part;
    if (part.section.empty()) return -0.5 * design.cable.diameter;
    double top = part.cam.working.empty() ? 0.0 : part.cam.working.front().path.z;
    for (const cam::Contact& c : part.cam.working) top = std::max(top, c.path.z);
    const bool above = part.options.features.leg_slot_depth <= part.z_high - top - 0.5 * groove_width(part);
    return above ? lip_offset(part) : -0.5 * design.cable.diameter;
}

Walls slot_walls(const Design& design) {
    const Slot slot = leg_slot(design.part.options.features);
    const solid::HubOptions& hub = design.part.options.hub;
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    const double offset = outer_offset(design);
    Walls w;
    w.bored = hub.kind == solid::HubKind::kThrough;
    for (int i = 0; i <= kAlong; ++i) {
        const double share = static_cast<double>(i) / kAlong;
        const Vec2 q{slot.inner[0] + share * (slot.outer[0] - slot.inner[0]), slot.inner[1] + share * (slot.outer[1] - slot.inner[1])};
        const double inner = distance_to_bore(hub, q) - slot.radius, outer = distance_inside(path, offset, q).distance - slot.radius;
        w.inner = i == 0 ? inner : std::min(w.inner, inner);
        w.outer = i == 0 ? outer : std::min(w.outer, outer);
    }
    return w;
}

constexpr double kShortest = 1.05;  // length of a slot over its width, at least

core::Findings measure_structure_leg_slot(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    if (!has_slot(features) || design.part.cam.working.empty()) return {};
    const Walls w = slot_walls(design);
    const ProcessLimits process = process_limits(design.process);
    const bool inwards = w.bored && w.inner < w.outer;
    core::Finding f = compare(mm_from_m(inwards ? w.inner : w.outer),
                              {allowed("required", mm_from_m(process.wall)), allowed("review", mm_from_m(process.loaded_wall))});
    f.what = fmt::format("wall between the spring leg's slot and the {}", inwards ? "bore" : "groove");
    f.where = at_leg_slot(design);
    f.place = core::Place{features.leg_slot_angle,
                          {mm_from_m(leg_slot(features).outer[0]), mm_from_m(leg_slot(features).outer[1]), mm_from_m(design.part.z_high)}};
    const double lacking = m_from_mm(f.allowed - f.measured), space = w.bored ? w.inner + w.outer - 2.0 * m_from_mm(f.allowed) : lacking;
    // Move the slot if the other side has the space; otherwise shorten it by the total lack. A slot must be longer than it is wide.
    const double shorter = features.leg_slot_length + space;
    if (shorter < kShortest * features.leg_slot_width) {
        f.suggestion = change(design, "features.leg_slot_width_mm", "0")
                           .noted(fmt::format(" and the leg held outside the part: {} mm are missing for the slot",
                                              up(mm_from_m(kShortest * features.leg_slot_width - shorter))));
        return {f};
    }
    const double aside = space >= 0.0 ? (inwards ? lacking : -lacking) : 0.5 * (w.outer - w.inner);
    const std::string radius = fmt::format("{:.3f}", mm_from_m(features.leg_slot_radius + aside));
    f.suggestion = space >= 0.0 ? change(design, "features.leg_slot_radius_mm", radius)
                                : change(design, "features.leg_slot_length_mm", fmt::format("{:.3f}", mm_from_m(shorter)))
                                      .with(key_of(design, "features.leg_slot_radius_mm"), radius);
    return {f};
}

core::Findings measure_structure_slot_floor(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    if (!has_slot(features)) return {};
    const ProcessLimits process = process_limits(design.process);
    const double left = design.part.z_high - design.part.z_low - features.leg_slot_depth;
    core::Finding f =
        compare(mm_from_m(left), {allowed("required", mm_from_m(process.wall)), allowed("review", mm_from_m(process.loaded_wall))});
    f.what = "material under the spring leg's slot";
    f.where = at_leg_slot(design);
    const double depth = mm_from_m(features.leg_slot_depth) + f.measured - f.allowed;
    f.suggestion = depth > 0.0 ? change(design, "features.leg_slot_depth_mm", down(depth))
                               : change("groove.rib_mm", up(mm_from_m(design.part.options.groove.rib) + f.allowed - f.measured));
    return {f};
}

}  // namespace

Rules leg_slot_rules() {
    return {
        {"structure.leg_slot",
         "the spring leg's slot breaking into bore or groove",
         "least wall from the slot to bore and groove floor (to the rim if it lies above the groove)",
         "the process's walls: thin required, loaded recommended",
         {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))},
         measure_structure_leg_slot},
        {"structure.slot_floor",
         "the spring leg's slot breaking through the part",
         "material under the slot",
         "the process's walls: thin required, loaded recommended",
         {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))},
         measure_structure_slot_floor},
    };
}

}  // namespace fusee::checks
