#include "fusee/core/parallel.h"
#include "measure.h"

namespace fusee::inspect {

namespace {

constexpr double kSlender = 2.0;    // largest ratio of the two widths of a pin
constexpr double kParallel = -0.9;  // cosine between the normals at both ends of a width
constexpr int kWidths = 8;          // over half a turn

/// Least width of the material through `middle`, across the thickness along `n`, between faces that face away from each other; NaN if none.
double width_across(const Body& body, const Vec3& middle, const Vec3& n) {
    const Frame frame = frame_about(n);
    double least = NAN;
    for (int i = 0; i < kWidths; ++i) {
        const double a = core::kPi * i / kWidths;
        const Vec3 d = std::cos(a) * frame.u + std::sin(a) * frame.v;
        const auto there = body.rays().first(middle, d, kNone), back = body.rays().first(middle, -1.0 * d, kNone);
        if (!there || !back || dot(body.normals()[there->triangle], body.normals()[back->triangle]) > kParallel) continue;
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

}  // namespace

Rule mesh_pin() {
    return {{"mesh.pin",
             "a pin that breaks off or cannot be made",
             "thickness (as mesh.wall) where the material is at most twice as wide across it; reported only where the limit is broken",
             "the process's least feature",
             {of_process(review(kAtLeast, "mm", "the process's feature"))}},
            measure_mesh_pin};
}

}  // namespace fusee::inspect
