#include <set>

#include "fusee/core/lists.h"
#include "measure.h"

namespace fusee::inspect {

namespace {

/// A closed body counts as 1; open surfaces may be fragments.
std::size_t surfaces(const Piece& piece) { return piece.body.topology().open_edges == 0 ? 1 : piece.body.topology().components.size(); }

std::optional<Marked> measure_mesh_bodies(const Foreign& part, const Allowed& allowed) {
    const File& file = *part.file;
    std::vector<std::size_t> bodies(file.items().size(), 0);
    for (const Piece& piece : file.pieces()) bodies[piece.item] += surfaces(piece);
    const auto most = std::max_element(bodies.begin(), bodies.end());
    const auto item = static_cast<std::size_t>(most - bodies.begin());
    core::Finding f = compare(static_cast<double>(*most), {allowed("review")});
    f.what = "separate bodies";
    std::string sizes;
    std::vector<std::uint32_t> others;
    const Piece* first = nullptr;
    std::size_t named = 0;
    for (const Piece& piece : file.pieces()) {
        if (piece.item != item) continue;
        if (first) others.insert(others.end(), piece.triangles.begin(), piece.triangles.end());
        if (!first) first = &piece;
        const Vec3 size = piece.body.box().high_mm - piece.body.box().low_mm;
        if (++named <= 4)
            sizes += fmt::format("{}{} of {:.2f} x {:.2f} x {:.2f} mm", named == 1 ? ": " : ", ", piece.name, size[0], size[1], size[2]);
        if (named == 5) sizes += ", ...";
    }
    if (*most > 1) f.what += sizes;
    std::sort(others.begin(), others.end());
    if (file.items().size() > 1 && first && *most > 1) f.where = file.items()[item].name;
    f.suggestion = fmt::format("each of the {} bodies in a file or 3MF item of its own, or joined; each is judged by itself", *most);
    return Marked{f, others};
}

std::optional<Marked> measure_mesh_build_volume(const Foreign& part, const Allowed& allowed) {
    const solid::Box& box = part.body.box();
    Vec3 size = box.high_mm - box.low_mm;
    const checks::Process& process = part.process;
    const Vec3 build{core::mm_from_m(process.build_x), core::mm_from_m(process.build_y), core::mm_from_m(process.build_z)};
    if ((size[0] > size[1]) != (build[0] > build[1])) std::swap(size[0], size[1]);  // turned by 90 deg about z
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (size[i] / build[i] > size[axis] / build[axis]) axis = i;
    core::Finding f = compare(size[axis], {allowed("required", build[axis])});
    f.what = fmt::format("part of {:.2f} x {:.2f} x {:.2f} mm in a build volume of {:g} x {:g} x {:g} mm", size[0], size[1], size[2],
                         build[0], build[1], build[2]);
    f.where = fmt::format("along {}", "xyz"[axis]);
    f.suggestion = fmt::format("a machine of {} x {} x {} mm, or the part scaled by {}", up(std::max(size[0], build[0])),
                               up(std::max(size[1], build[1])), up(std::max(size[2], build[2])), down(build[axis] / size[axis]));
    return Marked{f};
}

std::optional<Marked> measure_mesh_cavity(const Foreign& part, const Allowed& allowed) {
    if (part.process.kind == checks::ProcessKind::kFdm) return std::nullopt;  // FDM can print closed cavities
    const Topology& topology = part.body.topology();
    double volume = 0.0;
    for (std::size_t c = 0; c < topology.components.size(); ++c)
        if (part.body.cavity()[c]) volume -= topology.components[c].volume_mm3;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < topology.component_of.size(); ++t)
        if (part.body.cavity()[topology.component_of[t]]) triangles.push_back(t);
    core::Finding f = compare(volume, {allowed("required")});
    f.what = is_printed(part.process) ? "closed cavity: unhardened material cannot leave it" : "closed cavity, which no tool can reach";
    if (!triangles.empty()) set_place(f, middle_of(part.body, triangles.front()));
    f.suggestion =
        fmt::format("two openings of at least {:g} mm, or no cavity", core::mm_from_m(checks::process_limits(part.process).hole));
    return Marked{f, triangles};
}

std::optional<Marked> measure_mesh_closed(const Foreign& part, const Allowed& allowed) {
    const Topology& topology = part.body.topology();
    core::Finding f = compare(static_cast<double>(topology.open_edges), {allowed("required")});
    f.what = "edges of one triangle only: the surface has holes and no inside";
    if (!topology.open.empty()) set_place(f, middle_of(part.body, topology.open.front()));
    f.suggestion = fmt::format("the {} triangles along the gap stitched or capped in the program that drew them", topology.open.size());
    return Marked{f, topology.open};
}

std::string text_of(const File& file, const Contact& c) {
    const std::string both = fmt::format("{} and {}", named(file, c.a), named(file, c.b));
    switch (c.kind) {
        case Contact::Kind::kOverlap:
            return fmt::format("{} overlap: {:.3g} mm^2 of the surface of one are inside the other", both, c.area_mm2);
        case Contact::Kind::kShare:
            return fmt::format("{} touch: {} corners belong to both", both, c.corners);
        case Contact::Kind::kTouch:
            break;
    }
    return both + " touch";
}

std::optional<Marked> measure_mesh_contact(const Foreign& part, const Allowed& allowed) {
    const File& file = *part.file;
    if (file.pieces().size() < 2) return std::nullopt;
    const auto count = [&file](const auto& counts) {
        return static_cast<double>(std::count_if(file.contacts().begin(), file.contacts().end(), counts));
    };
    const auto is_wrong = [](const Contact& c) { return c.kind != Contact::Kind::kTouch; };
    const double wrong = count(is_wrong), touch = count([&](const Contact&c) { return !is_wrong(c); });
    core::Finding f = compare(wrong, {allowed("required")});
    if (f.severity == core::Severity::kPass) f = compare(touch, {allowed("touch_review")});
    f.what = "pairs of bodies that overlap or touch";
    std::size_t told = 0;
    const Contact* first = nullptr;
    std::vector<std::uint32_t> triangles;
    for (const Contact& c : file.contacts()) {
        if ((wrong > 0.0) != is_wrong(c)) continue;
        if (!first) first = &c;
        if (++told <= 3) f.what += (told == 1 ? ": " : "; ") + text_of(file, c);
        const std::vector<std::uint32_t>& second = file.pieces()[c.b].triangles;
        triangles.insert(triangles.end(), second.begin(), second.end());
    }
    if (told > 3) f.what += fmt::format("; and {} more", told - 3);
    triangles = core::sorted_unique(std::move(triangles));
    if (first) set_place(f, first->at_mm);
    f.suggestion = fmt::format("a union of the bodies, or {:g} mm between them; each is judged by itself, as if the other were not there",
                               core::mm_from_m(checks::process_limits(part.process).wall));
    return Marked{f, triangles};
}

std::optional<Marked> measure_mesh_flat_triangles(const Foreign& part, const Allowed& allowed) {
    const std::vector<std::uint32_t> flat = flat_triangles(part.body.mesh());
    core::Finding f = compare(static_cast<double>(flat.size()), {allowed("review")});
    f.what = "triangles without area: some readers drop them and leave a hole";
    if (!flat.empty()) set_place(f, middle_of(part.body, flat.front()));
    f.suggestion = fmt::format("{} triangles collapsed in the program that drew them", flat.size());
    return Marked{f, flat};
}

std::optional<Marked> measure_mesh_manifold(const Foreign& part, const Allowed& allowed) {
    const Topology& topology = part.body.topology();
    core::Finding f = compare(static_cast<double>(topology.crowded_edges + topology.pinched_points), {allowed("required")});
    f.what = fmt::format("{} edges of more than two triangles and {} points at which surfaces meet without an edge", topology.crowded_edges,
                         topology.pinched_points);
    std::vector<std::uint32_t> triangles = topology.crowded;
    if (triangles.empty()) triangles = topology.pinched;
    if (!triangles.empty()) set_place(f, middle_of(part.body, triangles.front()));
    f.suggestion =
        fmt::format("bodies that touch there joined or moved apart by {:g} mm", core::mm_from_m(checks::process_limits(part.process).wall));
    return Marked{f, triangles};
}

std::optional<Marked> measure_mesh_orientation(const Foreign& part, const Allowed& allowed) {
    const Topology& topology = part.body.topology();
    std::vector<std::uint32_t> triangles = topology.flipped;
    std::size_t turned = 0;
    for (const bool t : part.body.turned()) turned += t ? 1 : 0;
    for (std::uint32_t t = 0; t < topology.component_of.size() && topology.flipped.empty(); ++t)
        if (part.body.turned()[topology.component_of[t]]) triangles.push_back(t);
    core::Finding f = compare(static_cast<double>(topology.flipped_edges + turned), {allowed("required")});
    f.what = fmt::format("{} edges whose two triangles face opposite sides, and {} bodies whose triangles face inward",
                         topology.flipped_edges, turned);
    if (!triangles.empty()) set_place(f, middle_of(part.body, triangles.front()));
    f.suggestion = fmt::format("{} triangles to turn: corners counter-clockwise seen from outside", triangles.size());
    return Marked{f, triangles};
}

std::optional<Marked> measure_mesh_samples(const Foreign& part, const Allowed& allowed) {
    const Body& body = part.body;
    const std::size_t left_out = body.samples_left_out() + body.components_left_out();
    if (left_out == 0) {
        core::Finding f = compare(0.0, {allowed("required")});
        f.what = "points that were left out";
        return Marked{f};
    }
    core::Finding f =
        core::not_judged("mesh.samples",
                         fmt::format("{} of {} points and {} components were left out, because too many triangles overlap; "
                                     "walls, slots, holes and undercuts there are not known",
                                     body.samples_left_out(), body.samples_left_out() + body.samples().size(), body.components_left_out()),
                         "a mesh whose triangles do not overlap");
    return Marked{f};
}

std::optional<Marked> measure_mesh_self_intersection(const Foreign& part, const Allowed& allowed) {
    const Body& body = part.body;
    const solid::Crossings& found = body.crossings();
    if (!found.manifold)
        return Marked{core::not_judged("mesh.self_intersection", "the surface is not manifold: self-intersections cannot be determined",
                                       "a manifold surface: see mesh.manifold and mesh.orientation")};
    if (!found.complete)
        return Marked{core::not_judged(
            "mesh.self_intersection",
            fmt::format("more than {} pairs of triangles are near enough to cross; none was checked", solid::kMostNearPairs),
            "a mesh whose triangles do not overlap")};
    std::set<std::uint32_t> triangles;
    for (const auto& [a, b] : found.pairs) triangles.insert({a, b});
    core::Finding f = compare(static_cast<double>(found.pairs.size()), {allowed("required")});
    f.what = "pairs of triangles that intersect";
    if (!triangles.empty()) set_place(f, middle_of(body, *triangles.begin()));
    f.suggestion = fmt::format("a union of the bodies that overlap in {} triangles", triangles.size());
    return Marked{f, {triangles.begin(), triangles.end()}};
}

constexpr double kInch = 25.4, kMetre = 1000.0;  // [mm]

std::optional<Marked> measure_mesh_unit(const Foreign& part, const Allowed& allowed) {
    const auto longest_of = [](const Vec3& size) { return std::max({size[0], size[1], size[2]}); };
    Vec3 size{};
    for (const Piece& piece : part.file->pieces())
        if (const Vec3 own = piece.body.box().high_mm - piece.body.box().low_mm; longest_of(own) > longest_of(size)) size = own;
    const double longest = longest_of(size);
    core::Finding small = compare(longest, {allowed("small_review")}), large = compare(longest, {allowed("large_review")});
    core::Finding f = small.severity != core::Severity::kPass ? small : large;
    f.what = fmt::format("longest side of {:.4g} x {:.4g} x {:.4g} mm, if the file's unit is the millimetre", size[0], size[1], size[2]);
    f.suggestion = f.bound == kAtLeast ? fmt::format("scaled by {:g} if drawn in inches ({:.4g} mm), by {:g} if in metres ({:.4g} mm)",
                                                     kInch, kInch * longest, kMetre, kMetre * longest)
                                       : fmt::format("scaled by 0.001 if drawn in micrometres ({:.4g} mm)", 0.001 * longest);
    return Marked{f};
}

}  // namespace

