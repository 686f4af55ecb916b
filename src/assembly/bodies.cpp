#include <cmath>

#include "fusee/solid/part.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

using Eigen::Vector3d;

Eigen::Isometry3d at(const Vector3d& point) { return Eigen::Isometry3d(Eigen::Translation3d(point)); }

/// About its own axis by `angle` [rad].
void turn(Extrusion& shape, double angle) { shape.frame = shape.frame * Eigen::AngleAxisd(angle, Vector3d::UnitZ()); }

/// Radius that K_PE's spring needs on its seat.
double seat_spring_mm(const Drive& drive) {
    const double outer = outer_mm(drive.k_pe_spring);
    return outer > 0.0 ? outer : 6.0;
}

/// The hole of a cable's end through a flange, over the groove's floor: the knot lies outside. @param angle in the shape's frame [rad]
RoundHole anchor(const Layout& l, double radius_mm, double angle) {
    return {radius_mm * std::cos(angle), radius_mm * std::sin(angle), kAnchorHole * l.cable};
}

/// The capstan: floor and two flanges. Its bore is K_PE's, with keyway or flat. The cable leaves it at 180 deg and is wound
/// counter-clockwise; its end is in the flange on the motor's side, away from K_PE.
std::vector<Extrusion> capstan_drum(const Layout& l, const solid::HubOptions& hub, double lock_angle) {
    const double radius = l.capstan, flange = flange_mm(radius, l.cable);
    std::vector<Extrusion> shapes{round(radius - 0.5 * l.cable, -l.drum, l.drum), round(flange, -l.drum - kFlange_mm, -l.drum),
                                  round(flange, l.drum, l.drum + kFlange_mm)};
    for (Extrusion& shape : shapes) turn(shape, lock_angle), shape.bores.push_back(drum_bore(hub, radius - 0.5 * l.cable));
    shapes[2].holes.push_back(anchor(l, radius, core::kPi + kDeadWrap - lock_angle));
    if (const auto stops = capstan_stops(l, hub)) {
        const double at = stops->pin - lock_angle;
        for (const std::size_t i : {0U, 1U})
            shapes[i].holes.push_back({stops->circle_mm * std::cos(at), stops->circle_mm * std::sin(at), kStop_mm});
    }
    return shapes;
}

}  // namespace

Body shaped(std::string name, Motion motion, const Eigen::Isometry3d& rest, std::vector<Extrusion> shapes) {
    Body body{std::move(name), Side::kAgonist, motion, rest, std::move(shapes), nullptr, {}};
    for (const Extrusion& shape : body.shapes) body.prisms.push_back(prism_of(shape, Eigen::Isometry3d::Identity()));
    return body;
}

Body to_make(std::string name, Motion motion, const Eigen::Isometry3d& rest, std::vector<Extrusion> shapes) {
    Body body = shaped(std::move(name), motion, rest, std::move(shapes));
    body.made = true;
    return body;
}

std::vector<Extrusion> shaft_with_flat(const solid::HubOptions& hub, double lock_angle, double low, double high, double flat_low,
                                       double flat_high) {
    const double radius = 0.5 * core::mm_from_m(hub.bore_diameter);
    if (on_shaft(hub).lock != solid::HubLock::kDFlat) return {round(radius, low, high)};
    std::vector<Extrusion> shapes;
    const auto add = [&](double from, double to, solid::Outline outline) {
        if (from >= to) return;
        shapes.push_back(round(radius, from, to));
        shapes.back().outline = std::move(outline);
        turn(shapes.back(), lock_angle);
    };
    add(low, flat_low, solid::circle(radius));
    add(flat_low, flat_high, solid::flat_shaft_outline(on_shaft(hub)));
    add(flat_high, high, solid::circle(radius));
    return shapes;
}

