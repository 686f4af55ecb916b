#include <limits>
#include <vector>

#include "fusee/cam/contact.h"
#include "means.h"

namespace fusee::checks {

namespace {

struct Neighbour {
    double wall;  ///< from the hole's edge [m]
    const char* what;
    bool from_inside = true;  ///< a smaller hole, whose far edge stays at the pitch curve, leaves a thicker wall
    bool turns = false;       ///< it may be moved to another angle
};

/// The neighbours of the hole, which runs axially from the groove's plane to a face.
std::vector<Neighbour> neighbours(const Design& design, const cam::PathPoint& anchor, Vec2 centre, double radius) {
    const solid::PartOptions& options = design.part.options;
    std::vector<Neighbour> all;
    if (options.hub.kind == solid::HubKind::kThrough) all.push_back({distance_to_bore(options.hub, centre) - radius, "bore"});
    if (solid::anchor_leads_down(design.part.cam, options)) return all;  // neither slot nor turns are below it
    if (has_slot(options.features)) all.push_back({leg_slot(options.features).distance(centre) - radius, "spring leg's slot", true, true});
    if (design.part.cam.closed()) return all;
    std::vector<cam::PathPoint> above;  // turns between the hole's start and the top
    for (const cam::PathPoint& p : contour(design.part.cam))
        if (p.z > anchor.z && std::abs(p.psi - anchor.psi) > core::kPi) above.push_back(p);
    if (!above.empty())
        all.push_back({distance_inside(above, -0.5 * design.cable.diameter, centre).distance - radius, "groove of the turns above", false});
    return all;
}

core::Findings measure_structure_anchor(const Design& design, const Allowed& allowed) {
    const auto hole = anchor_hole(design.part);
    if (!hole) return {};
    const auto& [centre, radius, anchor] = *hole;
    const std::vector<Neighbour> all = neighbours(design, anchor, centre, radius);
    if (all.empty()) return {};
    const Neighbour nearest =
        *std::min_element(all.begin(), all.end(), [](const Neighbour& a, const Neighbour& b) { return a.wall < b.wall; });
    core::Finding f = compare(mm_from_m(nearest.wall), {allowed("required", mm_from_m(process_limits(design.process).wall))});
    f.what = fmt::format("wall between the cable's anchor hole and the {}", nearest.what);
    f.where = at_anchor(design);
    f.place = place(anchor, -radius);
    const double smaller = 2.0 * radius - m_from_mm(f.allowed - f.measured);  // its far edge stays at the pitch curve
    f.suggestion = nearest.from_inside && smaller > 0.0 ? change(design, "features.anchor_hole_mm", down(mm_from_m(smaller)))
                                                        : without_anchor_hole(design);
    if (nearest.turns)
        f.suggestion.or_else(change(design, "features.leg_slot_angle_deg",
                                    fmt::format("{:.0f}", deg_from_rad(std::atan2(-centre[1], -centre[0])))));  // opposite the hole
    return {f};
}

struct Clearance {
    double gap = 0.0;  ///< from the hole's edge to the floor of the working arc [m]
    cam::PathPoint at;
};

/// Distance of an anchor hole at `psi` from the working floor. `structure.anchor` judges the other turns of a helix.
Clearance clearance(const cam::Cam& cam, double psi, double radius) {
    const cam::PathPoint anchor = cam.path(psi);
    const core::Place hole = place(anchor, -radius);  // it touches the pitch curve from inside
    Clearance least{std::numeric_limits<double>::infinity(), anchor};
    for (const cam::Contact& c : cam.working) {
        if (!cam.closed() && std::abs(c.path.psi - psi) > core::kPi) continue;
        const core::Place floor = place(c.path, -0.5 * cam.options.cable_diameter);
        const double apart = m_from_mm(std::hypot(floor.point_mm[0] - hole.point_mm[0], floor.point_mm[1] - hole.point_mm[1])) - radius;
        if (apart < least.gap) least = {apart, c.path};
    }
    return least;
}

core::Findings measure_structure_anchor_floor(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const double radius = 0.5 * design.part.options.features.anchor_hole_diameter;
    if (radius <= 0.0 || !cam.path || cam.working.empty()) return {};
    const Clearance found = clearance(cam, cam.anchor_psi, radius);
    core::Finding f = compare(mm_from_m(found.gap), {allowed("required", mm_from_m(0.5 * design.cable.diameter))});
    f.what = "distance from the anchor hole to the working floor";
    locate(f, design, found.at, -0.5 * cam.options.cable_diameter);
    f.suggestion = without_anchor_hole(design);
    for (const double margin : cam::margins_by_distance(cam)) {
        if (clearance(cam, cam::anchor_direction(cam, margin), radius).gap < 0.55 * design.cable.diameter) continue;
        f.suggestion = change(design, "path.margin_deg", fmt::format("{:.0f}", deg_from_rad(margin)));
        break;
    }
    return {f};
}

constexpr double kLeastFleet = rad_from_deg(2.0);

core::Findings measure_structure_flange_bending(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.working.empty() || design.part.section.empty()) return {};
    const double rib = design.part.options.groove.rib, lever = 0.5 * design.cable.diameter;
    const double thickness = rib + 0.5 * groove_width(design.part) - half_width_at_cable(design.part);
    const auto stress = [&](const cam::Contact& c) {
        const double aside = c.arm.tension / c.path.rho * std::tan(std::max(std::abs(c.fleet), kLeastFleet));
        return 6.0 * aside * lever / (thickness * thickness);
    };
    const cam::Contact& worst = worst_contact(cam, stress);
    core::Finding f = compare(stress(worst) / kPaPerMPa, {allowed("review", material_of(design.process).permanent / kPaPerMPa)});
    f.what = fmt::format("bending stress of the flange beside the cable at {:.1f} N", worst.arm.tension);
    locate(f, design, worst.path);
    const double thicker = thickness * std::sqrt(f.measured / f.allowed) - thickness;
    f.suggestion = change("groove.rib_mm", up(mm_from_m(rib + thicker)));
    return {f};
}

core::Findings measure_structure_flange_slenderness(const Design& design, const Allowed& allowed) {
    const solid::PartOptions& options = design.part.options;
    const double height = options.groove.depth_ratio * design.cable.diameter + options.flange_height;
    core::Finding f = compare(height / options.groove.rib, {allowed("review")});
    f.what = fmt::format("height of the flange over the groove's floor, {:.2f} mm, over its thickness", mm_from_m(height));
    f.suggestion = change("groove.rib_mm", up(mm_from_m(height / f.allowed)));
    const double lower = options.flange_height - height + f.allowed * options.groove.rib;
    if (options.flange_height > 0.0 && lower >= 0.0) f.suggestion.or_else(change(design, "flange_height_mm", down(mm_from_m(lower))));
    return {f};
}

core::Findings measure_structure_hole_edge(const Design& design, const Allowed& allowed) {
    const auto hole = anchor_hole(design.part);
    if (!hole || !design.part.cam.closed() || design.part.section.empty()) return {};
    const double rim = lip_offset(design.part) + design.part.options.flange_height;
    const Nearest nearest = distance_inside(contour(design.part.cam), rim, hole->centre);
    core::Finding f =
        compare(mm_from_m(nearest.distance - hole->radius), {allowed("review", mm_from_m(process_limits(design.process).wall))});
    f.what = "wall between the cable's anchor hole and the rim of the upper flange";
    locate(f, design, hole->at);
    f.suggestion = change(design, "flange_height_mm", up(mm_from_m(design.part.options.flange_height) + f.allowed - f.measured));
    return {f};
}

constexpr double kSampled = 1e-6;  // the closing arc reaches its least radius between samples

/// The ends of the working arc belong to it in any turn; otherwise a part and its mirror image would differ.
bool is_idle(const cam::Cam& cam, double psi) {
    constexpr double kRounding = 1e-9;  // [rad]
    const core::Range working = cam.working_psi;
    if (cam.closed() && psi > working.low + core::kTurn - kRounding) return false;
    return psi < working.low - kRounding || psi > working.high + kRounding;
}

core::Findings measure_structure_idle_curvature(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::PathPoint* sharpest = nullptr;
    const std::vector<cam::PathPoint> path = contour(cam);
    for (const cam::PathPoint& p : path)
        if (is_idle(cam, p.psi) && (!sharpest || !(p.rho >= sharpest->rho))) sharpest = &p;
    if (!sharpest) return {};
    const double cusp = mm_from_m(0.5 * design.cable.diameter), wanted = mm_from_m(cam.options.path.min_idle_curvature_radius);
    core::Finding f = compare(mm_from_m(sharpest->rho) * (1.0 + kSampled), {allowed("required", cusp), allowed("review", wanted)});
    f.what = "least radius of curvature outside the working arc; the groove's floor has a cusp below half a cable";
    locate(f, design, *sharpest, -0.5 * design.cable.diameter);
    const double margin = deg_from_rad(cam.options.path.margin);
    // An arc that already keeps its least radius elsewhere is as sharp as the ends of the working arc. Then min_idle_radius_mm must be
    // smaller.
    const std::string radius = f.severity == core::Severity::kWarning ? down(f.measured) : up(f.allowed);
    f.suggestion = cam.closed() ? change(design, "path.min_idle_radius_mm", radius)
                                : change(design, "path.margin_deg", up(1.5 * margin)).noted(": a longer run-out has a larger radius");
    return {f};
}

constexpr double kLayerShare = 0.5;  // strength across layers over the material's

bool has_printed_boss(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return works(design) && design.process.kind == ProcessKind::kFdm && hub.boss_height > 0.0 && 0.5 * hub.boss_diameter > hub_radius(hub);
}

/// Stresses at the edge of the boss's root, a ring from the farthest point of bore and keyway to the boss's outside [Pa]. The shaft inside
/// is not counted.
struct RootStress {
    double bending = 0.0, torsion = 0.0;
    /// Largest shear stress in any plane, doubled: Tresca's equivalent.
    [[nodiscard]] double equivalent() const { return std::hypot(bending, 2.0 * torsion); }
};

RootStress root_stress(const solid::Part& part, const cam::Contact& contact) {
    const solid::HubOptions& hub = part.options.hub;
    const double outside = 0.5 * hub.boss_diameter, inside = hub_radius(hub);
    const double second_moment = 0.25 * core::kPi * (std::pow(outside, 4) - std::pow(inside, 4));
    const double lever = hub.kind == solid::HubKind::kOverhung ? contact.path.z - part.z_low : 0.0;  // a shaft that passes carries bending
    const double force = contact.arm.tension;
    return {force * lever * outside / second_moment, force * contact.arm.arm * outside / (2.0 * second_moment)};
}

core::Findings measure_structure_layer_strength(const Design& design, const Allowed& allowed) {
    const solid::Part& part = design.part;
    const cam::Contact& worst = worst_contact(part.cam, [&](const cam::Contact& c) { return root_stress(part, c).equivalent(); });
    const RootStress stress = root_stress(part, worst);
    const Material material = material_of(design.process);
    core::Finding f = compare(kLayerShare * material.strength / stress.equivalent(), {allowed("required"), allowed("review")});
    f.what = fmt::format("safety of the layers at the boss's root at {:.1f} N: {:.2g} MPa of bending and {:.2g} MPa of torsion in {}",
                         worst.arm.tension, stress.bending / kPaPerMPa, stress.torsion / kPaPerMPa, material.name);
    locate(f, design, worst.path);
    f.suggestion = change(design, "hub.boss_mm", up(mm_from_m(part.options.hub.boss_diameter) * std::cbrt(f.allowed / f.measured)));
    return {f};
}

/// h between two samples: the cubic with their values and slopes. @pre psi within the path
double arm_at(const std::vector<cam::PathPoint>& path, double psi) {
    const auto after = std::upper_bound(path.begin() + 1, path.end() - 1, psi, [](double v, const cam::PathPoint& p) { return v < p.psi; });
    const cam::PathPoint &a = *(after - 1), &b = *after;
    const double step = b.psi - a.psi, s = step > 0.0 ? (psi - a.psi) / step : 0.0, t = 1.0 - s;
    return t * t * (1.0 + 2.0 * s) * a.h + s * s * (1.0 + 2.0 * t) * b.h + s * t * step * (t * a.slope - s * b.slope);
}

core::Findings measure_structure_neck(const Design& design, const Allowed& allowed) {
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    const cam::PathPoint* narrowest = nullptr;
    double least = 0.0;
    for (const cam::PathPoint& p : path)
        for (const double opposite :
             {p.psi - core::kPi, p.psi + core::kPi}) {  // both: the low end of the mirror image is the high end here
            if (opposite < path.front().psi || opposite > path.back().psi) continue;
            const double width = p.h + arm_at(path, opposite) - design.cable.diameter;
            if (!narrowest || width < least) narrowest = &p, least = width;
        }
    if (!narrowest) return {};
    core::Finding f = compare(mm_from_m(least), {allowed("review", mm_from_m(process_limits(design.process).feature))});
    f.what = "least width of the core between the groove's floors on both sides";
    locate(f, design, *narrowest, -0.5 * design.cable.diameter);
    f.suggestion = scale_arms(design, (f.allowed + mm_from_m(design.cable.diameter)) / (f.measured + mm_from_m(design.cable.diameter)));
    return {f};
}

core::Finding web(const Design& design, const EffectiveLimit& required, const EffectiveLimit& review) {
    core::Finding f = compare(mm_from_m(design.part.options.hub.web), {required, review});
    f.what = "web between the blind bore's end and the groove's lower lip";
    f.suggestion = change(design, "hub.web_mm", up(f.allowed));
    return f;
}

core::Findings measure_structure_wall_to_bore(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const ProcessLimits process = process_limits(design.process);
    const EffectiveLimit required = allowed("required", mm_from_m(process.wall)),
                         review = allowed("review", mm_from_m(process.loaded_wall));
    if (hub.kind == solid::HubKind::kOverhung) return {web(design, required, review)};
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (path.empty()) return {};
    const double floor = -0.5 * design.cable.diameter;
    Nearest nearest = distance_inside(path, floor, {0.0, 0.0});
    nearest.distance -= bore_radius(hub);
    bool key = false;
    for (const Vec2& corner : key_corners(hub))
        if (const Nearest at = distance_inside(path, floor, corner); at.distance < nearest.distance) nearest = at, key = true;
    core::Finding f = compare(mm_from_m(nearest.distance), {required, review});
    f.what = fmt::format("wall between the groove's floor and the {}", key ? "keyway's corner" : "bore");
    locate(f, design, nearest.at, floor);
    const double lacking = m_from_mm(f.allowed) - nearest.distance, bore = hub.bore_diameter - 2.0 * lacking;
    if (bore > 0.0) f.suggestion = change(design, "hub.bore_mm", down(mm_from_m(bore)));
    if (nearest.at.h > 0.0) f.suggestion.or_else(scale_arms(design, (nearest.at.h + lacking) / nearest.at.h));
    return {f};
}

}  // namespace

