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

}  // namespace

Rule mesh_rib() {
    return {
        {"mesh.rib",
         "a free-standing rib that bends or breaks",
         "distance of a wall thinner than two loaded walls from the nearest point of its body twice as thick, over the wall's thickness",
         "10 printed, 4 cut (practice)",
         {review(kAtMost, "thicknesses", "10 printed, 4 cut")}},
        measure_mesh_rib};
}

}  // namespace fusee::inspect