Extrusion block(const Vector3d& low, const Vector3d& high, std::vector<RoundHole> holes) {
    const Vector3d middle = 0.5 * (low + high), half = 0.5 * (high - low);
    Extrusion shape;
    shape.frame.translation() = Vector3d(middle.x(), low.y(), middle.z());
    shape.frame.linear().col(0) = Vector3d::UnitZ(), shape.frame.linear().col(1) = Vector3d::UnitX(),
    shape.frame.linear().col(2) = Vector3d::UnitY();
    shape.half_x_mm = half.z(), shape.half_y_mm = half.x(), shape.length_mm = 2.0 * half.y();
    for (const RoundHole& hole : holes) shape.holes.push_back({hole.y_mm - middle.z(), hole.x_mm - middle.x(), hole.radius_mm});
    return shape;
}

double seat_screw_mm(const Drive& drive) { return std::sqrt(0.5) * (seat_spring_mm(drive) + kScrewHead_mm + kSeatSpace_mm); }
double seat_half_mm(const Drive& drive) { return std::max(seat_spring_mm(drive) + 2.0, seat_screw_mm(drive) + kScrewHead_mm); }

namespace {

/// Direction of a part's keyway or flat in the plane [rad].
double lock_angle(const Eigen::Isometry3d& part) { return std::atan2(part.linear()(1, 0), part.linear()(0, 0)); }

Body cam_body(std::string name, Motion motion, const Eigen::Isometry3d& rest, const solid::Part& part) {
    constexpr int kLayersOfHelix = 12;
    const solid::Box box = solid::bounding_box(part.mesh);
    std::vector<double> levels{box.low_mm[2], core::mm_from_m(part.z_low), core::mm_from_m(part.z_high), box.high_mm[2]};
    if (!part.cam.closed())
        for (int i = 1; i < kLayersOfHelix; ++i)
            levels.push_back(box.low_mm[2] + (box.high_mm[2] - box.low_mm[2]) * i / static_cast<double>(kLayersOfHelix));
    std::sort(levels.begin(), levels.end());
    const auto near = [](double a, double b) { return b - a < 1e-3; };
    levels.erase(std::unique(levels.begin(), levels.end(), near), levels.end());
    return {std::move(name), Side::kAgonist, motion, rest, {}, std::make_shared<solid::Mesh>(part.mesh), layers_of(part.mesh, levels)};
}

double bore_radius_mm(const solid::Part& part) { return 0.5 * core::mm_from_m(part.options.hub.bore_diameter); }

/// A post for the spring's leg, with a slot from its top. An arm from the column of an overhung spool, from which the spring's arbor hangs:
/// its axle ends below.
void add_leg_post(const Layout& l, const Drive& drive, std::vector<Extrusion>& shapes) {
    const LegSlot& slot = l.leg_slot;
    const double half = 0.5 * slot.width_mm, side = half + kProng_mm, near = l.leg_post - kLegPost_mm, far = l.leg_post + kLegPost_mm;
    std::vector<Extrusion> along = leg_posts(l, drive);
    if (slot.width_mm > 0.0)
        for (const auto& [from, to] : {std::pair(-side, -half), std::pair(half, side)})
            along.push_back(box({near, from, slot.floor_mm}, {far, to, slot.top_mm}));
    if (has_bridge(drive)) {
        const double radius = 0.5 * arbor_mm(drive), foot = l.leg_slot.top_mm + l.gap;
        const double column = leg_end_mm(l.leg_post, drive.k_se_spring) + l.gap;
        along.push_back(box({-radius - 1.0, -radius - 1.0, foot}, {column + l.wall, radius + 1.0, foot + l.wall}));
        along.push_back(round(radius, l.spool_high + l.gap, foot));
    }
    for (Extrusion& shape : along) turn_about_axis(shape, l.leg_post_angle), shapes.push_back(std::move(shape));
}

/// Of the carriage's front wall before K_SE's axis.
double front_mm(const Layout& l) { return l.guide_distance + (l.idler > 0.0 ? l.idler + l.gap : 0.0); }

/// Rear ends of the middle lines of the four bushes: x and y about K_SE's axis.
std::vector<Eigen::Vector2d> bush_places(const Layout& l) {
    const double side = rod_aside_mm(l);
    std::vector<Eigen::Vector2d> all;
    for (const double x : {-side, side})
        for (const double y : {-l.carriage_rear, front_mm(l) + l.wall - kBushLength_mm}) all.emplace_back(x, y);
    return all;
}

/// Base plate, wall with the cable's hole, wall that the drive cable pulls, post for the spring's leg, and four housings of bushes below.
Body carriage(const Layout& l, const Drive& drive) {
    const double half = l.carriage_half, shift = l.line - l.spool_axis.x(), wall_high = wall_height_mm(l.cable);
    const double front = front_mm(l), rear = -l.carriage_rear;
    const double low = l.base_high - l.wall, hole = 0.75 * l.cable;
    std::vector<Extrusion> shapes{
        box({-half, rear, low}, {half, front + l.wall, l.base_high}, {{0.0, 0.0, 0.5 * sleeve_mm(2.0 * bore_radius_mm(*drive.k_se))}})};
    for (const double y : {front, rear})
        shapes.push_back(block({-half, y, l.base_high}, {half, y + l.wall, wall_high}, {{shift, 0.0, hole}}));
    add_leg_post(l, drive, shapes);
    for (const Eigen::Vector2d& at : bush_places(l))
        shapes.push_back(block({at.x() - kHousing_mm, at.y(), l.carriage_low}, {at.x() + kHousing_mm, at.y() + kBushLength_mm, low},
                               {{at.x(), rod_height_mm(l), kBush_mm}}));
    if (l.idler > 0.0)
        shapes.push_back(rod({0.0, l.guide_distance, l.base_high}, Vector3d::UnitZ(), l.idler - 0.5 * l.cable, wall_high - l.base_high));
    return to_make("carriage", Motion::kCarriage, at(l.spool_axis), std::move(shapes));
}

Body bushes(const Layout& l) {
    std::vector<Extrusion> shapes;
    for (const Eigen::Vector2d& at : bush_places(l))
        shapes.push_back(rod({at.x(), at.y(), rod_height_mm(l)}, Vector3d::UnitY(), kBush_mm, kBushLength_mm, kRod_mm));
    return shaped("bushes", Motion::kCarriage, at(l.spool_axis), std::move(shapes));
}

/// Each in three pieces: both ends have the core hole of a thread.
Body rods(const Layout& l) {
    Body body = shaped("rods", Motion::kFixed, Eigen::Isometry3d::Identity(), {});
    for (const double side : {-1.0, 1.0}) {
        const auto piece = [&](double from, double to, double core) {
            return rod({l.spool_axis.x() + side * rod_aside_mm(l), from, rod_height_mm(l)}, Vector3d::UnitY(), kRod_mm, to - from, core);
        };
        const double low = l.bottom + kRodThread_mm, high = l.top - kRodThread_mm;
        for (Extrusion& shape : std::array{piece(l.bottom, low, kCoreHole_mm), piece(low, high, 0.0), piece(high, l.top, kCoreHole_mm)})
            body.shapes.push_back(std::move(shape));
        body.prisms.push_back(prism_of(piece(l.bottom, l.top, 0.0), Eigen::Isometry3d::Identity()));
    }
    return body;
}

/// The hub of the axle where it is turned down to the spring's arbor: what is left there of a flat.
solid::HubOptions turned_down(const solid::HubOptions& hub, double arbor_mm) {
    solid::HubOptions neck = hub;
    neck.bore_diameter = core::m_from_mm(arbor_mm);
    neck.flat_depth = hub.flat_depth - 0.5 * (hub.bore_diameter - neck.bore_diameter);
    if (neck.flat_depth <= 0.0) neck.lock = solid::HubLock::kPlain;
    return neck;
}

/// A flat reaches from the spool to the upper end, over which the spool is put on; in the sleeve the axle is round. Inside a spring with a
/// thinner arbor the axle is turned down.
std::vector<Extrusion> axle_shapes(const Layout& l, const Drive& drive, double low) {
    const solid::HubOptions& hub = drive.k_se->options.hub;
    const bool thinner = has_through_axle(*drive.k_se) && arbor_mm(drive) < core::mm_from_m(hub.bore_diameter);
    const double end = thinner ? l.spool_high : l.axle_end, lock = lock_angle(l.k_se);
    std::vector<Extrusion> shapes = shaft_with_flat(hub, lock, low, end, l.spool_low - 0.5 * l.gap, end);
    if (thinner)
        for (const Extrusion& neck : shaft_with_flat(turned_down(hub, arbor_mm(drive)), lock, end, l.axle_end, end, l.axle_end))
            shapes.push_back(neck);
    return shapes;
}

/// The axle of a spool, the sleeve in which it turns, the rings that hold it and the spool along the axis, washers under the spool, and a
/// sleeve inside a wider spring. The axle of an overhung spool ends in it, and has one ring.
void add_axle(const Layout& l, const Drive& drive, std::vector<Body>& to) {
    const double radius = 0.5 * core::mm_from_m(drive.k_se->options.hub.bore_diameter), arbor = 0.5 * arbor_mm(drive);
    const double low = l.base_high - l.wall, above = l.axle_end - kAxleEnd_mm, neck = std::min(radius, arbor);
    const bool through = has_through_axle(*drive.k_se);
    to.push_back(shaped("axle", Motion::kSpool, at(l.spool_axis), axle_shapes(l, drive, low - kAxleEnd_mm)));
    to.push_back(
        shaped("axle_sleeve", Motion::kCarriage, at(l.spool_axis), {round(0.5 * sleeve_mm(2.0 * radius), low, l.base_high, radius)}));
    std::vector<Extrusion> rings{round(radius + kRingHeight_mm, low - ring_mm(2.0 * radius), low, radius)};
    rings.push_back(round(0.5 * washer_mm(2.0 * radius), l.base_high, l.spool_low, radius));
    if (through) rings.push_back(round(neck + kRingHeight_mm, above, above + ring_mm(2.0 * neck), neck));
    to.push_back(shaped("axle_rings", Motion::kSpool, at(l.spool_axis), std::move(rings)));
    if (through && arbor > radius)
        to.push_back(shaped("spring_arbor", Motion::kSpool, at(l.spool_axis), {round(arbor, l.spool_high, above, radius)}));
}

/// The collar that holds the capstan on the motor's side of its shaft; K_PE is on the other side.
Body shaft_collar(const Layout& l, double radius) {
    const Collar collar = collar_of(2.0 * radius);
    const double face = l.drum + kFlange_mm;
    return shaped("shaft_collar", Motion::kCapstan, at(l.motor_axis),
                  {round(0.5 * collar.outside_mm, face, face + collar.width_mm, radius)});
}

/// The plate that the spring of K_PE stands on, with the hole of its cable at its near face, and holes for two screws in opposite corners,
/// whose heads clear the spring.
Body seat(const Layout& l, const Drive& drive) {
    Extrusion plate = rod(l.k_pe_guide, l.k_pe_along, 0.0, l.wall, 0.75 * l.cable);
    const double corner = seat_screw_mm(drive);
    plate.half_x_mm = plate.half_y_mm = seat_half_mm(drive);
    for (const double side : {-1.0, 1.0}) plate.holes.push_back({side * corner, side * corner, kScrewHole_mm});
    return to_make("k_pe_seat", Motion::kFixed, Eigen::Isometry3d::Identity(), {plate});
}

/// The torsion spring's legs: a radial one at its upper end, for the carriage's post; one along the axis at the coils' mean radius, which
/// turns in the slot of the spool.
void add_legs(const Layout& l, const Drive& drive, std::vector<Body>& to) {
    const spring::BaseSpring& s = drive.k_se_spring;
    const double wire = 0.5 * core::mm_from_m(s.wire_diameter), height = l.spring_low + l.spring_length - wire;
    Extrusion radial = rod({outer_mm(s), 0.0, height}, Vector3d::UnitX(), wire, leg_end_mm(l.leg_post, s) - outer_mm(s));
    turn_about_axis(radial, l.leg_post_angle);
    to.push_back(shaped("leg_in_carriage", Motion::kCarriage, at(l.spool_axis), {std::move(radial)}));
    const solid::FeatureOptions& slot = drive.k_se->options.features;
    if (slot.leg_slot_width <= 0.0) return;
    const double angle = lock_angle(l.k_se) + slot.leg_slot_angle, radius = 0.5 * core::mm_from_m(s.coil_diameter);
    const double low = l.spool_high - core::mm_from_m(slot.leg_slot_depth);
    to.push_back(shaped("leg_in_k_se", Motion::kSpool, at(l.spool_axis),
                        {rod({radius * std::cos(angle), radius * std::sin(angle), low}, Vector3d::UnitZ(), wire, l.spring_low - low)}));
}

void add_springs(const Layout& l, const Drive& drive, std::vector<Body>& to) {
    const spring::BaseSpring &torsion = drive.k_se_spring, &pressed = drive.k_pe_spring;
    if (outer_mm(torsion) > 0.0 && torsion.active_coils > 0.0) {
        const double low = l.spring_low;
        to.push_back(shaped("k_se_spring", Motion::kCarriage, at(l.spool_axis),
                            {round(outer_mm(torsion), low, low + l.spring_length, inner_mm(torsion))}));
        add_legs(l, drive, to);
    }
    const double outer = outer_mm(pressed);
    to.push_back(seat(l, drive));
    if (outer <= 0.0 || l.k_pe_spring_length <= 0.0) return;
    const Vector3d foot = l.k_pe_guide + l.wall * l.k_pe_along, end = foot + l.k_pe_spring_length * l.k_pe_along;
    to.push_back(shaped("k_pe_spring", Motion::kFixed, Eigen::Isometry3d::Identity(),
                        {rod(foot, l.k_pe_along, outer, l.k_pe_spring_length, inner_mm(pressed))}));
    to.push_back(to_make("k_pe_cap", Motion::kSpringEnd, at(end), {rod(Vector3d::Zero(), l.k_pe_along, outer, kCap_mm, 0.75 * l.cable)}));
}

}  // namespace

