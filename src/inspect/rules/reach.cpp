#include <array>

#include "fusee/core/lists.h"
#include "fusee/core/parallel.h"
#include "measure.h"
#include "seam.h"

namespace fusee::inspect {

namespace {

/// The circle through a hole's corners is as exact as the corners: single precision, another body that cuts into it and the rounding of a
/// mesh kernel cause errors of 0.1 %. A diameter that misses its limit by no more meets it.
constexpr double kAsGood = 1e-3;

double against(double diameter, double allowed) { return diameter < allowed && diameter >= (1.0 - kAsGood) * allowed ? allowed : diameter; }

std::optional<Marked> measure_mesh_hole(const Foreign& part, const Allowed& allowed) {
    const checks::EffectiveLimit limit = allowed("required", core::mm_from_m(checks::process_limits(part.process).hole));
    std::optional<Hollow> least;
    std::size_t count = 0;
    std::vector<std::uint32_t> triangles;
    for (const Hollow& h : part.body.hollows()) {
        if (!h.is_hole()) continue;
        ++count;
        if (!least || h.diameter_mm < least->diameter_mm) least = h;
        if (against(h.diameter_mm, limit.value()) < limit.value())
            triangles.insert(triangles.end(), h.triangles.begin(), h.triangles.end());
    }
    if (!least) return std::nullopt;
    core::Finding f = compare(against(least->diameter_mm, limit.value()), {limit});
    f.what = fmt::format("smallest of {} holes, {} and {:.2f} mm long", count, least->is_through() ? "through" : "blind", least->length_mm);
    set_place(f, least->middle_mm);
    f.suggestion = fmt::format("{} mm wide, or drilled afterwards", up(f.allowed));
    return Marked{f, triangles};
}

std::optional<Marked> measure_mesh_hole_depth(const Foreign& part, const Allowed& allowed) {
    if (!is_milled(part.process) && part.process.kind != checks::ProcessKind::kSls) return std::nullopt;
    const bool powder = part.process.kind == checks::ProcessKind::kSls;
    std::optional<Hollow> deepest;
    for (const Hollow& h : part.body.hollows()) {
        if (!h.is_hole() || (powder && h.is_through())) continue;  // a through hole traps no powder
        if (!deepest || h.length_mm / h.diameter_mm > deepest->length_mm / deepest->diameter_mm) deepest = h;
    }
    if (!deepest) return std::nullopt;
    core::Finding f = powder ? compare(deepest->length_mm / deepest->diameter_mm, {allowed("powder_review")})
                             : compare(deepest->length_mm / deepest->diameter_mm, {allowed("required"), allowed("review")});
    f.what =
        fmt::format("depth of a {} hole of {:.2f} mm over its diameter", deepest->is_through() ? "through" : "blind", deepest->diameter_mm);
    set_place(f, deepest->middle_mm);
    f.suggestion = fmt::format("{} mm deep, or {} mm wide", down(f.allowed * deepest->diameter_mm), up(deepest->length_mm / f.allowed));
    return Marked{f, deepest->triangles};
}

constexpr double kSharp = core::rad_from_deg(35.0);  // a smaller angle is the facet of a rounding
constexpr double kUpright = 0.95;                    // cosine of an edge with z

struct InnerEdges {
    double least_radius_mm = NAN;
    Vec3 at{};
    std::vector<std::uint32_t> triangles;
    void take(const std::vector<std::uint32_t>& more, double radius, const Vec3& where, double limit) {
        if (radius < limit) triangles.insert(triangles.end(), more.begin(), more.end());
        if (!(radius >= least_radius_mm)) least_radius_mm = radius, at = where;
    }
};

/// Inner edges along the tool: rounded ones with their radius, sharp ones with 0. Holes are drilled and do not count.
InnerEdges inner_edges(const Body& body, double limit) {
    InnerEdges found;
    std::vector<bool> rounded(body.mesh().triangles.size(), false);
    for (const Hollow& h : body.hollows()) {
        for (const std::uint32_t t : h.triangles) rounded[t] = true;
        if (!h.is_hole() && std::abs(h.axis[2]) > kUpright) found.take(h.triangles, 0.5 * h.diameter_mm, h.middle_mm, limit);
    }
    for_each_seam(body, [&](const Seam& s) {
        if (!s.concave || s.turn < kSharp || std::abs(s.along[2]) < kUpright || (rounded[s.a] && rounded[s.b])) return;
        found.take({s.a, s.b}, 0.0, middle_of(body, s.a), limit);
    });
    found.triangles = core::sorted_unique(std::move(found.triangles));
    return found;
}

std::optional<Marked> measure_mesh_inner_edge(const Foreign& part, const Allowed& allowed) {
    const auto limit = allowed.stated("review", core::mm_from_m(checks::process_limits(part.process).cutter_radius));
    if (!limit) return std::nullopt;
    const InnerEdges found = inner_edges(part.body, limit->value());
    if (std::isnan(found.least_radius_mm)) return std::nullopt;
    core::Finding f = compare(found.least_radius_mm, {*limit});
    f.what = "least radius of an inner edge along z, where the cutter leaves its own radius";
    set_place(f, found.at);
    f.suggestion = fmt::format("rounded by {} mm, or relieved by a hole of {} mm", up(f.allowed), up(2.0 * f.allowed));
    return Marked{f, found.triangles};
}

constexpr double kSlack = core::rad_from_deg(1.0);  // the angle of a facet differs a little from that of the surface
constexpr double kFirstLayer_mm = 0.05;             // a face on the bed needs no support

struct Side {
    const char* name;
    Vec3 up;
};
constexpr std::array kSides = {Side{"-z", {0, 0, 1}},  Side{"+z", {0, 0, -1}}, Side{"-x", {1, 0, 0}},
                               Side{"+x", {-1, 0, 0}}, Side{"-y", {0, 1, 0}},  Side{"+y", {0, -1, 0}}};

struct Hanging {
    double area_mm2 = 0.0;
    std::vector<std::uint32_t> triangles;
};

/// Downward faces beyond the process's overhang that do not lie on the bed, with `up` upward.
Hanging hanging(const Body& body, const Vec3& up, double overhang) {
    const auto& points = body.mesh().points_mm;
    double bed = INFINITY;
    for (const Vec3& p : points) bed = std::min(bed, dot(p, up));
    const double steepest = -std::sin(std::min(overhang + kSlack, 0.5 * core::kPi));
    Hanging found;
    for (std::uint32_t t = 0; t < body.mesh().triangles.size(); ++t) {
        if (!(dot(body.normals()[t], up) < steepest)) continue;
        double highest = -INFINITY;
        for (const std::uint32_t p : body.mesh().triangles[t]) highest = std::max(highest, dot(points[p], up));
        if (highest < bed + kFirstLayer_mm) continue;
        found.area_mm2 += body.areas_mm2()[t];
        found.triangles.push_back(t);
    }
    return found;
}

std::optional<Marked> measure_mesh_overhang(const Foreign& part, const Allowed& allowed) {
    const double overhang = checks::process_limits(part.process).overhang;
    if (!(overhang > 0.0)) return std::nullopt;
    const Hanging found = hanging(part.body, kSides.front().up, overhang);
    core::Finding f = compare(found.area_mm2, {allowed("review")});
    f.what = fmt::format("downward faces at more than {:g} deg from the vertical, printed in the orientation of the file",
                         core::deg_from_rad(overhang));
    if (!found.triangles.empty()) set_place(f, middle_of(part.body, found.triangles.front()));
    if (f.severity == core::Severity::kPass) return Marked{f};
    const Side* best = &kSides.front();
    double least = found.area_mm2;
    for (const Side& side : kSides)
        if (const double area = hanging(part.body, side.up, overhang).area_mm2; area < least) least = area, best = &side;
    f.suggestion = least < found.area_mm2 ? fmt::format("printed on its {} side, with {} mm^2 of such faces", best->name, up(least))
                                          : fmt::format("turn on supports, {} mm^2; no other side is better", up(least));
    return Marked{f, found.triangles};
}

constexpr double kFloor = 0.9;                    // cosine of a floor's normal with z
constexpr double kFloorLift_mm = 0.05;            // rays towards the tool start this far above the floor
constexpr double kFacing = -0.99;                 // cosine between walls that face each other
constexpr std::size_t kMostFloors = 3000;         // floor samples that are checked
constexpr int kPocketWidths = 8, kHalvings = 10;  // over half a turn; of the height

struct Pocket {
    double width_mm = NAN, depth_mm = 0.0;
    const Sample* floor = nullptr;
    [[nodiscard]] double ratio() const { return depth_mm > 0.0 ? depth_mm / width_mm : 0.0; }
};

class Walls {
public:
    Walls(const Body& body, std::vector<bool> drilled) : body_(body), drilled_(std::move(drilled)) {}

