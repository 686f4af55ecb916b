#include "fusee/solid/stack.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/cam/mirror.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

namespace {

using core::mm_from_m;

constexpr double kRingTolerance_mm = 5e-3;  // of the rings around which dowels need space
constexpr int kDirections = 36;             // of one dowel over half a turn; the other is opposite
constexpr int kSteps = 40;                  // along each, before the best one is refined
constexpr double kPlace_mm = 1e-4;          // accuracy of a dowel's place
constexpr double kGraze_mm = 0.05;          // a slot less deep in a plate is not cut through it

double core_of(const GrooveOptions& groove, double cable) { return groove.plate > 0.0 ? groove.plate : 2.0 * groove.radius_ratio * cable; }

/// Distance from q to a closed polygon, below 0 inside.
double distance(const Ring& ring, const Point2& q) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point2 &a = ring[j], &b = ring[i];
        const double dx = b[0] - a[0], dy = b[1] - a[1], length2 = dx * dx + dy * dy;
        const double share = length2 > 0.0 ? std::clamp(((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, std::hypot(q[0] - a[0] - share * dx, q[1] - a[1] - share * dy));
    }
    return holds(ring, q) ? -nearest : nearest;
}

/// The obstacles around dowels: bore, openings and groove floor.
class DowelSpace {
public:
    explicit DowelSpace(const Part& part) {
        const double half_cable = mm_from_m(0.5 * part.cam.options.cable_diameter);
        constexpr int kNormals = 360;
        for (int i = 0; i < kNormals; ++i) {
            const double psi = part.cam.groove_psi.low + core::kTurn * i / kNormals;
            floor_.push_back({std::cos(psi), std::sin(psi), mm_from_m(part.cam.path(psi).h) - half_cable});
        }
        holes_.push_back(ring_of(bore_outline(part.options.hub), kRingTolerance_mm));
        for (const Cutter& cutter : top_holes(part)) holes_.push_back(ring_of(cutter.outline, kRingTolerance_mm));
    }

    /// Radius of the largest free circle around q.
    [[nodiscard]] double about(const Point2& q) const {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [x, y, h] : floor_) least = std::min(least, h - q[0] * x - q[1] * y);
        for (const Ring& hole : holes_) least = std::min(least, distance(hole, q));
        return least;
    }

    /// The best place on a ray from the axis.
    [[nodiscard]] Point2 best_along(double angle) const {
        const auto at = [&](double r) { return Point2{r * std::cos(angle), r * std::sin(angle)}; };
        double farthest = 0.0;
        for (const auto& normal : floor_) farthest = std::max(farthest, normal[2]);
        const double step = farthest / kSteps;
        double best = step;
        for (int i = 2; i < kSteps; ++i)
            if (about(at(step * i)) > about(at(best))) best = step * i;
        double low = best - step, high = best + step;
        while (high - low > kPlace_mm) {
            const double inner = low + (high - low) / 3.0, outer = high - (high - low) / 3.0;
            if (about(at(inner)) < about(at(outer)))
                low = inner;
            else
                high = outer;
        }
        return at(0.5 * (low + high));
    }

private:
    std::vector<std::array<double, 3>> floor_;  ///< normal and distance of its tangents
    std::vector<Ring> holes_;
};

}  // namespace

Dowels place_dowels(const Part& part) {
    if (part.cam.rotation_sign < 0.0) {  // equal places are decided alike for a part and its mirror image
        Part image;
        image.cam = cam::mirrored(part.cam), image.options = mirrored(part.options), image.z_high = part.z_high;
        Dowels dowels = place_dowels(image);
        for (Point2& centre : dowels.centres_mm) centre[1] = -centre[1];
        return dowels;
    }
    const DowelSpace space(part);
    Dowels best;
    best.space_mm = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < kDirections; ++i) {
        const double angle = core::kPi * i / kDirections;
        const std::array<Point2, 2> centres{space.best_along(angle), space.best_along(angle + core::kPi)};
        const double here = 2.0 * std::min(space.about(centres[0]), space.about(centres[1]));
        if (here > best.space_mm) best = {centres, here};
    }
    return best;
}

bool is_stack(const cam::Cam& cam, const PartOptions& options) {
    return options.groove.stacked && cam.closed() && !cam.has_roller() && options.hub.boss_height <= 0.0;
}

std::vector<SectionPoint> stack_section(const cam::Cam& cam, const PartOptions& options) {
    const double d = mm_from_m(cam.options.cable_diameter), half = 0.5 * mm_from_m(core_of(options.groove, cam.options.cable_diameter));
    const double floor = -0.5 * d, lip = floor + options.groove.depth_ratio * d;
    return {{lip, -half}, {floor, -half}, {floor, 0.0}, {floor, half}, {lip, half}};
}

double core_thickness(const Part& part) { return core_of(part.options.groove, part.cam.options.cable_diameter); }

std::vector<Plate> stack_plates(const Part& part) {
    const double rib = mm_from_m(part.options.groove.rib), core = mm_from_m(core_thickness(part));
    const Flanges flanges = flanges_of(part.options);
    const double lip = part.section.front().offset_mm;
    std::vector<Plate> plates{{"lower flange", rib, lip + flanges.lower_height_mm, {}},
                              {"core", core, -mm_from_m(0.5 * part.cam.options.cable_diameter), {}},
                              {"upper flange", rib, lip + flanges.upper_height_mm, {}}};
    const Dowels dowels = place_dowels(part);
    for (Plate& plate : plates) {
        plate.openings.push_back({"bore", bore_outline(part.options.hub)});
        for (const Point2& centre : dowels.centres_mm)
            if (dowels.space_mm > kDowel_mm) plate.openings.push_back({"dowel", circle(0.5 * (kDowel_mm - kReamed_mm), centre)});
    }
    const double slot_mm = mm_from_m(part.options.features.leg_slot_depth) - kGraze_mm;
    const std::array above{rib + core, rib, 0.0};  // of each plate
    for (const Cutter& cutter : top_holes(part))
        for (std::size_t i = 0; i < plates.size(); ++i)
            if ((cutter.name == "anchor" && i > 0) || (cutter.name == "leg_slot" && slot_mm > above[i]))
                plates[i].openings.push_back({cutter.name, cutter.outline});
    return plates;
}

std::optional<Outline> inset(const Outline& outline, double inset_mm) {
    Outline smaller = outline;
    for (Arc& arc : smaller) {
        if (arc.radius_mm <= inset_mm) return std::nullopt;
        arc.radius_mm -= inset_mm;
    }
    return smaller;
}

}  // namespace fusee::solid
