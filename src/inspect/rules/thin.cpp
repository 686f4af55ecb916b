#include <numeric>

#include "fusee/core/parallel.h"
#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_feather_edge(const Foreign& part, const Allowed& allowed) {
    const double thin = core::mm_from_m(checks::process_limits(part.process).wall);
    const auto counts = [thin](const Sample& s) { return s.edge && s.edge->width_mm < thin; };
    const Sample* sharpest = nullptr;
    for (const Sample& s : part.body.samples())
        if (counts(s) && (!sharpest || s.edge->angle < sharpest->edge->angle)) sharpest = &s;
    if (!sharpest) return std::nullopt;
    core::Finding f = compare(core::deg_from_rad(sharpest->edge->angle), {allowed("review")});
    f.what = fmt::format("angle of the sharpest edge, {:.2f} mm thick {:.2f} mm from it", sharpest->edge->width_mm, sharpest->edge->way_mm);
    set_place(f, sharpest->at_mm);
    f.suggestion = fmt::format("edge cut off at a thickness of {:g} mm, or opened to {} deg", thin, up(f.allowed));
    return Marked{f, triangles_of(part.body, counts)};
}

std::optional<Marked> measure_mesh_gap(const Foreign& part, const Allowed& allowed) {
    const double detail = core::mm_from_m(checks::process_limits(part.process).detail);
    const auto least = allowed.stated("review", detail);
    if (!least) return std::nullopt;
    const Sample* narrowest = nullptr;
    for (const Sample& s : part.body.samples())
        if (!std::isnan(s.gap_mm) && (!narrowest || s.gap_mm < narrowest->gap_mm)) narrowest = &s;
    if (!narrowest) return std::nullopt;
    core::Finding f = compare(narrowest->gap_mm, {*least});
    f.what = "narrowest slot";
    set_place(f, narrowest->at_mm);
    f.suggestion = fmt::format("{} mm wide there ({} mm more)", up(f.allowed), up(f.allowed - f.measured));
    return Marked{f, triangles_of(part.body, [&](const Sample& s) { return s.gap_mm < f.allowed; })};
}

constexpr double kSlender = 2.0;      // largest ratio of the two widths of a pin
constexpr double kAcrossFrom = -0.9;  // cosine between the normals at both ends of a width
constexpr int kPinDirections = 8;     // over half a turn

/// Least width of the material through `middle`, across the thickness along `n`, between faces that face away from each other; NaN if none.
double width_across(const Body& body, const Vec3& middle, const Vec3& n) {
    const Frame frame = frame_about(n);
    double least = NAN;
    for (int i = 0; i < kPinDirections; ++i) {
        const double a = core::kPi * i / kPinDirections;
        const Vec3 d = std::cos(a) * frame.u + std::sin(a) * frame.v;
        const auto there = body.rays().first(middle, d, kNone), back = body.rays().first(middle, -1.0 * d, kNone);
        if (!there || !back || dot(body.normals()[there->triangle], body.normals()[back->triangle]) > kAcrossFrom) continue;
        const double width = there->distance_mm + back->distance_mm;
        if (!(width >= least)) least = width;
    }
    return least;
}

std::optional<Marked> measure_mesh_pin(const Foreign& part, const Allowed& allowed) {
    const double limit = core::mm_from_m(checks::process_limits(part.process).feature);
    const checks::EffectiveLimit least = allowed("review", limit);
    const Body& body = part.body;
    const std::vector<Sample>& samples = body.samples();
    std::vector<char> slender(samples.size(), 0);
    core::parallel_for(samples.size(), body.jobs(), [&](std::size_t i) {
        const Sample& s = samples[i];
        if (!(s.wall_mm < least.value())) return;  // most samples are thick enough
        slender[i] = width_across(body, s.middle_mm, body.normals()[s.triangle]) <= kSlender * s.wall_mm ? 1 : 0;
    });
    const Sample* thinnest = nullptr;
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (slender[i] == 0) continue;
        if (!thinnest || samples[i].wall_mm < thinnest->wall_mm) thinnest = &samples[i];
        if (triangles.empty() || triangles.back() != samples[i].triangle) triangles.push_back(samples[i].triangle);
    }
    if (!thinnest) return std::nullopt;
    core::Finding f = compare(thinnest->wall_mm, {least});
    f.what = "thinnest pin: thin in two directions";
    set_place(f, thinnest->at_mm);
    f.suggestion = fmt::format("{} mm thick there ({} mm more)", up(f.allowed), up(f.allowed - f.measured));
    return Marked{f, triangles};
}

