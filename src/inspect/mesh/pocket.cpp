#include "fusee/core/parallel.h"
#include "measure.h"

namespace fusee::inspect {

namespace {

constexpr double kFloor = 0.9;                    // cosine of a floor's normal with z
constexpr double kFloorLift_mm = 0.05;            // rays towards the tool start this far above the floor
constexpr double kFacing = -0.99;                 // cosine between walls that face each other
constexpr std::size_t kMostFloors = 3000;         // floor samples that are checked
constexpr int kPocketWidths = 8, kHalvings = 10;  // over half a turn; of the height

struct Pocket {
    double width_mm = NAN, depth_mm = 0.0;
    const Sample* floor = nullptr;
    [[nodiscard]] double ratio() const { return depth_mm > 0.0 ? depth_mm / width_mm : 0.0; }
};

class Walls {
public:
    Walls(const Body& body, std::vector<bool> drilled) : body_(body), drilled_(std::move(drilled)) {}

    /// Width between two walls that face each other, from `at` along d; NaN without walls and in a drilled hole.
    [[nodiscard]] double width(const Vec3& at, const Vec3& d) const {
        const auto there = body_.rays().first(at, d, kNone), back = body_.rays().first(at, -1.0 * d, kNone);
        if (!there || !back || (drilled_[there->triangle] && drilled_[back->triangle])) return NAN;
        if (dot(body_.normals()[there->triangle], body_.normals()[back->triangle]) > kFacing) return NAN;
        return there->distance_mm + back->distance_mm;
    }

    /// The least width over this floor, and the height of its walls.
    [[nodiscard]] Pocket at(const Sample& floor) const {
        Pocket pocket;
        pocket.floor = &floor;
        const Vec3 from = floor.at_mm + kFloorLift_mm * Vec3{0, 0, 1};
        Vec3 across{};
        for (int i = 0; i < kPocketWidths; ++i) {
            const double a = core::kPi * i / kPocketWidths;
            const Vec3 d{std::cos(a), std::sin(a), 0.0};
            if (const double w = width(from, d); w < pocket.width_mm || (std::isnan(pocket.width_mm) && !std::isnan(w)))
                pocket.width_mm = w, across = d;
        }
        if (std::isnan(pocket.width_mm)) return pocket;
        double shut = 0.0, open = body_.box().high_mm[2] - from[2];
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (shut + open);
            (std::isnan(width(from + middle * Vec3{0, 0, 1}, across)) ? open : shut) = middle;
        }
        pocket.depth_mm = kFloorLift_mm + shut;
        return pocket;
    }

private:
    const Body& body_;
    std::vector<bool> drilled_;
};

std::vector<Pocket> pockets(const Body& body) {
    std::vector<bool> drilled(body.mesh().triangles.size(), false);
    for (const Hollow& h : body.hollows())
        if (h.is_hole())
            for (const std::uint32_t t : h.triangles) drilled[t] = true;
    std::vector<const Sample*> floors;
    for (const Sample& s : body.samples())
        if (body.normals()[s.triangle][2] > kFloor) floors.push_back(&s);
    const std::size_t step = floors.size() / kMostFloors + 1;
    std::vector<Pocket> all((floors.size() + step - 1) / step);
    const Walls walls(body, std::move(drilled));
    core::parallel_for(all.size(), body.jobs(), [&](std::size_t i) { all[i] = walls.at(*floors[i * step]); });
    return all;
}

std::optional<Marked> measure_mesh_pocket(const Foreign& part, const Allowed& allowed) {
    if (!is_milled(part.process)) return std::nullopt;
    const std::vector<Pocket> all = pockets(part.body);
    const auto worst = std::max_element(all.begin(), all.end(), [](const Pocket& a, const Pocket& b) { return a.ratio() < b.ratio(); });
    if (worst == all.end() || !(worst->ratio() > 0.0)) return std::nullopt;
    core::Finding f = compare(worst->ratio(), {allowed("review")});
    f.what = fmt::format("depth of a pocket of {:.2f} mm width over that width, the largest possible tool diameter", worst->width_mm);
    set_place(f, worst->floor->at_mm);
    f.suggestion = fmt::format("{} mm wide, or {} mm deep", up(worst->depth_mm / f.allowed), down(f.allowed * worst->width_mm));
    std::vector<std::uint32_t> triangles;
    for (const Pocket& p : all)
        if (p.ratio() > f.allowed && (triangles.empty() || triangles.back() != p.floor->triangle)) triangles.push_back(p.floor->triangle);
    return Marked{f, triangles};
}

}  // namespace

Rule mesh_pocket() {
    return {{"mesh.pocket",
             "a pocket too deep for the tool that fits into it",
             "milled: depth over width, between walls that face each other, above upward faces; drilled holes not counted",
             "pocket <= 3 tools deep: zekes3d, procurabl, neptunelabs, super-ingenuity, Xometry",
             {review(kAtMost, "widths", 3.0)}},
            measure_mesh_pocket};
}

}  // namespace fusee::inspect
