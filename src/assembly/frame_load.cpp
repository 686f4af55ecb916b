#include <cmath>

#include "fusee/assembly/to_make.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

using core::m_from_mm;
using Eigen::Vector2d;

/// What two bearings of a shaft carry: both loads in the plane, at their heights.
struct Reactions {
    Vector2d near, far;  ///< [N]
};

/// A load across a shaft, at its height.
struct Pull {
    Vector2d force;  ///< [N]
    double z_mm = 0.0;
};

/// A shaft in two bearings.
Reactions reactions(double near_mm, double far_mm, std::initializer_list<Pull> pulls) {
    Reactions r{Vector2d::Zero(), Vector2d::Zero()};
    for (const Pull& pull : pulls) {
        const double on_near = (far_mm - pull.z_mm) / (far_mm - near_mm);
        r.near += on_near * pull.force, r.far += (1.0 - on_near) * pull.force;
    }
    return r;
}

void keep_larger(double& most, double value) { most = std::max(most, value); }

/// Stress of a rectangular section that bends about its width [MPa]. @param deep_mm along the load
double rectangle_MPa(double moment, double wide_mm, double deep_mm) {
    return 1e-6 * 6.0 * moment / (m_from_mm(wide_mm) * std::pow(m_from_mm(deep_mm), 2));
}

/// The frame's loads while they are collected.
struct Frame {
    const Assembly& a;
    std::array<double, 2> series = tensions(a.drive.k_se->cam), parallel = tensions(a.drive.k_pe->cam);
    double shaft = core::mm_from_m(a.drive.k_pe->options.hub.bore_diameter), seat = 0.5 * bearing_seat_mm(shaft);
    double face = a.find("frame_plate")->shapes.front().frame.translation().z(), plate = plate_mm(a);
    FrameLoad load = {};

    /// The largest of each bearing and the arm's force, over the working range of one motor.
    void motor(bool agonist) {
        const std::size_t arm = agonist ? 2 : 4;
        const double plane = agonist ? a.plane_mm : -a.plane_mm, near = bearing_mm(a, arm), far = bearing_mm(a, arm + 1);
        const Body& cam = *a.find(agonist ? "k_pe_agonist" : "k_pe_antagonist");
        const Vector2d along(std::cos(a.options.k_pe_direction) * (agonist ? 1.0 : -1.0), std::sin(a.options.k_pe_direction));
        double across = 0.0, pulled = 0.0;  // of the arm: along x, along y
        for (const double drive : series)
            for (const cam::Contact& c : a.drive.k_pe->cam.working) {
                const double z = (cam.rest * Eigen::Vector3d(0.0, 0.0, core::mm_from_m(c.path.z))).z();
                const Reactions r = reactions(near, far, {{c.arm.tension * along, z}, {drive * Vector2d::UnitY(), plane}});
                keep_larger(load.bearings[0].force, r.near.norm()), keep_larger(load.bearings[1].force, r.far.norm());
                keep_larger(across, std::abs(r.near.x())), keep_larger(pulled, std::abs(r.near.y()));
            }
        arm_and_bracket(near, across, pulled);
    }

    /// The arm is pulled along y and bent along x; the bracket, on one side of the joint, is bent by what the arm pulls.
    void arm_and_bracket(double arm_mm, double across, double pulled) {
        const Body& rear = *a.find("frame_rear");
        const double wide = 2.0 * (seat + kBearingWall_mm), width = bearing_width_mm(shaft), depth = face - arm_mm;
        const double reach = rear.shapes.front().frame.translation().y() - 0.5 * kBracket_mm + a.motor_distance_mm;
        keep(0,
             1e-6 * pulled / (2.0 * m_from_mm(kBearingWall_mm) * m_from_mm(width)) + rectangle_MPa(across * m_from_mm(reach), width, wide),
             0.0);
        const double moment = pulled * m_from_mm(depth);
        keep(1, rectangle_MPa(moment, rear_width_mm(a, depth), kBracket_mm), moment / (2.0 * m_from_mm(0.5 * kBracket_mm)));  // two screws
    }

    /// Both cables pull at the joint's pulley, towards the motors.
    void joint() {
        const double near = bearing_mm(a, 0), far = bearing_mm(a, 1);
        const Vector2d pull = -series[1] * Vector2d::UnitY();
        const Reactions r = reactions(near, far, {{pull, a.plane_mm}, {pull, -a.plane_mm}});
        load.bearings[2].force = r.near.norm(), load.bearings[3].force = r.far.norm();
        const double outer = a.find("joint_tower")->shapes.front().radius_mm, moment = r.near.norm() * m_from_mm(face - near);
        const double modulus =
            core::kPi * (std::pow(m_from_mm(2.0 * outer), 4) - std::pow(m_from_mm(2.0 * seat), 4)) / (32.0 * m_from_mm(2.0 * outer));
        const double far_screw = outer + 0.5 * (seat + outer), near_screw = outer - 0.25 * (seat + outer);  // from the edge it tilts about
        const double levers = far_screw * far_screw + 2.0 * near_screw * near_screw;
        keep(2, 1e-6 * moment / modulus, moment * far_screw / m_from_mm(1.0) / levers);
        bend_plate(2.0 * series[1], 0.0, a.find("frame_front")->shapes.front().frame.translation().y());
    }

