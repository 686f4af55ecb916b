#include "layout.h"

#include <cmath>
#include <numbers>

#include "fusee/spring/coil.h"

namespace fusee::assembly {

namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

double reach_mm(const solid::Mesh& mesh) {
    double reach = 0.0;
    for (const solid::Vec3& p : mesh.points_mm) reach = std::max(reach, std::hypot(p[0], p[1]));
    return reach;
}

Vector3d direction(double angle) { return {std::cos(angle), std::sin(angle), 0.0}; }

/// Where the cable leaves the guide, to the right of the line from the cam's axis through the guide's centre.
double offset_mm(const cam::Guide& guide) {
    return guide.kind == cam::GuideKind::kIdler ? guide.sense * core::mm_from_m(guide.radius) : 0.0;
}

/// The spring stands on the spool. Its upper leg rises as it is wound: the slot holds it from the least to the largest state.
void place_leg_slot(Layout& l, const solid::Part& part, const spring::BaseSpring& s) {
    l.leg_post = l.spool_reach + l.gap + kLegPost_mm;
    l.spring_low = l.spool_high + 0.5 * l.gap;
    l.spring_length = wound_length_mm(s, most_wound(s, part));
    l.leg_slot.top_mm = l.spool_high + 4.0;
    if (outer_mm(s) <= 0.0 || l.spring_length <= 0.0) return;
    const double wire = core::mm_from_m(s.wire_diameter);
    l.leg_slot = {wire + kLegPlay_mm, l.spring_low + wound_length_mm(s, s.preload) - wire - 0.5 * l.gap,
                  l.spring_low + l.spring_length + 0.5 * wire, l.leg_post - kLegPost_mm, l.leg_post + kLegPost_mm};
}

void place_k_se(Layout& l, const Drive& drive) {
    const solid::Part& part = *drive.k_se;
    const spring::BaseSpring& spring = drive.k_se_spring;
    const cam::Guide& guide = part.cam.options.guide;
    const solid::Box box = solid::bounding_box(part.mesh);
    const double height = core::mm_from_m(guide.z);
    l.spool_reach = reach_mm(part.mesh);
    l.spool_low = box.low_mm[2] - height, l.spool_high = box.high_mm[2] - height;
    place_leg_slot(l, part, spring);
    l.guide_distance = core::mm_from_m(guide.distance);
    l.idler = guide.kind == cam::GuideKind::kIdler ? core::mm_from_m(guide.radius) : 0.0;
    l.base_high = l.spool_low - l.gap;
    const double beside = l.frame && l.idler > 0.0 ? 2.0 * l.gap : l.gap;  // an idler brings the wall a gap forward
    l.spool_axis = Vector3d(l.line - offset_mm(guide), l.front - l.wall - beside - l.guide_distance - l.idler, 0.0);
    l.k_se_guide = Vector3d(l.line, l.spool_axis.y() + l.guide_distance, 0.0);
    l.k_se = Eigen::Translation3d(l.spool_axis - Vector3d(0.0, 0.0, height)) *
             AngleAxisd(0.5 * std::numbers::pi - guide.direction, Vector3d::UnitZ());
    l.leg_post_angle = post_angle(l, drive);
    const double ring_reach = 0.5 * core::mm_from_m(part.options.hub.bore_diameter) + kRingHeight_mm;
    l.carriage_high = std::max({wall_height_mm(l.cable), l.spool_high + std::max(4.0, 1.5 * l.gap + l.spring_length) + kAxleEnd_mm,
                                l.leg_slot.top_mm + (has_bridge(drive) ? l.gap + l.wall : 0.0)});
    const double column = has_bridge(drive) ? leg_end_mm(l.leg_post, spring) + l.gap + l.wall : 0.0;
    l.carriage_half =
        std::max({l.spool_reach + l.gap + l.wall + 2.0, ring_reach + l.gap + 2.0 * kHousing_mm, column});  // a ring between the housings
    l.axle_end =
        has_through_axle(part) ? l.carriage_high : core::mm_from_m(part.z_low + part.options.groove.rib - part.options.hub.web) - height;
    l.carriage_rear = std::max(l.spool_reach + l.gap, post_rear_mm(l, drive)) + l.wall;
    l.carriage_low = l.base_high - l.wall - 2.0 * kHousing_mm;
}

/// Below the capstan and the carriage. K_PE has to turn in the capstan's sense: otherwise it is turned over about its cable. The boss of an
/// overhung one is towards the capstan, and the shaft ends in it. @pre an overhung one is turned over
void place_k_pe(Layout& l, const solid::Part& part, double towards) {
    const cam::Guide& guide = part.cam.options.guide;
    const bool over = part.cam.rotation_sign < 0, overhung = part.options.hub.kind == solid::HubKind::kOverhung;
    const solid::Box box = solid::bounding_box(part.mesh);
    const double low = over ? -box.high_mm[2] : box.low_mm[2], high = over ? -box.low_mm[2] : box.high_mm[2];
    const double drum = l.drum + kFlange_mm, shaft = core::mm_from_m(part.options.hub.bore_diameter);
    const double width = bearing_width_mm(shaft), bearing = l.frame ? width + l.gap : 0.0;
    const double washers = l.frame ? rod_height_mm(l) - kRodWasher_mm - 0.5 * l.gap - width : INFINITY;  // the arm stays below them
    const double lift = std::min({-drum - bearing, l.carriage_low, washers}) - l.gap - high;
    l.arm_low = lift + high + l.gap;
    const double bore_end = core::mm_from_m(part.z_low + part.options.groove.rib - part.options.hub.web);  // of a blind bore
    l.shaft_low = overhung ? lift - bore_end : low + lift - kShaftEnd_mm, l.shaft_high = drum + kMotor_mm;
    const Isometry3d turn_over = over ? Isometry3d(AngleAxisd(std::numbers::pi, direction(guide.direction))) : Isometry3d::Identity();
    l.k_pe = Eigen::Translation3d(l.motor_axis + Vector3d(0.0, 0.0, lift)) * AngleAxisd(towards - guide.direction, Vector3d::UnitZ()) *
             turn_over;
    l.k_pe_along = direction(towards);
    const Vector3d right(l.k_pe_along.y(), -l.k_pe_along.x(), 0.0);
    const double height = lift + (over ? -1.0 : 1.0) * core::mm_from_m(guide.z);
    l.k_pe_guide = l.motor_axis + Vector3d(0.0, 0.0, height) + core::mm_from_m(guide.distance) * l.k_pe_along +
                   (over ? -1.0 : 1.0) * offset_mm(guide) * right;
}

/// The plate clears what is highest on either side, and has room below it for the threads of its brackets and for the joint's tower.
void place_plate(Layout& l, const Drive& drive, double shaft) {
    const double collar = l.drum + kFlange_mm + collar_of(shaft).width_mm, seat = l.k_pe_guide.z() + seat_half_mm(drive);
    double k_pe = -INFINITY;
    for (const solid::Vec3& p : drive.k_pe->mesh.points_mm) k_pe = std::max(k_pe, (l.k_pe * Vector3d(p[0], p[1], p[2])).z());
    const double cables = kThread_mm + 3.0 * l.cable,
                 tower = stop_foot_mm(l) - l.plane + kStopOverlap_mm + bearing_width_mm(shaft) + kThread_mm;
    l.plate = std::max({l.carriage_high + l.gap, collar + l.gap, seat + l.gap, k_pe + l.gap, cables, tower});
    l.shaft_high = l.plate + frame_plate_mm(l, shaft) + kMotor_mm;
    double reach = flange_mm(l.capstan, l.cable);
    reach = std::max(reach, reach_mm(drive.k_pe->mesh));
    const bool towards_motors = l.k_pe_along.y() < -1.0 + 1e-9;  // away from the carriages, where a post has a way up to the plate
    l.posts = towards_motors && l.k_pe_guide.y() + kPost_mm + l.gap <= l.motor_axis.y() - reach;
}

}  // namespace