    /// Width between two walls that face each other, from `at` along d; NaN without walls and in a drilled hole.
    [[nodiscard]] double width(const Vec3& at, const Vec3& d) const {
        const auto there = body_.rays().first(at, d, kNone), back = body_.rays().first(at, -1.0 * d, kNone);
        if (!there || !back || (drilled_[there->triangle] && drilled_[back->triangle])) return NAN;
        if (dot(body_.normals()[there->triangle], body_.normals()[back->triangle]) > kFacing) return NAN;
        return there->distance_mm + back->distance_mm;
    }

    /// The least width over this floor, and the height of its walls.
    [[nodiscard]] Pocket at(const Sample& floor) const {
        Pocket pocket;
        pocket.floor = &floor;
        const Vec3 from = floor.at_mm + kFloorLift_mm * Vec3{0, 0, 1};
        Vec3 across{};
        for (int i = 0; i < kPocketWidths; ++i) {
            const double a = core::kPi * i / kPocketWidths;
            const Vec3 d{std::cos(a), std::sin(a), 0.0};
            if (const double w = width(from, d); w < pocket.width_mm || (std::isnan(pocket.width_mm) && !std::isnan(w)))
                pocket.width_mm = w, across = d;
        }
        if (std::isnan(pocket.width_mm)) return pocket;
        double shut = 0.0, open = body_.box().high_mm[2] - from[2];
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (shut + open);
            (std::isnan(width(from + middle * Vec3{0, 0, 1}, across)) ? open : shut) = middle;
        }
        pocket.depth_mm = kFloorLift_mm + shut;
        return pocket;
    }

private:
    const Body& body_;
    std::vector<bool> drilled_;
};

std::vector<Pocket> pockets(const Body& body) {
    std::vector<bool> drilled(body.mesh().triangles.size(), false);
    for (const Hollow& h : body.hollows())
        if (h.is_hole())
            for (const std::uint32_t t : h.triangles) drilled[t] = true;
    std::vector<const Sample*> floors;
    for (const Sample& s : body.samples())
        if (body.normals()[s.triangle][2] > kFloor) floors.push_back(&s);
    const std::size_t step = floors.size() / kMostFloors + 1;
    std::vector<Pocket> all((floors.size() + step - 1) / step);
    const Walls walls(body, std::move(drilled));
    core::parallel_for(all.size(), body.jobs(), [&](std::size_t i) { all[i] = walls.at(*floors[i * step]); });
    return all;
}

std::optional<Marked> measure_mesh_pocket(const Foreign& part, const Allowed& allowed) {
    if (!is_milled(part.process)) return std::nullopt;
    const std::vector<Pocket> all = pockets(part.body);
    const auto worst = std::max_element(all.begin(), all.end(), [](const Pocket& a, const Pocket& b) { return a.ratio() < b.ratio(); });
    if (worst == all.end() || !(worst->ratio() > 0.0)) return std::nullopt;
    core::Finding f = compare(worst->ratio(), {allowed("review")});
    f.what = fmt::format("depth of a pocket of {:.2f} mm width over that width, the largest possible tool diameter", worst->width_mm);
    set_place(f, worst->floor->at_mm);
    f.suggestion = fmt::format("{} mm wide, or {} mm deep", up(worst->depth_mm / f.allowed), down(f.allowed * worst->width_mm));
    std::vector<std::uint32_t> triangles;
    for (const Pocket& p : all)
        if (p.ratio() > f.allowed && (triangles.empty() || triangles.back() != p.floor->triangle)) triangles.push_back(p.floor->triangle);
    return Marked{f, triangles};
}

constexpr double kLift_mm = 0.01;  // rays towards the tool start this far above the surface
constexpr int kTurns = 36;         // directions of a tool around the fourth axis

std::vector<Vec3> tools(const checks::Process& process) {
    std::vector<Vec3> all{{0, 0, 1}, {0, 0, -1}};
    for (int i = 0; process.kind == checks::ProcessKind::kMill4 && i < kTurns; ++i)
        all.push_back({std::cos(2.0 * core::kPi * i / kTurns), std::sin(2.0 * core::kPi * i / kTurns), 0.0});
    return all;
}

bool is_seen(const Body& body, const Sample& s, const std::vector<Vec3>& directions) {
    const Vec3& n = body.normals()[s.triangle];
    for (const Vec3& d : directions)
        if (dot(n, d) > -std::sin(kSlack) && !body.rays().first(s.at_mm + kLift_mm * n, d, s.triangle)) return true;
    return false;
}

std::optional<Marked> measure_mesh_undercut(const Foreign& part, const Allowed& allowed) {
    if (!is_milled(part.process)) return std::nullopt;
    const Body& body = part.body;
    const std::vector<Vec3> directions = tools(part.process);
    std::vector<char> seen(body.samples().size());
    core::parallel_for(seen.size(), body.jobs(), [&](std::size_t i) { seen[i] = is_seen(body, body.samples()[i], directions) ? 1 : 0; });
    double hidden = 0.0, whole = 0.0;
    const Sample* first = nullptr;
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Sample& s = body.samples()[i];
        whole += s.share_mm2;
        if (seen[i] || body.cavity()[body.topology().component_of[s.triangle]]) continue;  // mesh.cavity reports cavities
        hidden += s.share_mm2;
        if (!first) first = &s;
        if (triangles.empty() || triangles.back() != s.triangle) triangles.push_back(s.triangle);
    }
    core::Finding f = compare(100.0 * hidden / whole, {allowed("required")});
    f.what = part.process.kind == checks::ProcessKind::kMill
                 ? fmt::format("share of the surface that a tool along z reaches from neither side: {:.3g} mm^2", hidden)
                 : fmt::format("share of the surface that a tool reaches neither along z nor across it: {:.3g} mm^2", hidden);
    if (first) set_place(f, first->at_mm);
    f.suggestion = part.process.kind == checks::ProcessKind::kMill
                       ? fmt::format("{} mm^2 opened towards +z or -z, a fourth axis, or stacked plates", up(hidden))
                       : fmt::format("{} mm^2 opened towards z or outward", up(hidden));
    return Marked{f, triangles};
}

}  // namespace