std::vector<Body> side_bodies(const Layout& l, const Drive& drive) {
    const double shaft = bore_radius_mm(*drive.k_pe), lock = lock_angle(l.k_pe), drum_half = l.drum + kFlange_mm;
    const solid::HubOptions& hub = drive.k_pe->options.hub;
    std::vector<Body> all;
    all.push_back(to_make("capstan", Motion::kCapstan, at(l.motor_axis), capstan_drum(l, hub, lock)));
    all.push_back(shaped("motor_shaft", Motion::kCapstan, at(l.motor_axis),
                         shaft_with_flat(hub, lock, l.shaft_low, l.shaft_high, l.shaft_low, drum_half)));  // the flat: K_PE and the capstan
    add_capstan_stops(l, hub, all);
    all.push_back(shaft_collar(l, shaft));
    all.push_back(cam_body("k_pe", Motion::kCapstan, l.k_pe, *drive.k_pe));
    all.push_back(carriage(l, drive));
    all.push_back(bushes(l));
    all.push_back(rods(l));
    all.push_back(cam_body("k_se", Motion::kSpool, l.k_se, *drive.k_se));
    add_axle(l, drive, all);
    add_springs(l, drive, all);
    return all;
}

namespace {

/// Room for the knot of a cable beside the pulley.
double knot_mm(const Layout& l) { return 2.0 * l.cable; }
double floor_mm(const Layout& l) { return l.joint - 0.5 * l.cable; }
/// Is there room for the hole of the stop pin between bore and floor?
bool has_pressed_pin(const Layout& l) { return floor_mm(l) - l.joint_bore >= 2.0 * (kStop_mm + kStopWall_mm); }
double stop_radius_mm(const Layout& l) {
    return (has_pressed_pin(l) ? floor_mm(l) : flange_mm(l.joint, l.cable)) - kStop_mm - kStopWall_mm;
}
Eigen::Vector2d stop_place(const Layout& l, double angle) { return stop_radius_mm(l) * Eigen::Vector2d(std::cos(angle), std::sin(angle)); }

constexpr double kPinAngle = -0.5 * core::kPi;  // of the pulley's pin in the joint's middle

/// A pin from one height beside the pulley to a farther one: above it with a frame, else below.
Extrusion stop(const Layout& l, const Eigen::Vector2d& place, double from, double to) {
    return rod({place.x(), place.y(), l.frame ? from : -to}, Vector3d::UnitZ(), kStop_mm, to - from);
}

}  // namespace

