#include <algorithm>
#include <cmath>

#include "fusee/assembly/to_make.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

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
