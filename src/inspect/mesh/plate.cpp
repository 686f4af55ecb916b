#include "measure.h"

namespace fusee::inspect {

namespace {

solid::Box joined(const solid::Box& a, const solid::Box& b) {
    solid::Box both;
    for (std::size_t i = 0; i < 3; ++i)
        both.low_mm[i] = std::min(a.low_mm[i], b.low_mm[i]), both.high_mm[i] = std::max(a.high_mm[i], b.high_mm[i]);
    return both;
}

/// True if the box fits as it lies, or turned by 90 deg about z.
bool fits(const solid::Box& box, const Vec3& build) {
    const Vec3 size = box.high_mm - box.low_mm;
    constexpr double kRounding = 1e-6;
    const auto within = [&](double x, double y) {
        return x <= build[0] + kRounding && y <= build[1] + kRounding && size[2] <= build[2] + kRounding;
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

}  // namespace

Rule mesh_plate() {
    return {{"mesh.plate",
             "parts that do not lie on one plate of the machine",
             "several bodies or items: build volumes that they need as they lie; each by itself is judged by mesh.build_volume",
             "process.build_mm of --profile, else 200 mm; turning about z by 90 deg allowed",
             {review(kAtMost, "plates", 1.0)}},
            measure_mesh_plate,
            true};
}

}  // namespace fusee::inspect
