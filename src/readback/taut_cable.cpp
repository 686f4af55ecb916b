#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compare.h"
#include "fusee/core/units.h"

namespace fusee::readback {

namespace {

using core::dot;

/// Normal n of a cable that runs in direction D from the cam to the guide, such that the tension's moment has the correct sign if n points
/// from the axis to the cable: x cross D = torque_sign (n.x).
Point normal(const Point& direction, double torque_sign) { return {torque_sign * direction[1], -torque_sign * direction[0]}; }

/// The guide in the body frame at one working angle.
struct BodyGuide {
    bool parallel = true;
    Point place{};  ///< parallel: the cable's normal; else the guide's centre [mm]
    double torque_sign = 1.0;
    double beyond = 0.0;  ///< n.(centre) - arm: distance of the idler's centre outside the cable's line [mm]
};

BodyGuide in_body(const exchange::PartFile& part, double angle) {
    const double back = -part.rotation_sign * angle;
    BodyGuide guide;
    guide.torque_sign = part.torque_sign;
    guide.parallel = part.guide.kind == "parallel";
    guide.place = guide.parallel ? normal(turned(part.guide.direction, back), part.torque_sign) : turned(part.guide.position_mm, back);
    // (point on the cable - centre) cross D has the sign `sense` and the size `radius`; cross D is torque_sign (n.x).
    if (part.guide.kind == "idler") guide.beyond = -part.torque_sign * part.guide.sense * part.guide.radius_mm;
    return guide;
}

/// Arm of the line through the guide at that distance from the floor point F.
double arm_over(const BodyGuide& guide, const Point& floor, double distance) {
    if (guide.parallel) return dot(guide.place, floor) + distance;
    // n.F + distance + beyond = n.G: with v = G - F the line's normal has the component `reach` along v.
    const Point v{guide.place[0] - floor[0], guide.place[1] - floor[1]};
    const double length = std::hypot(v[0], v[1]), reach = distance + guide.beyond;
    if (std::abs(reach) >= length) return std::numeric_limits<double>::quiet_NaN();
    const Point along{v[0] / length, v[1] / length}, across = normal(along, guide.torque_sign);
    const double s = reach / length, c = std::sqrt(1.0 - s * s);
    return dot({s * along[0] + c * across[0], s * along[1] + c * across[1]}, floor) + distance;
}

/// Largest n.x of the floor's points, of which there is at least one. Four maxima side by side: none waits for another.
double farthest(const Floor& floor, const Point& n) {
    std::array<double, 4> far{};
    far.fill(-std::numeric_limits<double>::infinity());
    const std::size_t count = floor.points.size(), whole = count - count % far.size();
    for (std::size_t i = 0; i < whole; i += far.size())
        for (std::size_t k = 0; k < far.size(); ++k) far[k] = std::max(far[k], dot(n, floor.points[i + k].xy_mm));
    for (std::size_t i = whole; i < count; ++i) far[0] = std::max(far[0], dot(n, floor.points[i].xy_mm));
    return *std::max_element(far.begin(), far.end());
}

/// Points that follow each other, and a circle around them.
struct Block {
    std::size_t first = 0, last = 0;  ///< the one after them
    Point middle{};
    double radius = 0.0;
};

std::vector<Block> blocks_of(const Floor& floor) {
    constexpr std::size_t kPoints = 16;
    std::vector<Block> blocks;
    for (std::size_t first = 0; first < floor.points.size(); first += kPoints) {
        Block block{first, std::min(first + kPoints, floor.points.size())};
        for (std::size_t i = block.first; i < block.last; ++i)
            for (std::size_t k = 0; k < 2; ++k) block.middle[k] += floor.points[i].xy_mm[k] / static_cast<double>(block.last - block.first);
        for (std::size_t i = block.first; i < block.last; ++i) {
            const Point& p = floor.points[i].xy_mm;
            block.radius = std::max(block.radius, std::hypot(p[0] - block.middle[0], p[1] - block.middle[1]));
        }
        blocks.push_back(block);
    }
    return blocks;
}

/// The cable over the point with the largest arm so far, from a guide at a point or an idler. Turned about the guide so that its arm grows,
/// it leaves every point that lies within it and behind the guide; their arms are smaller. With t the turn, arm + beyond = |G| sin t grows
/// up to t = pi / 2, and the arm of such a point is at a turn less than pi before.
class Touching {
public:
    explicit Touching(const BodyGuide& guide) : guide_(guide) {}

