#include "measure.h"

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

}  // namespace

Rule mesh_hole() {
    return {{"mesh.hole",
             "a hole too small to make",
             "diameter of the smallest cylindrical hole: facets along one axis with their corners on a circle, over 200 deg of it; a "
             "diameter 0.1 % "
             "below its limit meets it",
             "the process's least hole",
             {of_process(required(kAtLeast, "mm", "the process's hole"))}},
            measure_mesh_hole};
}

}  // namespace fusee::inspect