bool drum_has_lock(const solid::HubOptions& hub, double floor_mm) {
    constexpr double kLeast_mm = 1.0;  // wall over a keyway (practice)
    return hub.lock != solid::HubLock::kPlain && solid::bore_reach_mm(hub) + kLeast_mm <= floor_mm;
}
solid::Outline drum_bore(const solid::HubOptions& hub, double floor_mm) {
    return drum_has_lock(hub, floor_mm) ? solid::bore_outline(on_shaft(hub)) : solid::circle(0.5 * core::mm_from_m(hub.bore_diameter));
}

LinkHoles link_holes(const solid::HubOptions& hub, double floor_mm) {
    constexpr double kLeast_mm = 2.0;  // beside the hole (practice)
    const double bore = solid::bore_reach_mm(hub);
    if (0.5 * (floor_mm - bore) < kScrewHole_mm + kLeast_mm) return {};
    return {4, 0.5 * (floor_mm + bore)};
}

double outer_mm(const spring::BaseSpring& s) {
    return spring::coil_known(s) ? 0.5 * core::mm_from_m(s.coil_diameter + s.wire_diameter) : 0.0;
}
double inner_mm(const spring::BaseSpring& s) {
    return spring::coil_known(s) ? 0.5 * core::mm_from_m(s.coil_diameter - s.wire_diameter) : 0.0;
}

