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

}  // namespace

Rule mesh_bodies() {
    return {{"mesh.bodies",
             "several bodies, or loose fragments, as one part",
             "most closed surfaces, cavities not counted, and loose open ones in one file, or in one build item of a 3MF",
             "one part per file or item (practice)",
             {review(kAtMost, "bodies", 1.0)}},
            measure_mesh_bodies,
            true};
}

}  // namespace fusee::inspect