    /// Two cables at a mean height pull its ends together: it bends at a place y under their lever below it.
    void bend_plate(double pull, double cables_mm, double y_mm) {
        const double width = plate_width_mm(a, y_mm);
        keep(4,
             rectangle_MPa(pull * m_from_mm(face + 0.5 * plate - cables_mm), width, plate) +
                 1e-6 * pull / (m_from_mm(width) * m_from_mm(plate)),
             0.0);
    }

    /// The seat of K_PE's spring pushes its post, the antagonist's at the greater depth. The plate bends between motors and posts, most at
    /// its bearings.
    void post() {
        if (a.find("k_pe_posts") == nullptr) return;
        const double depth = face - (a.k_pe_guide_mm.z() - 2.0 * a.plane_mm), moment = parallel[1] * m_from_mm(depth);
        const double far_screw = 0.8 * kPost_mm, near_screw = 0.2 * kPost_mm;
        keep(3, rectangle_MPa(moment, 2.0 * seat_half_mm(a.drive), kPost_mm),
             moment * far_screw / m_from_mm(1.0) / (far_screw * far_screw + near_screw * near_screw));
        bend_plate(2.0 * parallel[1], a.k_pe_guide_mm.z() - a.plane_mm, -a.motor_distance_mm);
    }

    void keep(std::size_t i, double stress_MPa, double screw) {
        keep_larger(load.parts.at(i).stress_MPa, stress_MPa), keep_larger(load.parts.at(i).screw, screw);
    }
};

using core::m_from_mm;

constexpr double kSteelModulus = 210e9;  // E of shafts [Pa]

/// I of a rectangle [m^4]. @param deep_mm along the load
double rectangle(double wide_mm, double deep_mm) { return m_from_mm(wide_mm) * std::pow(m_from_mm(deep_mm), 3) / 12.0; }

/// Give of a cantilever at its end [m/N]. @param second_moment I [m^4]
double cantilever(double length_mm, double modulus, double second_moment) {
    return std::pow(m_from_mm(length_mm), 3) / (3.0 * modulus * second_moment);
}

/// Give of a shaft in two bearings where it is loaded [m/N], beyond the near one or between both.
double shaft_give(double diameter_mm, double near_mm, double far_mm, double load_mm) {
    const double bends = 3.0 * kSteelModulus * core::kPi * std::pow(m_from_mm(diameter_mm), 4) / 64.0;
    const double span = m_from_mm(std::abs(far_mm - near_mm)), from_near = m_from_mm(std::abs(load_mm - near_mm));
    const bool between = (load_mm - near_mm) * (load_mm - far_mm) < 0.0;
    return from_near * from_near / bends * (between ? std::pow(span - from_near, 2) / span : span + from_near);
}

/// What is common to both kinds of cables. Lengths [mm], moduli [Pa].
struct Beams {
    const Assembly& a;
    double face = a.find("frame_plate")->shapes.front().frame.translation().z(), thick = plate_mm(a);
    double shaft = core::mm_from_m(a.drive.k_pe->options.hub.bore_diameter);
    double rear_y = a.find("frame_rear")->shapes.front().frame.translation().y();
    double metal = material_of(a, *a.find("frame_plate")).modulus, print = material_of(a, *a.find("frame_rear")).modulus;

