#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/parallel.h"
#include "measure.h"

namespace fusee::inspect {

namespace {

constexpr double kThick = 2.0;           // the base of a rib is this many times as thick
constexpr double kWalls = 2.0;           // a rib is thinner than this many loaded walls
constexpr std::size_t kMostThin = 4000;  // thin samples that are checked
constexpr double kPrinted = 10.0, kCut = 4.0;

struct Rib {
    const Sample* at = nullptr;
    double height_mm = 0.0;
    [[nodiscard]] double slenderness() const { return height_mm / at->wall_mm; }
};

/// Distance from each thin sample to the nearest one under which a ball of twice its thickness fits. A plate that is thin everywhere has no
/// rib.
std::vector<Rib> ribs(const Body& body, double thin) {
    std::vector<Rib> all;
    std::vector<const Sample*> known;
    for (const Sample& s : body.samples()) {
        known.push_back(&s);
        if (s.wall_mm < thin && !s.feather) all.push_back({&s});
    }
    const std::size_t step = all.size() / kMostThin + 1;
    for (std::size_t i = 0; i * step < all.size(); ++i) all[i] = all[i * step];
    all.resize((all.size() + step - 1) / step);
    core::parallel_for(all.size(), body.jobs(), [&](std::size_t i) {
        double nearest = INFINITY;
        for (const Sample* other : known)
            if (other->ball_mm >= kThick * all[i].at->wall_mm) {
                const Vec3 way = other->at_mm - all[i].at->at_mm;
                nearest = std::min(nearest, dot(way, way));
            }
        all[i].height_mm = std::isinf(nearest) ? 0.0 : std::sqrt(nearest);
    });
    return all;
}

std::optional<Marked> measure_mesh_rib(const Foreign& part, const Allowed& allowed) {
    const double thin = kWalls * core::mm_from_m(checks::process_limits(part.process).loaded_wall);
    const std::vector<Rib> all = ribs(part.body, thin);
    if (all.empty()) return std::nullopt;
    const Rib& worst =
        *std::max_element(all.begin(), all.end(), [](const Rib& a, const Rib& b) { return a.slenderness() < b.slenderness(); });
    core::Finding f = judge(worst.slenderness(), {allowed("review", is_printed(part) ? kPrinted : kCut)});
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

}  // namespace

Rule mesh_rib() {
    return {{"mesh.rib",
             "a free-standing rib that bends or breaks",
             "distance of a wall thinner than two loaded walls from the nearest point twice as thick, over the wall's thickness",
             "10 printed, 4 cut (practice)",
             {review(kAtMost, "thicknesses", "10 printed, 4 cut")}},
            measure_mesh_rib};
}

}  // namespace fusee::inspect
