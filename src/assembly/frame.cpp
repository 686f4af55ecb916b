#include <cmath>

#include "layout.h"

namespace fusee::assembly {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kFoot_mm = 5.0;    // of plate around a screw's middle
constexpr double kMount_mm = 2.25;  // radius of the holes for whatever carries the joint: M4 (ISO 273, medium)

struct Place {
    Vector2d at;
    double radius_mm = 0.0;  ///< 0: a corner
};

/// The places whose circles are on the hull, counter-clockwise: by the convex hull of points of the circles.
std::vector<Place> on_hull(const std::vector<Place>& places) {
    constexpr int kPoints = 360;
    solid::Ring points;
    for (const Place& place : places)
        for (int i = 0; i < kPoints; ++i) {
            const double angle = 2.0 * core::kPi * i / kPoints;
            points.push_back({place.at.x() + place.radius_mm * std::cos(angle), place.at.y() + place.radius_mm * std::sin(angle)});
        }
    std::vector<Place> all;
    const auto owner = [&](const solid::Point2& p) {  // the circle that the point is on
        return *std::min_element(places.begin(), places.end(), [&](const Place& a, const Place& b) {
            const Vector2d at(p.data());
            return std::abs((at - a.at).norm() - a.radius_mm) < std::abs((at - b.at).norm() - b.radius_mm);
        });
    };
    for (const solid::Point2& p : hull_of(points)) {
        const Place place = owner(p);
        if (all.empty() || (all.back().at - place.at).norm() > 1e-6) all.push_back(place);
    }
    if (all.size() > 1 && (all.back().at - all.front().at).norm() < 1e-6) all.pop_back();
    return all;
}

/// The convex hull of circles: arcs, joined by their common tangents.
solid::Outline hull_outline(const std::vector<Place>& places) {
    const std::vector<Place> hull = on_hull(places);
    std::vector<double> normal;  // outward, of the tangent from each circle to the next [rad]
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Place &a = hull[i], &b = hull[(i + 1) % hull.size()];
        const Vector2d along = b.at - a.at;
        normal.push_back(std::atan2(along.y(), along.x()) - std::acos((a.radius_mm - b.radius_mm) / along.norm()));
    }
    solid::Outline outline;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const double begin = normal[(i + hull.size() - 1) % hull.size()];
        const double turn = std::fmod(normal[i] - begin + 4.0 * core::kPi, 2.0 * core::kPi);
        outline.push_back({{hull[i].at.x(), hull[i].at.y()}, hull[i].radius_mm, begin, begin + turn});
    }
    return outline;
}

/// The frame's places and bodies while they are laid out, in the assembly's frame.
struct Builder {
    const Layout& l;
    const Drive& drive;
    std::vector<FrameHole>& holes;
    std::vector<Place> places = {};
    double shaft = core::mm_from_m(drive.k_pe->options.hub.bore_diameter);
    double seat = 0.5 * bearing_seat_mm(shaft), width = bearing_width_mm(shaft);
    double face = l.plane + l.plate;                              ///< lower face of the plate
    double wide = l.spool_axis.x() + l.carriage_half;             ///< half the length of the front bracket
    double motor = seat + kBearingWall_mm;                        ///< radius of the arm around a motor's shaft
    double rear_wide = std::max(wide, l.motor_axis.x() + motor);  ///< of the rear one