Body joint_pulley(const Layout& l, const solid::HubOptions& hub, double joint_range) {
    const double floor = floor_mm(l), flange = flange_mm(l.joint, l.cable), inner = l.plane - l.drum, outer = l.plane + l.drum,
                 end = kDeadWrap + 0.5 * joint_range;
    std::vector<Extrusion> discs{round(flange, -outer - kFlange_mm, -outer), round(floor, -outer, -inner), round(flange, -inner, inner),
                                 round(floor, inner, outer), round(flange, outer, outer + kFlange_mm)};
    const LinkHoles link = link_holes(hub, floor);
    for (Extrusion& disc : discs) {
        disc.bores.push_back(drum_bore(hub, floor));
        for (int i = 0; i < link.count; ++i) {
            const double angle = (0.25 + 0.5 * i) * core::kPi;
            disc.holes.push_back({link.circle_mm * std::cos(angle), link.circle_mm * std::sin(angle), kScrewHole_mm});
        }
    }
    const Eigen::Vector2d pin = stop_place(l, kPinAngle);
    if (has_pressed_pin(l))
        for (const std::size_t i : l.frame ? std::array{3U, 4U} : std::array{0U, 1U})
            discs[i].holes.push_back({pin.x(), pin.y(), kStop_mm});
    discs.back().holes.push_back(anchor(l, l.joint, end)), discs.front().holes.push_back(anchor(l, l.joint, core::kPi - end));
    if (!has_pressed_pin(l)) discs.push_back(stop(l, pin, outer + kFlange_mm, stop_foot_mm(l) - l.gap));
    Body body = to_make("joint_pulley", Motion::kJoint, Eigen::Isometry3d::Identity(), std::move(discs));
    body.side = Side::kBoth;
    return body;
}