Rules reach_rules() {
    return {
        {{"mesh.hole",
          "a hole too small to make",
          "diameter of the smallest cylindrical hole: facets along one axis with their corners on a circle, over 200 deg of it; a "
          "diameter 0.1 % "
          "below its limit meets it",
          "the process's least hole",
          {of_process(required(kAtLeast, "mm", "the process's hole"))}},
         measure_mesh_hole},
        {{"mesh.hole_depth",
          "a hole too deep to drill or to empty of powder",
          "milled: depth of the deepest cylindrical hole over its diameter; SLS: of the deepest blind one",
          "hole 4 diameters, at most 10: zekes3d, procurabl; powder 5 (practice)",
          {required(kAtMost, "diameters", 10.0), review(kAtMost, "diameters", 4.0), review(kAtMost, "diameters", 5.0, "powder_review")}},
         measure_mesh_hole_depth},
        {{"mesh.inner_edge",
          "an inner edge sharper than the cutter",
          "milled, cut: least radius of the inner edges along z; 0 for one that turns by 35 deg or more in one edge",
          "the process's cutter radius",
          {of_process(review(kAtLeast, "mm", "the process's cutter radius; none printed"))}},
         measure_mesh_inner_edge},
        {{"mesh.overhang",
          "ceilings that a printer cannot bridge",
          "FDM: area of downward faces beyond the overhang + 1 deg that are not on the bed, z upward",
          "FDM bridge 5-10 mm: 3dservicesusa, cifproto, arti90, layerx3d; a square of 5 mm",
          {review(kAtMost, "mm^2", 25.0)}},
         measure_mesh_overhang},
        {{"mesh.pocket",
          "a pocket too deep for the tool that fits into it",
          "milled: depth over width, between walls that face each other, above upward faces; drilled holes not counted",
          "pocket <= 3 tools deep: zekes3d, procurabl, neptunelabs, super-ingenuity, Xometry",
          {review(kAtMost, "widths", 3.0)}},
         measure_mesh_pocket},
        {{"mesh.undercut",
          "an undercut, which no tool reaches",
          "milled: share of the surface that is visible neither from +z nor from -z; mill4: nor from any of 36 directions across z",
          "sampling and rounding cause up to 0.5 % (practice)",
          {required(kAtMost, "%", 0.5)}},
         measure_mesh_undercut},
    };
}

}  // namespace fusee::inspect