    void hole(const Vector2d& at, double radius, double around, const std::string& holds) {
        holes.push_back({at.x(), at.y(), 2.0 * radius, holds});
        places.push_back({at, radius + around});
    }
    /// One for each screw through the plate into a thread of the body.
    RoundHole thread(const Vector2d& at, const std::string& body) {
        hole(at, kScrewHole_mm, kFoot_mm - kScrewHole_mm, "screw of " + body);
        return {at.x(), at.y(), kCoreHole_mm};
    }
    /// The rods of both sides through a bracket, and the cables that pass it on the way along y.
    [[nodiscard]] std::vector<RoundHole> along_y() const {
        std::vector<RoundHole> all;
        for (const double side : {1.0, -1.0}) {
            for (const double rod : {-1.0, 1.0})
                all.push_back({side * (l.spool_axis.x() + rod * rod_aside_mm(l)), side * l.plane + rod_height_mm(l), kRod_mm});
            all.push_back({side * l.line, side * l.plane, kPassHole * l.cable});
        }
        return all;
    }
    /// From the plate down to below the rods of each side, which is lower on the antagonist's.
    std::vector<Extrusion> bracket(const std::string& name, double half, double y) {
        const double low = std::min(l.carriage_low, l.arm_low), neck = face - kThread_mm;
        const Vector3d deep(0.0, kBracket_mm, 0.0);
        std::vector<RoundHole> threads;
        for (const double share : {-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0})
            threads.push_back(thread({share * (half - kFoot_mm), y + 0.5 * kBracket_mm}, name));
        std::vector<Extrusion> shapes{box({-half, y, neck}, {half, y + kBracket_mm, face}, threads)};
        const auto below = [&](double from, double to, double bottom, std::vector<RoundHole> through) {
            shapes.push_back(block({from, y, bottom}, Vector3d(to, y, neck) + deep, std::move(through)));
        };
        const std::vector<RoundHole> all = along_y();
        if (!l.side_by_side) return below(-half, half, low - l.plane, all), shapes;
        below(0.0, half, low + l.plane, {all.begin(), all.begin() + 3});
        below(-half, 0.0, low - l.plane, {all.begin() + 3, all.end()});
        return shapes;
    }
    /// From the rear bracket around a motor's shaft, between K_PE and the capstan; below that, a disc for the capstan's stop posts.
    [[nodiscard]] Extrusion arm(double side) const {
        Extrusion shape;
        shape.frame.translation() = Vector3d(side * l.motor_axis.x(), l.motor_axis.y(), side * l.plane + l.arm_low);
        const auto stops = capstan_stops(l, drive.k_pe->options.hub);
        const double reach = l.bottom - l.motor_axis.y(), disc = stops ? std::max(motor, stops->circle_mm + 2.0 * kStop_mm) : motor,
                     aside = std::acos(motor / disc);
        shape.outline = {{{0.0, 0.0}, disc, core::kPi - aside, 2.0 * core::kPi + aside}, {{motor, reach}, 0.0}, {{-motor, reach}, 0.0}};
        shape.length_mm = width;
        shape.holes = {{0.0, 0.0, seat}};
        if (!stops) return shape;
        for (const double angle : stops->posts)
            shape.holes.push_back({side * stops->circle_mm * std::cos(angle), stops->circle_mm * std::sin(angle), kStop_mm});
        return shape;
    }
    /// The post that a seat of K_PE's spring is screwed to, between the spring and the cam.
    void add_post(double side, std::vector<Extrusion>& shapes) {
        const Vector3d& at = l.k_pe_guide;
        const double half = seat_half_mm(drive), corner = seat_screw_mm(drive), x = side * at.x(), z = side * l.plane + at.z(),
                     neck = face - kThread_mm;
        std::vector<RoundHole> through{{x, z, kPassHole * l.cable}};
        for (const double end : {-1.0, 1.0}) through.push_back({x + side * end * corner, z + end * corner, kCoreHole_mm});
        shapes.push_back(block({x - half, at.y(), z - half}, {x + half, at.y() + kPost_mm, neck}, through));
        std::vector<RoundHole> threads;
        for (const double end : {-1.0, 1.0}) threads.push_back(thread({x, at.y() + (0.5 + 0.3 * end) * kPost_mm}, "k_pe_posts"));
        shapes.push_back(box({x - half, at.y(), neck}, {x + half, at.y() + kPost_mm, face}, threads));
    }
    /// Around the joint's shaft: the posts' holes, the bearing above them, and threads.
    std::vector<Extrusion> tower(double joint_range) {
        const double radius = tower_mm(l, shaft), foot = stop_foot_mm(l), on = foot + kStopOverlap_mm, neck = face - kThread_mm;
        std::vector<Extrusion> shapes{round(radius, foot, on, 0.5 * shaft + 0.5)};
        for (const Vector2d& place : stop_places(l, joint_range)) shapes.back().holes.push_back({place.x(), place.y(), kStop_mm});
        if (neck > on) shapes.push_back(round(radius, on, neck, seat));
        shapes.push_back(round(radius, neck, face, seat));
        for (const double angle : {0.5, 7.0 / 6.0, 11.0 / 6.0})
            shapes.back().holes.push_back(
                thread(0.5 * (seat + radius) * Vector2d(std::cos(angle * core::kPi), std::sin(angle * core::kPi)), "joint_tower"));
        return shapes;
    }
    [[nodiscard]] Extrusion bearing(const Vector2d& at, double low) const {
        return rod({at.x(), at.y(), low}, Vector3d::UnitZ(), seat, width, 0.5 * shaft);
    }
};

}  // namespace