std::optional<Body> stop_pin(const Layout& l) {
    if (!has_pressed_pin(l)) return std::nullopt;
    const double foot = l.plane - l.drum, length = pin_length_mm(stop_foot_mm(l) - l.gap - foot);
    Body body = shaped("stop_pin", Motion::kJoint, Eigen::Isometry3d::Identity(), {stop(l, stop_place(l, kPinAngle), foot, foot + length)});
    body.side = Side::kBoth;
    return body;
}

double stop_foot_mm(const Layout& l) { return l.plane + l.drum + kFlange_mm + l.gap + knot_mm(l) + kStopOverlap_mm; }

std::vector<Eigen::Vector2d> stop_places(const Layout& l, double joint_range) {
    std::vector<Eigen::Vector2d> all;
    for (const double angle : post_angles(stop_radius_mm(l), joint_range)) all.push_back(stop_place(l, kPinAngle + angle));
    return all;
}

Body joint_stops(const Layout& l, double joint_range) {
    const double foot = stop_foot_mm(l), end = foot + (l.frame ? kStopOverlap_mm : 0.0);
    std::vector<Extrusion> posts;
    for (const Eigen::Vector2d& place : stop_places(l, joint_range)) posts.push_back(stop(l, place, foot - kStopOverlap_mm, end));
    Body body = shaped("joint_stops", Motion::kFixed, Eigen::Isometry3d::Identity(), std::move(posts));
    body.side = Side::kBoth;
    return body;
}

Body mirrored(const Body& body) {
    const Eigen::DiagonalMatrix<double, 3> in_x(-1.0, 1.0, 1.0), in_y(1.0, -1.0, 1.0);
    Body image = body;
    image.side = Side::kAntagonist;
    image.rest.translation() = in_x * body.rest.translation();
    image.shapes.clear();
    if (body.cam) {  // the antagonist's part is the mirror image y -> -y of the agonist's
        image.rest.linear() = in_x * body.rest.linear() * in_y;
        image.cam = std::make_shared<solid::Mesh>(solid::mirrored(*body.cam));
    } else {
        image.rest.linear() = in_x * body.rest.linear() * in_x;
        for (const Extrusion& shape : body.shapes) image.shapes.push_back(mirrored(shape));
    }
    for (Prism& prism : image.prisms) {
        for (solid::Point2& p : prism.outline_mm) p[body.cam ? 1 : 0] *= -1.0;
        std::reverse(prism.outline_mm.begin(), prism.outline_mm.end());
    }
    return image;
}

}  // namespace fusee::assembly