Rules structure_rules() {
    return {
        on_cable({"structure.anchor",
                  "the anchor hole breaking into bore, slot or another turn",
                  "least wall from the hole to bore, slot and the turns above",
                  "the process's thinnest wall",
                  {of_process(required(kAtLeast, "mm", "the process's wall"))},
                  measure_structure_anchor}),
        on_cable({"structure.anchor_floor",
                  "an anchor hole that cuts into the working floor",
                  "least distance from the hole to the working floor",
                  "geometry: the working floor defines the arm",
                  {required(kAtLeast, "mm", "half a cable")},
                  measure_structure_anchor_floor}),
        on_cable({"structure.flange_bending",
                  "a flange that the cable bends off",
                  "bending stress of the flange under the cable's side force T/rho tan(fleet, at least 2 deg) at the cable's height",
                  "cantilever of the flange's thickness there; permanent stress of the material (table 5)",
                  {review(kAtMost, "MPa", "the material's permanent stress (table 5)")},
                  measure_structure_flange_bending}),
        on_cable({"structure.flange_slenderness",
                  "a flange that warps or bends when handled",
                  "height of the flange over the groove's floor, over its thickness",
                  "5 (practice)",
                  {review(kAtMost, "", 5.0)},
                  measure_structure_flange_slenderness}),
        {"structure.hole_edge",
         "the anchor hole tearing out of the rim",
         "planar: wall from the anchor hole to the rim of the flange",
         "the process's thinnest wall",
         {of_process(review(kAtLeast, "mm", "the process's wall"))},
         measure_structure_hole_edge},
        {"structure.idle_curvature",
         "a contour too sharp to cut outside its working arc",
         "least rho outside the working arc",
         "geometry: rho > d/2; path.min_idle_radius_mm",
         {required(kAtLeast, "mm", "d/2"), review(kAtLeast, "mm", "path.min_idle_radius_mm")},
         measure_structure_idle_curvature},
        {"structure.layer_strength",
         "a boss that parts from its cam between two layers",
         "FDM: half the material's strength over the equivalent stress at the boss's root, of the cable's force at its height and torque",
         "strength of PLA across layers 47.8 % below the filament's: doi 10.1089/3dp.2020.0109; Tresca; safety 2 against scatter "
         "(practice)",
         {required(kAtLeast, "", 1.0), review(kAtLeast, "", 2.0)},
         measure_structure_layer_strength,
         has_printed_boss},
        {"structure.neck",
         "a core so thin that the part breaks in two",
         "least width of the core between two opposite places of the floor",
         "the process's least feature",
         {of_process(review(kAtLeast, "mm", "the process's feature"))},
         measure_structure_neck},
        {"structure.wall_to_bore",
         "the groove breaking into the bore, its keyway or the blind bore's end",
         "least wall from groove floor to bore or keyway corner; overhung: the web",
         "the process's walls: thin required, loaded recommended",
         {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))},
         measure_structure_wall_to_bore},
    };
}

}  // namespace fusee::checks
