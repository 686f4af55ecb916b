#include <cmath>

#include "fusee/assembly/motion.h"
#include "scene/parts.h"
#include "scene/poses.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::CableKind, assembly::FreeCable, assembly::Side;
using Eigen::Vector3d;

constexpr double kDeadWrap = core::kPi / 6.0;  // shown on a drum beyond what works

Json node(const Vector3d& at, int channel = -1, const Vector3d& direction = Vector3d::Zero()) {
    return {{"at_mm", vector_json(at)}, {"slide", channel}, {"direction", vector_json(direction)}};
}

/// A cable that winds on a drum from a tangent point: angle wound = base + gain * channel [rad].
Json arc(const Vector3d& centre, const Vector3d& tangent, double direction, double base, int channel, double gain) {
    const Vector3d out = tangent - centre;
    return {{"centre_mm", vector_json(centre)},
            {"radius_mm", rounded(std::hypot(out.x(), out.y()))},
            {"start_rad", rounded(std::atan2(out.y(), out.x()))},
            {"direction", direction},
            {"base_rad", rounded(base)},
            {"channel", channel},
            {"gain", gain}};
}

/// Free cables of one side at rest, in the order of assembly::free_cables.
struct SideCables {
    FreeCable drive, to_guide, to_joint, parallel;
};

Json side_json(const Assembly& a, const SideCables& c, Side side) {
    const bool agonist = side == Side::kAgonist;
    const int first = agonist ? kTurnAgonist : kTurnAntagonist, carriage = first + kCarriageAgonist;
    const double sign = agonist ? 1.0 : -1.0;
    const Vector3d back(0.0, -1.0, 0.0);
    Vector3d motor = a.motor_axis_mm;
    motor.x() *= sign, motor.z() = c.drive.from_mm.z();
    const Vector3d joint(0.0, 0.0, c.to_joint.to_mm.z());
    const std::string of = std::string("_") + to_string(side);
    const double at_motor = c.drive.from_mm.x() > motor.x() ? -1.0 : 1.0;  // winds on the side away from the joint
    Json all = Json::array();
    all.push_back({{"name", "drive cable, " + std::string(to_string(side))},
                   {"from", nullptr},
                   {"nodes", {node(c.drive.to_mm, carriage, back), node(c.drive.from_mm)}},
                   {"arc", arc(motor, c.drive.from_mm, at_motor, kDeadWrap, first, 1.0)}});
    all.push_back({{"name", "series cable, " + std::string(to_string(side))},
                   {"from", "k_se" + of},
                   {"nodes", {node(c.to_guide.to_mm, carriage, back), node(c.to_joint.to_mm)}},
                   {"arc", arc(joint, c.to_joint.to_mm, sign, kDeadWrap + 0.5 * a.joint_range, kJointAngle, sign)}});
    Json nodes = Json::array({node(c.parallel.to_mm)});
    if (const assembly::Body* cap = a.find("k_pe_cap" + of)) {
        const Follows end = follows(a, *cap);
        nodes.push_back(node(cap->rest.translation(), end.slide, end.direction));
    }
    all.push_back({{"name", "parallel cable, " + std::string(to_string(side))}, {"from", "k_pe" + of}, {"nodes", nodes}, {"arc", nullptr}});
    return all;
}

}  // namespace

Json cables_json(const Assembly& a) {
    const std::vector<FreeCable> free = assembly::free_cables(a, {});
    Json all = side_json(a, {free[0], free[1], free[2], free[3]}, Side::kAgonist);
    for (Json& cable : side_json(a, {free[4], free[5], free[6], free[7]}, Side::kAntagonist)) all.push_back(std::move(cable));
    return all;
}

}  // namespace fusee::report