solid::Box joined(const solid::Box& a, const solid::Box& b) {
    solid::Box both;
    for (std::size_t i = 0; i < 3; ++i)
        both.low_mm[i] = std::min(a.low_mm[i], b.low_mm[i]), both.high_mm[i] = std::max(a.high_mm[i], b.high_mm[i]);
    return both;
}

/// True if the box fits as it lies, or turned by 90 deg about z.
bool fits(const solid::Box& box, const Vec3& build) {
    const Vec3 size = box.high_mm - box.low_mm;
    constexpr double kSlackOfBed_mm = 1e-6;
    const auto within = [&](double x, double y) {
        return x <= build[0] + kSlackOfBed_mm && y <= build[1] + kSlackOfBed_mm && size[2] <= build[2] + kSlackOfBed_mm;
    };
    return within(size[0], size[1]) || within(size[1], size[0]);
}

/// Boxes of the plates that the items need as they lie: each goes on the first one that still fits the machine. By ascending x and y, so
/// that neighbours meet.
std::vector<solid::Box> plates(std::vector<solid::Box> items, const Vec3& build) {
    std::stable_sort(items.begin(), items.end(), [](const solid::Box& a, const solid::Box& b) { return a.low_mm < b.low_mm; });
    std::vector<solid::Box> all;
    for (const solid::Box& item : items) {
        const auto plate = std::find_if(all.begin(), all.end(), [&](const solid::Box& p) { return fits(joined(p, item), build); });
        if (plate == all.end())
            all.push_back(item);
        else
            *plate = joined(*plate, item);
    }
    return all;
}

std::optional<Marked> measure_mesh_plate(const Foreign& part, const Allowed& allowed) {
    const File& file = *part.file;
    if (file.pieces().size() < 2) return std::nullopt;
    std::vector<solid::Box> items;
    for (const Piece& piece : file.pieces())  // an item is printed as it is; so are the bodies of a file without items
        if (!items.empty() && file.items().size() > 1 && piece.item + 1 == items.size())
            items.back() = joined(items.back(), piece.body.box());
        else
            items.push_back(piece.body.box());
    const checks::Process& process = part.process;
    const Vec3 build{core::mm_from_m(process.build_x), core::mm_from_m(process.build_y), core::mm_from_m(process.build_z)};
    const std::size_t count = plates(items, build).size();
    const Vec3 size = file.box().high_mm - file.box().low_mm;
    core::Finding f = compare(static_cast<double>(count), {allowed("review")});
    f.what = fmt::format("plates of {:g} x {:g} x {:g} mm that {} {} need as they lie, {:.2f} x {:.2f} x {:.2f} mm in all", build[0],
                         build[1], build[2], items.size(), file.items().size() > 1 ? "items" : "bodies", size[0], size[1], size[2]);
    f.suggestion =
        fmt::format("each of the {} plates made by itself, or the parts arranged within {:g} x {:g} mm", count, build[0], build[1]);
    return Marked{f};
}

constexpr double kDraft = core::rad_from_deg(2.0);  // a cut's own draft, and facets

