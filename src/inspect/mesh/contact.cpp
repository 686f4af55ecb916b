#include "measure.h"

namespace fusee::inspect {

namespace {

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
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    if (first) set_place(f, first->at_mm);
    f.suggestion = fmt::format("a union of the bodies, or {:g} mm between them; each is judged by itself, as if the other were not there",
                               core::mm_from_m(checks::process_limits(part.process).wall));
    return Marked{f, triangles};
}

}  // namespace

Rule mesh_contact() {
    return {{"mesh.contact",
             "bodies that overlap or touch",
             "several bodies: pairs of which one has at least 0.01 mm^2 of its surface 0.01 mm deep in the other, or which have corners in "
             "common; pairs that only touch",
             "a reader joins equal corners, and a solid does not intersect another one",
             {required(kAtMost, "pairs", 0.0), review(kAtMost, "pairs", 0.0, "touch_review")}},
            measure_mesh_contact,
            true};
}

}  // namespace fusee::inspect