    void touch(const Point& floor, double distance, double arm) {
        if (guide_.parallel) return;
        const Point v{guide_.place[0] - floor[0], guide_.place[1] - floor[1]};
        const double square = dot(v, v), reach = distance + guide_.beyond, ahead = std::sqrt(square - reach * reach);
        const Point across = normal(v, guide_.torque_sign);
        normal_ = {(reach * v[0] + ahead * across[0]) / square, (reach * v[1] + ahead * across[1]) / square};
        along_ = {(ahead * v[0] - reach * across[0]) / square, (ahead * v[1] - reach * across[1]) / square};
        arm_ = arm;
        holds_ = arm + guide_.beyond > 0.0 && dot(along_, guide_.place) > 0.0;
    }
    /// Surely no larger arm, and no NaN: the computed arms need not be compared.
    [[nodiscard]] bool within(const Point& floor, double distance) const {
        if (!holds_ || !(dot(normal_, floor) + distance < arm_ - kRounding_mm)) return false;
        const Point v{guide_.place[0] - floor[0], guide_.place[1] - floor[1]};
        const double reach = distance + guide_.beyond;
        return dot(along_, v) > 0.0 && dot(v, v) > kApart * reach * reach;
    }
    /// The same of all points of a block.
    [[nodiscard]] bool within(const Block& block, double distance) const {
        if (!holds_ || !(dot(normal_, block.middle) + block.radius + distance < arm_ - kRounding_mm)) return false;
        const Point v{guide_.place[0] - block.middle[0], guide_.place[1] - block.middle[1]};
        const double nearest = std::hypot(v[0], v[1]) - block.radius, reach = distance + guide_.beyond;
        return dot(along_, v) > block.radius && nearest > 0.0 && nearest * nearest > kApart * reach * reach;
    }

private:
    static constexpr double kApart = 1.0001, kRounding_mm = 1e-6;

    BodyGuide guide_;
    bool holds_ = false;
    Point normal_{}, along_{};
    double arm_ = 0.0;
};

/// The largest arm over the floor's points; NaN if there is none, or if the guide is nearer to the floor than the cable's radius.
/// @param first point that is asked first, and the one that was found: in the next row it is near the best
double row_arm(const Floor& floor, const std::vector<Block>& blocks, const BodyGuide& guide, double row_azimuth, double half_cable,
               std::size_t& first) {
    if (floor.planar && guide.parallel && floor.reach_mm.empty() && !floor.points.empty()) return farthest(floor, guide.place) + half_cable;
    double arm = -std::numeric_limits<double>::infinity();
    Touching touching(guide);
    std::size_t best = first;
    const auto ask = [&](std::size_t i) {
        const FloorPoint& p = floor.points[i];
        // On a helix the cable touches its own turn only: points more than a quarter turn further along the groove are at another height.
        if (!floor.planar && std::abs(p.azimuth - row_azimuth) > core::kPi / 2.0) return true;
        const double distance = floor.reach_mm.empty() ? half_cable : floor.reach_mm[i];
        if (touching.within(p.xy_mm, distance)) return true;
        const double candidate = arm_over(guide, p.xy_mm, distance);
        if (candidate > arm) arm = candidate, best = i, touching.touch(p.xy_mm, distance, candidate);
        return !std::isnan(candidate);
    };
    bool known = first >= floor.points.size() || ask(first);
    for (const Block& block : blocks) {
        if (floor.reach_mm.empty() && touching.within(block, half_cable)) continue;
        for (std::size_t i = block.first; known && i < block.last; ++i) known = ask(i);
    }
    first = best;
    return known && !std::isinf(arm) ? arm : std::numeric_limits<double>::quiet_NaN();
}

/// At a fleet angle the torque on the part is reduced by the cosine of that angle.
double share_in_plane(const exchange::PartFile& part, const BodyGuide& guide, const exchange::TargetRow& row) {
    if (guide.parallel) return 1.0;
    const auto& c = row.contact_mm;
    const double away = std::hypot(guide.place[0] - c[0], guide.place[1] - c[1]), idler = part.guide.radius_mm;
    const double free = std::sqrt(away * away - idler * idler);  // NaN for a contact within the idler
    return free / std::hypot(free, part.guide.z_mm - c[2]);
}

}  // namespace

std::vector<double> taut_arms(const Floor& floor, const exchange::PartFile& part) {
    std::vector<double> arms;
    arms.reserve(part.target.size());
    const std::vector<Block> blocks = blocks_of(floor);
    std::size_t best = 0;
    for (std::size_t row = 0; row < part.target.size(); ++row) {
        const double azimuth = floor.planar ? 0.0 : floor.row_azimuth[row];
        const BodyGuide guide = in_body(part, part.target[row].angle_rad);
        arms.push_back(share_in_plane(part, guide, part.target[row]) *
                       row_arm(floor, blocks, guide, azimuth, part.cable_diameter_mm / 2.0, best));
    }
    return arms;
}

}  // namespace fusee::readback