std::optional<Marked> measure_mesh_plates(const Foreign& part, const Allowed& allowed) {
    if (!is_stacked(part.process)) return std::nullopt;
    const Body& body = part.body;
    double inclined = 0.0;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < body.mesh().triangles.size(); ++t) {
        const double z = std::abs(body.normals()[t][2]);
        if (z < std::sin(kDraft) || z > std::cos(kDraft)) continue;
        inclined += body.areas_mm2()[t];
        triangles.push_back(t);
    }
    const double whole = std::accumulate(body.areas_mm2().begin(), body.areas_mm2().end(), 0.0);
    core::Finding f = compare(100.0 * inclined / whole, {allowed("required")});
    f.what = fmt::format("share of the surface that is neither horizontal nor vertical, which plates cut along z cannot have: {:.3g} mm^2",
                         inclined);
    if (!triangles.empty()) set_place(f, middle_of(body, triangles.front()));
    f.suggestion = fmt::format("{} mm^2 drawn as steps of the plates' thickness", up(inclined));
    return Marked{f, triangles};
}

constexpr double kThick = 2.0;           // the base of a rib is this many times as thick
constexpr double kWalls = 2.0;           // a rib is thinner than this many loaded walls
constexpr std::size_t kMostThin = 4000;  // thin samples that are checked
constexpr double kPrinted = 10.0, kCut = 4.0;

struct Rib {
    const Sample* at = nullptr;
    double height_mm = 0.0;
    double share_mm2 = 0.0;  ///< of the surface
    [[nodiscard]] double slenderness() const { return height_mm / at->wall_mm; }
};

/// Distance from each thin sample to the nearest one of its own surface under which a ball of twice its thickness fits. A plate that is
/// thin everywhere has no rib.
std::vector<Rib> ribs(const Body& body, double thin) {
    std::vector<Rib> all;
    for (const Sample& s : body.samples())
        if (s.wall_mm < thin) all.push_back({&s});
    const std::size_t step = all.size() / kMostThin + 1;
    for (std::size_t i = 0; i * step < all.size(); ++i) all[i] = all[i * step];
    all.resize((all.size() + step - 1) / step);
    const std::vector<std::uint32_t>& component = body.topology().component_of;
    core::parallel_for(all.size(), body.jobs(), [&](std::size_t i) {
        const Sample& here = *all[i].at;
        double nearest = INFINITY;
        for (const Sample& other : body.samples())
            if (other.ball_mm >= kThick * here.wall_mm && component[other.triangle] == component[here.triangle]) {
                const Vec3 way = other.at_mm - here.at_mm;
                nearest = std::min(nearest, dot(way, way));
            }
        all[i].height_mm = std::isinf(nearest) ? 0.0 : std::sqrt(nearest);
        all[i].share_mm2 = static_cast<double>(step) * here.share_mm2;
    });
    return all;
}

/// The rib up to which the most slender places have this much area: a smaller spot is a scar, as for walls. @pre not empty
const Rib& worst_of(const std::vector<Rib>& all, double area_mm2) {
    std::vector<const Rib*> order;
    for (const Rib& rib : all) order.push_back(&rib);
    std::stable_sort(order.begin(), order.end(), [](const Rib* a, const Rib* b) { return a->slenderness() > b->slenderness(); });
    double held = 0.0;
    for (const Rib* rib : order)
        if ((held += rib->share_mm2) >= area_mm2) return *rib;
    return *order.back();
}

std::optional<Marked> measure_mesh_rib(const Foreign& part, const Allowed& allowed) {
    const checks::ProcessLimits limits = checks::process_limits(part.process);
    const double thin = kWalls * core::mm_from_m(limits.loaded_wall), wall = core::mm_from_m(limits.wall);
    const std::vector<Rib> all = ribs(part.body, thin);
    if (all.empty()) return std::nullopt;
    const Rib& worst = worst_of(all, wall * wall);
    core::Finding f = compare(worst.slenderness(), {allowed("review", is_printed(part.process) ? kPrinted : kCut)});
    f.what = fmt::format("height of a rib of {:.2f} mm, {:.1f} mm from the nearest wall twice as thick, over its thickness",
                         worst.at->wall_mm, worst.height_mm);
    set_place(f, worst.at->at_mm);
    f.suggestion = fmt::format("{} mm thick there, or {} mm lower", up(worst.height_mm / f.allowed),
                               up(worst.height_mm - f.allowed * worst.at->wall_mm));
    std::vector<std::uint32_t> triangles;
    for (const Rib& rib : all)  // by ascending triangle
        if (rib.slenderness() > f.allowed && (triangles.empty() || triangles.back() != rib.at->triangle))
            triangles.push_back(rib.at->triangle);
    return Marked{f, triangles};
}

