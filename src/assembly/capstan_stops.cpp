#include <cmath>

#include "layout.h"

namespace fusee::assembly {

std::vector<double> post_angles(double circle_mm, double range) {
    const double contact = 2.0 * std::asin(std::min(1.0, kStop_mm / circle_mm));  // between the middles of pin and post
    const double turn = std::min(0.5 * range + contact, core::kPi);
    if (2.0 * (core::kPi - turn) < contact) return {core::kPi};  // two would share volume: the pin meets one at both ends
    return {-turn, turn};
}

std::optional<CapstanStops> capstan_stops(const Layout& l, const solid::HubOptions& hub) {
    constexpr double kOverlap_mm = 4.0;  // of pin and post along the axis, at least
    const double shaft = core::mm_from_m(hub.bore_diameter), floor = l.capstan - 0.5 * l.cable, wall = kStop_mm + kStopWall_mm;
    const double circle = floor - wall, range = l.turn + 2.0 * l.spare;
    if (!l.frame || circle < wall + std::max(solid::bore_reach_mm(hub), 0.5 * bearing_seat_mm(shaft))) return std::nullopt;
    if (range > 2.0 * (core::kPi - 2.0 * std::asin(kStop_mm / circle))) return std::nullopt;  // even one post is met too early
    const double flange = -l.drum - kFlange_mm, width = bearing_width_mm(shaft), space = flange - l.arm_low - width - l.gap;
    const double post = l.arm_low + pin_length_mm(width + space);
    const double pin = l.drum - pin_length_mm(std::min(l.drum - flange + space, l.drum - post + 2.5 * kOverlap_mm));
    if (post - pin < kOverlap_mm || post > flange - 0.5 * l.gap) return std::nullopt;
    CapstanStops stops{circle, -0.5 * (core::kPi + l.turn), {}, pin, l.drum, post};
    for (const double angle : post_angles(circle, range)) stops.posts.push_back(angle - 0.5 * core::kPi);
    return stops;
}

void add_capstan_stops(const Layout& l, const solid::HubOptions& hub, std::vector<Body>& to) {
    const auto stops = capstan_stops(l, hub);
    if (!stops) return;
    const Eigen::Isometry3d axis(Eigen::Translation3d(l.motor_axis));
    const auto pin = [&](double angle, double low, double high) {
        return rod(Eigen::Vector3d(stops->circle_mm * std::cos(angle), stops->circle_mm * std::sin(angle), low), Eigen::Vector3d::UnitZ(),
                   kStop_mm, high - low);
    };
    to.push_back(shaped("capstan_pin", Motion::kCapstan, axis, {pin(stops->pin, stops->pin_low_mm, stops->pin_high_mm)}));
    std::vector<Extrusion> posts;
    for (const double angle : stops->posts) posts.push_back(pin(angle, l.arm_low, stops->post_high_mm));
    to.push_back(shaped("capstan_stops", Motion::kFixed, axis, std::move(posts)));
}

}  // namespace fusee::assembly
