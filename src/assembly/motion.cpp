#include "fusee/assembly/motion.h"

#include <cmath>

#include "layout.h"

namespace fusee::assembly {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Linear between the rows of a table, of which `from` rises.
double between(const std::vector<Travel>& table, double Travel::*from, double Travel::*to, double value) {
    const auto above = std::lower_bound(table.begin() + 1, table.end() - 1, value, [&](const Travel& t, double v) { return t.*from < v; });
    const Travel &a = *(above - 1), &b = *above;
    return a.*to + (b.*to - a.*to) * (value - a.*from) / (b.*from - a.*from);
}

double sign_of(Side side) { return side == Side::kAntagonist ? -1.0 : 1.0; }

Isometry3d turned(double angle) { return Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitZ())); }
Isometry3d shifted(const Vector3d& by) { return Isometry3d(Eigen::Translation3d(by)); }

Vector3d along_k_pe(const Assembly& a, Side side) {
    return {sign_of(side) * std::cos(a.options.k_pe_direction), std::sin(a.options.k_pe_direction), 0.0};
}

/// A place of the agonist on the side asked for.
Vector3d on_side(Vector3d point, Side side, double plane_mm) {
    if (side == Side::kAntagonist) point.x() *= -1.0, point.z() -= 2.0 * plane_mm;
    return point;
}

/// Where the cable leaves the cam: its centreline's contact, turned with the body.
Vector3d contact_mm(const Assembly& a, const Body& body, const cam::Cam& cam, double angle, const Pose& pose) {
    const auto above = std::upper_bound(cam.working.begin() + 1, cam.working.end() - 1, angle,
                                        [](double value, const cam::Contact& contact) { return value < contact.arm.angle; });
    const cam::PathPoint& p = (above - 1)->path;
    const double mirror = body.side == Side::kAntagonist ? -1.0 : 1.0;  // the part itself is a mirror image, y -> -y
    return placement(a, body, pose) * Vector3d(1e3 * p.x(), mirror * 1e3 * p.y(), 1e3 * p.z);
}

}  // namespace

Pose pose_of(const Assembly& a, double agonist_turn, double antagonist_turn, double joint) {
    return {{agonist_turn, a.capstan_radius_mm * agonist_turn + a.joint_radius_mm * joint},
            {antagonist_turn, a.capstan_radius_mm * antagonist_turn - a.joint_radius_mm * joint}};
}

double greatest_joint_angle(const Assembly& a, double turn) {
    const double paid = a.capstan_radius_mm * turn;
    return std::max(0.0, std::min({0.5 * a.joint_range, paid / a.joint_radius_mm, (a.greatest_payout_mm - paid) / a.joint_radius_mm}));
}

double joint_angle(const Assembly& a, const Pose& pose) {
    return (pose.agonist.payout_mm - a.capstan_radius_mm * pose.agonist.turn) / a.joint_radius_mm;
}

double spool_angle(const Assembly& a, double payout_mm) { return between(a.k_se, &Travel::length_mm, &Travel::angle, payout_mm); }
double drawn_mm(const Assembly& a, double turn) { return between(a.k_pe, &Travel::angle, &Travel::length_mm, turn); }

Isometry3d placement(const Assembly& a, const Body& body, const Pose& pose) {
    const double sign = sign_of(body.side);
    const SidePose& side = pose.of(body.side);
    const Vector3d carried(0.0, -a.capstan_radius_mm * side.turn, 0.0);
    switch (body.motion) {
        case Motion::kFixed:
            return body.rest;
        case Motion::kCapstan:
            return body.cam ? body.rest * turned(sign * a.drive.k_pe->cam.rotation_sign * side.turn) : body.rest * turned(sign * side.turn);
        case Motion::kCarriage:
            return shifted(carried) * body.rest;
        case Motion::kSpool:
            return shifted(carried) * body.rest * turned(sign * a.drive.k_se->cam.rotation_sign * spool_angle(a, side.payout_mm));
        case Motion::kSpringEnd:
            return shifted(-drawn_mm(a, side.turn) * along_k_pe(a, body.side)) * body.rest;
        case Motion::kJoint:
            return turned(joint_angle(a, pose)) * body.rest;
    }
    return body.rest;
}

solid::Mesh placed_mesh(const Assembly& a, const Body& body, const Pose& pose) { return moved(body.mesh(), placement(a, body, pose)); }

std::vector<FreeCable> free_cables(const Assembly& a, const Pose& pose) {
    std::vector<FreeCable> all;
    for (const Side side : {Side::kAgonist, Side::kAntagonist}) {
        const SidePose& at = pose.of(side);
        const std::string of = std::string("_") + to_string(side);
        const Vector3d carried(0.0, -a.capstan_radius_mm * at.turn, 0.0);
        const Vector3d k_se_guide = on_side(a.k_se_guide_mm, side, a.plane_mm) + carried,
                       k_pe_guide = on_side(a.k_pe_guide_mm, side, a.plane_mm);
        const Vector3d line = on_side({a.joint_radius_mm, 0.0, a.plane_mm}, side, a.plane_mm);
        const double rear = a.spool_axis_mm.y() + carried.y() - a.carriage_rear_mm;
        all.push_back({CableKind::kDrive, side, {line.x(), -a.motor_distance_mm, line.z()}, {line.x(), rear, line.z()}});
        all.push_back({CableKind::kSeries, side, contact_mm(a, *a.find("k_se" + of), a.drive.k_se->cam, spool_angle(a, at.payout_mm), pose),
                       k_se_guide});
        all.push_back({CableKind::kSeries, side, k_se_guide, line});
        all.push_back({CableKind::kParallel, side, contact_mm(a, *a.find("k_pe" + of), a.drive.k_pe->cam, at.turn, pose), k_pe_guide});
    }
    return all;
}

}  // namespace fusee::assembly
