#include "fusee/solid/part.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "fusee/cam/mirror.h"
#include "fusee/core/error.h"
#include "fusee/core/kept.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/mesh_faults.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/stack.h"
#include "fusee/solid/sweep.h"
#include "fusee/solid/validity.h"
#include "refusals.h"

namespace fusee::solid {

namespace {

using core::mm_from_m;

/// Field names are those of the profile.
void require_mm(const std::string& field, double metres, double low_mm, double high_mm) {
    constexpr double kRounding = 1e-9;  // of a limit: allows for the rounding of units
    core::require_within(field + "_mm", mm_from_m(metres), low_mm * (1.0 - kRounding), high_mm * (1.0 + kRounding), "mm");
}

void require_above_0_mm(const std::string& field, double metres) { core::require_positive(field + "_mm", mm_from_m(metres), "mm"); }

void validate_hub(const std::string& hub_of, const HubOptions& hub, double rib) {
    require_above_0_mm(hub_of + "bore", hub.bore_diameter);
    require_mm(hub_of + "clearance", hub.bore_clearance, 0.0, 2.0);
    const double bore_mm = mm_from_m(hub.bore_diameter + hub.bore_clearance), boss_height_mm = mm_from_m(hub.boss_height);
    if (hub.lock == HubLock::kKeyway) require_mm(hub_of + "key_width", hub.key_width, 0.1, 0.9 * bore_mm);
    if (hub.lock == HubLock::kKeyway) require_mm(hub_of + "key_depth", hub.key_depth, 0.1, bore_mm);
    if (hub.lock == HubLock::kDFlat) require_mm(hub_of + "flat_depth", hub.flat_depth, 0.01, 0.45 * bore_mm);
    const bool on_boss = hub.kind == HubKind::kOverhung || hub.lock == HubLock::kSetScrew;
    if (on_boss) require_above_0_mm(hub_of + "boss_height", hub.boss_height);
    if (on_boss || hub.boss_height > 0.0) require_mm(hub_of + "boss", hub.boss_diameter, 2.0 * bore_reach_mm(hub) + 0.2, 1000.0);
    if (hub.kind == HubKind::kOverhung) require_mm(hub_of + "web", hub.web, 0.1, mm_from_m(rib) + boss_height_mm - 0.5);
    if (hub.lock == HubLock::kSetScrew) require_mm(hub_of + "screw", hub.screw_diameter, 0.5, 0.9 * boss_height_mm);
}

void validate_options(const std::string& part, const PartOptions& o) {
    require_mm("groove.rib", o.groove.rib, 0.1, 100.0);
    require_mm("groove.plate", o.groove.plate, 0.0, 100.0);
    require_mm(part + ".flange_height", o.flange_height, 0.0, 100.0);
    validate_hub(part + ".hub.", o.hub, o.groove.rib);
    const FeatureOptions& f = o.features;
    if (f.leg_slot_width > 0.0) {
        require_mm(part + ".features.leg_slot_length", f.leg_slot_length, 1.05 * mm_from_m(f.leg_slot_width), 1000.0);
        require_above_0_mm(part + ".features.leg_slot_depth", f.leg_slot_depth);
    }
    require_mm(part + ".features.mark_width", f.mark_width, 0.0, 5.0);
    if (f.mark_width > 0.0)
        require_mm(part + ".features.mark_depth", f.mark_depth, 0.05, mm_from_m(o.groove.rib));  // deeper: into the groove
}

/// Bore, boss and the two faces: closes a swept body. `bored` false leaves the body full (the skin). False where outlines cross.
[[nodiscard]] bool close_body(SweptBody& body, const HubOptions& hub, double tolerance, bool bored) {
    Mesh& mesh = body.mesh;
    const bool boss = hub.boss_height > 0.0, through = hub.kind == HubKind::kThrough;
    const double z_boss = body.z_low_mm - (boss ? mm_from_m(hub.boss_height) : 0.0);
    const Ring bore = ring_of(bore_outline(hub), tolerance);
    VertexRing bottom_outer = body.lower_ring;
    bool simple = true;
    if (boss) {
        const Ring rim = ring_of(circle(mm_from_m(0.5 * hub.boss_diameter)), tolerance);
        const VertexRing upper = add_ring(mesh, rim, body.z_low_mm), lower = add_ring(mesh, rim, z_boss);
        simple &= fill_face(mesh, body.lower_ring, {upper}, false);
        add_wall_between(mesh, lower, upper, true);
        bottom_outer = lower;
    }
    if (!bored) {
        simple &= fill_face(mesh, bottom_outer, {}, false);
        return simple & fill_face(mesh, body.upper_ring, {}, true);
    }
    const double z_end = through ? body.z_high_mm : body.lower_lip_mm - mm_from_m(hub.web);
    const VertexRing low = add_ring(mesh, bore, z_boss), high = add_ring(mesh, bore, z_end);
    simple &= fill_face(mesh, bottom_outer, {low}, false);
    add_wall_between(mesh, low, high, false);
    if (!through) simple &= fill_face(mesh, high, {}, false);
    return simple & fill_face(mesh, body.upper_ring, through ? std::vector<VertexRing>{high} : std::vector<VertexRing>{}, true);
}

core::Finding invalid(const cam::Cam& cam, const Validity& validity) {
    return invalid_solid(validity, "the solid", to_string(cam.kind),
                         "a wider rib or pitch, or a shallower groove, so that no face intersects another");
}

/// Rounds to the file's precision. If a cut passes within a micrometre of an edge of the body, rounding can fold the slivers that `cut`
/// leaves. Then triangles without area are removed too, and if necessary edges up to a micrometre or half of the tolerance.
Validity settle(const Mesh& exact, double tolerance_mm, Mesh& file) {
    file = exact;
    round_to_file(file);
    const Validity validity = validate(file);
    if (!validity.self_intersecting) return validity;
    for (const double shortest_mm : {1e-4, 1e-3}) {
        std::optional<Mesh> smoother = without_folds(exact, std::min(shortest_mm, 0.5 * tolerance_mm));
        if (!smoother) continue;
        round_to_file(*smoother);
        const Validity again = validate(*smoother);
        if (!again.good()) continue;
        file = std::move(*smoother);
        return again;
    }
    return validity;
}

/// A body with its cuts, rounded to the file's precision, and what its proof says.
struct Proven {
    Mesh mesh;
    Validity validity;
};

/// All that a cut depends on. A cut with its proof is half of a part's cost.
struct CutBody {
    Mesh body;
    std::vector<Mesh> tools;
    double tolerance_mm = 0.0;