double frame_plate_mm(const Layout& l, double shaft_mm) { return std::max({l.wall, bearing_width_mm(shaft_mm), kPlate_mm}); }

double tower_mm(const Layout& l, double shaft_mm) {
    return std::max(flange_mm(l.joint, l.cable) + 1.0, 0.5 * bearing_seat_mm(shaft_mm) + 2.0 * (kCoreHole_mm + 2.0));
}

std::vector<Body> frame_bodies(const Layout& l, const Drive& drive, double joint_range, std::vector<FrameHole>& holes) {
    if (!l.frame) return {};
    Builder b{l, drive, holes};
    std::vector<Body> all;
    const auto add = [&](Body body) {
        body.side = Side::kBoth;
        all.push_back(std::move(body));
    };
    const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
    const solid::HubOptions& hub = drive.k_pe->options.hub;
    const double plate = frame_plate_mm(l, b.shaft), drum = l.plane + l.drum + kFlange_mm;
    b.hole({0.0, 0.0}, b.seat, tower_mm(l, b.shaft) - b.seat, "bearing of the joint");
    std::vector<Extrusion> bearings{b.bearing({0.0, 0.0}, stop_foot_mm(l) + kStopOverlap_mm), b.bearing({0.0, 0.0}, b.face)};
    std::vector<Extrusion> rear = b.bracket("frame_rear", b.rear_wide, l.bottom), posts;
    for (const double side : {1.0, -1.0}) {
        const Vector2d axis(side * l.motor_axis.x(), l.motor_axis.y());
        b.hole(axis, b.seat, kBearingWall_mm, "bearing of a motor's shaft");
        bearings.push_back(b.bearing(axis, side * l.plane + l.arm_low)), bearings.push_back(b.bearing(axis, b.face));
        rear.push_back(b.arm(side));
        if (l.posts) b.add_post(side, posts);
    }
    add(to_make("frame_rear", Motion::kFixed, here, std::move(rear)));
    add(to_make("frame_front", Motion::kFixed, here, b.bracket("frame_front", b.wide, l.front)));
    add(to_make("joint_tower", Motion::kFixed, here, b.tower(joint_range)));
    if (l.posts) add(to_make("k_pe_posts", Motion::kFixed, here, std::move(posts)));
    add(shaped("bearings", Motion::kFixed, here, std::move(bearings)));
    add(shaped("joint_shaft", Motion::kJoint, here,
               shaft_with_flat(hub, 0.0, -drum - kShaftEnd_mm, b.face + plate + kShaftEnd_mm, -drum - kShaftEnd_mm, drum)));
    for (const double side : {1.0, -1.0})
        for (const double y : {l.front, l.bottom})
            b.hole({side * (b.rear_wide + kFoot_mm + kMount_mm), y + 0.5 * kBracket_mm}, kMount_mm, kFoot_mm, "what carries the joint");
    Extrusion sheet;
    sheet.frame.translation() = Vector3d(0.0, 0.0, b.face);
    sheet.outline = hull_outline(b.places), sheet.length_mm = plate;
    for (const FrameHole& hole : holes) sheet.holes.push_back({hole.x_mm, hole.y_mm, 0.5 * hole.diameter_mm});
    add(to_make("frame_plate", Motion::kFixed, here, {std::move(sheet)}));
    return all;
}

}  // namespace fusee::assembly