/// The sample up to which the thinnest walls have this much area: a smaller spot is a scar, not a wall. nullptr: no wall.
const Sample* thinnest_of(const Body& body, double area_mm2) {
    std::vector<const Sample*> walls;
    for (const Sample& s : body.samples())
        if (!std::isnan(s.wall_mm)) walls.push_back(&s);
    std::stable_sort(walls.begin(), walls.end(), [](const Sample* a, const Sample* b) { return a->wall_mm < b->wall_mm; });
    double held = 0.0;
    for (const Sample* s : walls)
        if ((held += s->share_mm2) >= area_mm2) return s;
    return walls.empty() ? nullptr : walls.back();
}

std::optional<Marked> measure_mesh_wall(const Foreign& part, const Allowed& allowed) {
    const checks::ProcessLimits limits = checks::process_limits(part.process);
    const double wall = core::mm_from_m(limits.wall);
    const Sample* thinnest = thinnest_of(part.body, wall * wall);
    if (!thinnest) return std::nullopt;
    core::Finding f = compare(thinnest->wall_mm, {allowed("required", wall), allowed("review", core::mm_from_m(limits.loaded_wall))});
    f.what = f.severity == core::Severity::kWarning ? "thinnest wall, sufficient unless it carries load" : "thinnest wall";
    set_place(f, thinnest->at_mm);
    f.suggestion = fmt::format("{} mm thick there ({} mm more)", up(f.allowed), up(f.allowed - f.measured));
    return Marked{f, triangles_of(part.body, [&](const Sample& s) { return s.wall_mm < f.allowed; })};
}

}  // namespace

Rules thin_rules() {
    return {
        {{"mesh.feather_edge",
          "a knife edge that chips, cuts or cannot be made",
          "angle between two faces that meet in an edge, where the material is thinner than the process's wall",
          "30 deg (practice)",
          {review(kAtLeast, "deg", 30.0)}},
         measure_mesh_feather_edge},
        {{"mesh.gap",
          "a slot too narrow to make or to keep open",
          "least distance between two faces up to 30 deg off parallel, where a ball outside the material touches both",
          "the process's least detail",
          {of_process(review(kAtLeast, "mm", "the process's detail; none for plates"))}},
         measure_mesh_gap},
        {{"mesh.pin",
          "a pin that breaks off or cannot be made",
          "thickness (as mesh.wall) where the material is at most twice as wide across it; reported only where the limit is broken",
          "the process's least feature",
          {of_process(review(kAtLeast, "mm", "the process's feature"))}},
         measure_mesh_pin},
        {{"mesh.plate",
          "parts that do not lie on one plate of the machine",
          "several bodies or items: build volumes that they need as they lie; each by itself is judged by mesh.build_volume",
          "process.build_mm of --profile, else 200 mm; turning about z by 90 deg allowed",
          {review(kAtMost, "plates", 1.0)}},
         measure_mesh_plate,
         true},
        {{"mesh.plates",
          "a shape that is not a stack of plates",
          "wire, laser: share of the surface at more than 2 deg from horizontal and vertical",
          "1 % for chamfers and marks (practice)",
          {required(kAtMost, "%", 1.0)}},
         measure_mesh_plates},
        {{"mesh.rib",
          "a free-standing rib that bends or breaks",
          "distance of a wall thinner than two loaded walls from the nearest point of its body twice as thick, over the wall's thickness",
          "10 printed, 4 cut (practice)",
          {review(kAtMost, "thicknesses", "10 printed, 4 cut")}},
         measure_mesh_rib},
        {{"mesh.wall",
          "a wall too thin to make",
          "least distance between two faces up to 30 deg off parallel, where a ball in the material touches both; none where these "
          "meet in an edge: mesh.feather_edge",
          "the process's walls: thin required, loaded recommended",
          {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))}},
         measure_mesh_wall},
    };
}

}  // namespace fusee::inspect