double wound_length_mm(const spring::BaseSpring& s, double state) {
    if (s.wire_diameter <= 0.0 || s.active_coils <= 0.0) return 0.0;
    return core::mm_from_m(spring::wound_length(s, state));
}
double most_wound(const spring::BaseSpring& s, const solid::Part& spool) { return s.preload + spool.cam.working.back().arm.travel; }

bool has_through_axle(const solid::Part& spool) { return spool.options.hub.kind == solid::HubKind::kThrough; }
double arbor_mm(const Drive& drive) {
    const double rod = core::mm_from_m(drive.k_se_spring.rod_diameter);
    return rod > 0.0 || !has_through_axle(*drive.k_se) ? rod : core::mm_from_m(drive.k_se->options.hub.bore_diameter);
}
bool has_bridge(const Drive& drive) {
    const spring::BaseSpring& s = drive.k_se_spring;
    return !has_through_axle(*drive.k_se) && arbor_mm(drive) > 0.0 && outer_mm(s) > 0.0 && s.active_coils > 0.0;
}
double leg_end_mm(double leg_post_mm, const spring::BaseSpring& s) { return leg_post_mm + kLegPost_mm + core::mm_from_m(s.wire_diameter); }

Layout lay_out(const Drive& drive, double capstan_radius, double joint_radius, const AssemblyOptions& options, double greatest_turn) {
    Layout l;
    l.cable = core::mm_from_m(drive.k_se->cam.options.cable_diameter);
    l.gap = core::mm_from_m(options.gap), l.wall = core::mm_from_m(options.wall);
    l.capstan = core::mm_from_m(capstan_radius), l.joint = core::mm_from_m(joint_radius);
    l.joint_bore = solid::bore_reach_mm(drive.k_pe->options.hub);
    l.drum = 2.0 * l.cable;
    l.line = l.joint, l.turn = greatest_turn, l.spare = 0.5 * l.gap / l.capstan;
    l.frame = options.frame;
    const double shaft = core::mm_from_m(drive.k_pe->options.hub.bore_diameter), block = l.frame ? kBracket_mm : 0.0;
    const double head = l.frame ? kRodScrew_mm : 0.0, tower = l.frame ? tower_mm(l, shaft) : 0.0;
    l.top = -std::max(flange_mm(l.joint, l.cable) + head, tower) - l.gap;
    l.front = l.top - block;
    place_k_se(l, drive);
    l.side_by_side = l.line - offset_mm(drive.k_se->cam.options.guide) >= l.carriage_half + 0.5 * l.gap;
    l.plane = l.drum + 0.5 * kFlange_mm;
    if (!l.side_by_side) l.plane = std::max(l.plane, 0.5 * (l.carriage_high - l.carriage_low + l.gap));  // one above the other
    const double lowest = l.spool_axis.y() - l.carriage_rear - l.capstan * greatest_turn - (l.frame ? l.gap : 0.0);
    const double arm = l.frame ? 0.5 * bearing_seat_mm(shaft) + kBearingWall_mm : 0.0;
    const double k_pe = l.frame && !l.side_by_side ? reach_mm(drive.k_pe->mesh) : 0.0;          // the bracket reaches down past one of them
    const double beyond = l.gap + std::max({flange_mm(l.capstan, l.cable) + head, arm, k_pe});  // from motor to rods
    const double least = beyond + block - lowest;
    l.motor_axis = Vector3d(l.line + l.capstan, -(options.motor_distance > 0.0 ? core::mm_from_m(options.motor_distance) : least), 0.0);
    l.bottom = l.motor_axis.y() + beyond;
    l.rear = l.bottom + block;
    place_k_pe(l, *drive.k_pe, options.k_pe_direction);
    const spring::BaseSpring& spring = drive.k_pe_spring;
    l.k_pe_spring_length = core::mm_from_m(spring.free_length - spring.preload);
    if (l.frame) place_plate(l, drive, shaft);
    return l;
}

}  // namespace fusee::assembly
