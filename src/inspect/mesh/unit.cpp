#include "measure.h"

namespace fusee::inspect {

namespace {

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

Rule mesh_unit() {
    return {{"mesh.unit",
             "a file in a unit other than the millimetre",
             "the longest side of the bounding box, of several bodies that of the largest",
             "machine parts are 3 mm to 1 m long (practice)",
             {review(kAtLeast, "mm", 3.0, "small_review"), review(kAtMost, "mm", 1000.0, "large_review")}},
            measure_mesh_unit,
            true};
}

}  // namespace fusee::inspect
