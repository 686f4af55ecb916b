#include <algorithm>
#include <cmath>

#include "mill/setup.h"

namespace fusee::toolpath::mill {

namespace {

double outside(double value, const std::array<double, 2>& range) { return std::max({0.0, range[0] - value, value - range[1]}); }

/// A cylinder of the tool: everything above `z` within `radius` of the spindle's axis.
double overlap_of(double z, double radius, const Pose& pose, const Clamp& clamp) {
    if (!clamp.round) {
        const double away = std::hypot(outside(pose.x, clamp.x), outside(pose.y, clamp.y));
        return away < radius ? std::max(0.0, clamp.top - z) : 0.0;
    }
    if (outside(pose.x, clamp.x) >= radius) return 0.0;
    // The cylinder's nearest point to the rotary axis: beside it by what the radius does not bridge, and not below `z`.
    const double beside = std::max(0.0, std::abs(pose.y) - radius), above = std::max(0.0, z);
    return std::max(0.0, clamp.top - std::hypot(beside, above));
}

}  // namespace

double overlap(const Tool& tool, const Pose& pose, const Clamp& clamp) {
    return std::max({overlap_of(pose.z, tool.radius, pose, clamp), overlap_of(pose.z + tool.flute, tool.shank, pose, clamp),
                     overlap_of(pose.z + tool.stick_out, tool.holder, pose, clamp)});
}

}  // namespace fusee::toolpath::mill