Rules soundness_rules() {
    return {
        {{"mesh.bodies",
          "several bodies, or loose fragments, as one part",
          "most closed surfaces, cavities not counted, and loose open ones in one file, or in one build item of a 3MF",
          "one part per file or item (practice)",
          {review(kAtMost, "bodies", 1.0)}},
         measure_mesh_bodies,
         true},
        {{"mesh.build_volume",
          "a part larger than the machine or the stock",
          "the tightest side of the bounding box",
          "process.build_mm of --profile, else 200 mm; turning about z by 90 deg allowed",
          {required(kAtMost, "mm", "process.build_mm")}},
         measure_mesh_build_volume},
        {{"mesh.cavity",
          "a cavity that is closed on all sides",
          "all except FDM: volume of the cavities inside the material",
          "resin and powder must leave, a tool must enter (practice)",
          {required(kAtMost, "mm^3", 0.0)}},
         measure_mesh_cavity},
        {{"mesh.closed",
          "a surface with holes in it",
          "edges that belong to one triangle only",
          "a solid has none",
          {required(kAtMost, "edges", 0.0)}},
         measure_mesh_closed},
        {{"mesh.contact",
          "bodies that overlap or touch",
          "several bodies: pairs of which one has at least 0.01 mm^2 of its surface 0.01 mm deep in the other, or which have corners in "
          "common; pairs that only touch",
          "a reader joins equal corners, and a solid does not intersect another one",
          {required(kAtMost, "pairs", 0.0), review(kAtMost, "pairs", 0.0, "touch_review")}},
         measure_mesh_contact,
         true},
        {{"mesh.flat_triangles",
          "triangles that a reader may drop",
          "triangles whose height is below 1e-9 of their longest edge",
          "none (practice)",
          {review(kAtMost, "triangles", 0.0)}},
         measure_mesh_flat_triangles},
        {{"mesh.manifold",
          "a surface that touches itself in an edge or a point",
          "edges of more than two triangles, and points at which fans of triangles meet without an edge",
          "a solid has none",
          {required(kAtMost, "places", 0.0)}},
         measure_mesh_manifold},
        {{"mesh.orientation",
          "triangles that face the wrong way",
          "edges along which both triangles run the same way, and closed bodies whose triangles face inward",
          "a solid has none",
          {required(kAtMost, "places", 0.0)}},
         measure_mesh_orientation},
        {{"mesh.samples",
          "walls and slots that were not measured",
          "points left out because measuring them would visit more than 8e8 triangles in all, or 2e8 where triangles overlap",
          "a point that is not measured is not judged",
          {required(kAtMost, "places", 0.0)}},
         measure_mesh_samples},
        {{"mesh.self_intersection",
          "a surface that intersects itself",
          "pairs of triangles that intersect; for manifold surfaces only (exact predicates)",
          "a solid has none",
          {required(kAtMost, "pairs", 0.0)}},
         measure_mesh_self_intersection},
        {{"mesh.unit",
          "a file in a unit other than the millimetre",
          "the longest side of the bounding box, of several bodies that of the largest",
          "machine parts are 3 mm to 1 m long (practice)",
          {review(kAtLeast, "mm", 3.0, "small_review"), review(kAtMost, "mm", 1000.0, "large_review")}},
         measure_mesh_unit,
         true},
    };
}

}  // namespace fusee::inspect