    friend bool operator==(const CutBody& a, const CutBody& b) {
        const auto same = [](const Mesh& m, const Mesh& n) { return m.points_mm == n.points_mm && m.triangles == n.triangles; };
        return a.tolerance_mm == b.tolerance_mm && same(a.body, b.body) &&
               std::equal(a.tools.begin(), a.tools.end(), b.tools.begin(), b.tools.end(), same);
    }
};

/// None: the cut failed.
std::optional<Proven> cut_and_proven(CutBody asked) {
    constexpr std::size_t kBodies = 8, kMostTriangles = 100000;  // 5 MB in all at the usual chordal error, at most 40 MB
    static core::Kept<CutBody, Proven> bodies(kBodies);
    if (auto known = bodies.find(asked)) return known;
    const auto left = cut(asked.body, asked.tools);
    if (!left) return {};
    Proven made;
    made.validity = settle(*left, asked.tolerance_mm, made.mesh);
    if (asked.body.triangles.size() <= kMostTriangles) bodies.keep(std::move(asked), made);
    return made;
}

/// Columns and lips are built from the low end of psi upwards. A left-handed helix is built as the mirror image of a right-handed one.
template <class Make>
core::Outcome<Part> through_mirror(const Make& make, const cam::Cam& cam, const PartOptions& options) {
    const auto right = make(cam::mirrored(cam), mirrored(options));
    if (!right) return right;
    Part part = mirrored(*right);
    part.cam = cam;
    part.options = options;
    return part;
}

}  // namespace

core::Outcome<Part> outline_part(const cam::Cam& cam, const PartOptions& options) {
    if (cam::left_handed(cam)) return through_mirror(outline_part, cam, options);
    validate_options(to_string(cam.kind), options);
    Part part;
    part.cam = cam;
    part.options = options;
    part.section = cam.has_roller()         ? rim_section(options)
                   : is_stack(cam, options) ? stack_section(cam, options)
                                            : groove_section(options.groove, cam.options.cable_diameter, 0.5 * options.chordal_error);
    if (core::Findings findings = check_geometry(cam, options, part.section); !findings.empty()) return findings;
    const ColumnMaker maker(cam, part.section, flanges_of(options));
    if (core::Findings findings = check_run_outs(part, maker); !findings.empty()) return findings;
    part.z_low = core::m_from_mm(maker.z_low_mm());
    part.z_high = core::m_from_mm(maker.z_high_mm());
    part.chordal_error_mm = mm_from_m(options.chordal_error);
    return part;
}

core::Outcome<Part> build_part(const cam::Cam& cam, const PartOptions& options) {
    if (cam::left_handed(cam)) return through_mirror(build_part, cam, options);
    auto outline = outline_part(cam, options);
    if (!outline) return outline.refusal();
    Part part = std::move(outline).value();
    // Path and section each get half of the chordal error.
    const double tolerance = 0.5 * mm_from_m(options.chordal_error);
    const Flanges flanges = flanges_of(options);
    SweptBody body = sweep(cam, part.section, flanges, tolerance);
    part.columns_psi = body.columns_psi;
    if (!close_body(body, options.hub, tolerance, true)) return invalid(cam, validate(body.mesh));
    if (!cam.closed()) {
        SweptBody skin = sweep(cam, {part.section.front(), part.section.back()}, flanges, tolerance);
        if (!close_body(skin, options.hub, tolerance, false)) return invalid(cam, validate(skin.mesh));
        part.skin = std::move(skin.mesh);
    }

    std::vector<Mesh> tools;
    for (const Cutter& cutter : make_cutters(part)) tools.push_back(cutter.mesh(tolerance));
    auto proven = cut_and_proven({body.mesh, std::move(tools), tolerance});
    if (!proven) return invalid(cam, validate(body.mesh));
    if (!proven->validity.good()) return invalid(cam, proven->validity);
    part.mesh = std::move(proven->mesh);
    return part;
}

}  // namespace fusee::solid