    /// Both cables of a kind bend it between two places y; at their mean height the ends come nearer by lever^2 integral dy/(E I).
    [[nodiscard]] double plate(double from_y, double to_y, double cables_mm) const {
        constexpr int kSteps = 40;
        double turn = 0.0;  // per newton metre
        for (int i = 0; i < kSteps; ++i) {
            const double y = from_y + (to_y - from_y) * (i + 0.5) / kSteps;
            turn += m_from_mm(std::abs(to_y - from_y)) / kSteps / (metal * rectangle(plate_width_mm(a, y), thick));
        }
        return 2.0 * std::pow(m_from_mm(face + 0.5 * thick - cables_mm), 2) * turn;
    }
    /// Of a motor's shaft with its arm of frame_rear, at a cable's height: the larger of both sides.
    [[nodiscard]] double motor(double agonist_mm, double antagonist_mm) const {
        double most = 0.0;
        for (const auto& [arm, cable] : {std::pair(std::size_t{2}, agonist_mm), std::pair(std::size_t{4}, antagonist_mm)}) {
            const double near = bearing_mm(a, arm), far = bearing_mm(a, arm + 1), depth = face - near;
            const double share = (far - cable) / (far - near);  // of the cable's pull, on the arm, and of the arm's give at the cable
            const double bracket = cantilever(depth, print, rectangle(rear_width_mm(a, depth), kBracket_mm));
            most = std::max(most, share * share * bracket + shaft_give(shaft, near, far, cable));
        }
        return most;
    }
    /// Of the joint's shaft in its tower, which both cables pull.
    [[nodiscard]] double joint() const {
        const double near = bearing_mm(a, 0), far = bearing_mm(a, 1), share = far / (far - near);
        const double outer = m_from_mm(a.find("joint_tower")->shapes.front().radius_mm), inner = m_from_mm(0.5 * bearing_seat_mm(shaft));
        const double tower = cantilever(face - near, print, 0.25 * core::kPi * (std::pow(outer, 4) - std::pow(inner, 4)));
        return 2.0 * (share * share * tower + shaft_give(shaft, near, far, 0.0));
    }
    /// Where the springs behind the series cable are stiffest [N/m].
    [[nodiscard]] double series_rate() const {
        const auto& working = a.drive.k_se->cam.working;
        double most = 0.0;
        for (std::size_t i = 1; i < working.size(); ++i)
            most = std::max(
                most, (working[i].arm.tension - working[i - 1].arm.tension) / m_from_mm(a.k_se[i].length_mm - a.k_se[i - 1].length_mm));
        return most;
    }
};

}  // namespace

double plate_mm(const Assembly& a) { return a.find("frame_plate")->shapes.front().length_mm; }

double plate_width_mm(const Assembly& a, double y_mm) {
    const solid::Ring ring = solid::ring_of(a.find("frame_plate")->shapes.front().outline, 0.05);
    double low = INFINITY, high = -INFINITY;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const solid::Point2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
        if ((p[1] < y_mm) == (q[1] < y_mm)) continue;
        const double x = p[0] + (q[0] - p[0]) * (y_mm - p[1]) / (q[1] - p[1]);
        low = std::min(low, x), high = std::max(high, x);
    }
    double width = high - low;
    for (const FrameHole& hole : a.frame_holes) {
        const double aside = std::abs(hole.y_mm - y_mm), radius = 0.5 * hole.diameter_mm;
        if (aside < radius) width -= 2.0 * std::sqrt(radius * radius - aside * aside);
    }
    return width;
}

double rear_width_mm(const Assembly& a, double depth_mm) {
    const double shaft = core::mm_from_m(a.drive.k_pe->options.hub.bore_diameter), arm = bearing_seat_mm(shaft) + 2.0 * kBearingWall_mm;
    const double holes = 2.0 * 2.0 * kRod_mm + 2.0 * kPassHole * a.cable_mm;
    return std::min(arm + 2.0 * depth_mm, a.find("frame_rear")->shapes.front().half_x_mm) - holes;
}

double bearing_mm(const Assembly& a, std::size_t i) {
    const Extrusion& ring = a.find("bearings")->shapes.at(i);
    return ring.frame.translation().z() + 0.5 * ring.length_mm;
}

checks::Process process_of(const Assembly& a, const Body& body) {
    if (body.name == "frame_plate") return {.kind = checks::ProcessKind::kMill, .material = {}};
    return checks::is_stacked(a.drive.process) ? checks::Process{} : a.drive.process;
}

checks::Material material_of(const Assembly& a, const Body& body) { return checks::material_of(process_of(a, body)); }

std::optional<FrameLoad> frame_load(const Assembly& a) {
    if (a.find("frame_plate") == nullptr) return std::nullopt;
    Frame frame{a};
    frame.motor(true), frame.motor(false);
    frame.joint();
    frame.post();
    for (FrameLoad::Part& part : frame.load.parts) part.material = material_of(a, *a.find("joint_tower"));
    frame.load.parts.back().material = material_of(a, *a.find("frame_plate"));
    return frame.load;
}

std::vector<FrameGive> frame_gives(const Assembly& a) {
    const Beams frame{a};
    const double rear = frame.rear_y, series = frame.plate(0.0, rear, 0.0);
    std::vector<FrameGive> all{{"series", series, series + frame.motor(a.plane_mm, -a.plane_mm) + frame.joint(), frame.series_rate()}};
    if (a.find("k_pe_posts") == nullptr) return all;
    const double agonist = a.k_pe_guide_mm.z(), mean = agonist - a.plane_mm, antagonist = agonist - 2.0 * a.plane_mm;
    const double plate = frame.plate(rear, a.k_pe_guide_mm.y() + 0.5 * kPost_mm, mean);
    const double post = cantilever(frame.face - antagonist, frame.print, rectangle(2.0 * seat_half_mm(a.drive), kPost_mm));
    all.push_back({"parallel", plate, plate + frame.motor(agonist, antagonist) + post, a.drive.k_pe_spring.rate});
    return all;
}

}  // namespace fusee::assembly
