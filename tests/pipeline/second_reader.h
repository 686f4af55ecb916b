#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// A second reader of parts: what moves a spring, from the bytes of an STL file and the numbers of PART.json. It shares no code with the
/// program. Lengths in mm.
namespace fusee::second_reader {

using Point = std::array<double, 2>;
using Triangle = std::array<std::array<float, 3>, 3>;

inline std::vector<Triangle> triangles_of(const std::string& stl) {
    std::uint32_t count = 0;
    std::memcpy(&count, stl.data() + 80, sizeof count);
    std::vector<Triangle> all(count);
    for (std::size_t i = 0; i < all.size(); ++i) std::memcpy(all[i].data(), stl.data() + 84 + 50 * i + 12, sizeof all[i]);
    return all;
}

/// Where the edges of the mesh cross the groove's middle plane, the bore left out: on the floor.
inline std::vector<Point> floor_of(const std::string& stl) {
    constexpr double kPlane = 1e-5, kBore = 5.0;
    std::vector<Point> points;
    for (const Triangle& corner : triangles_of(stl)) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto &a = corner[k], &b = corner[(k + 1) % 3];
            if ((a[2] < kPlane) == (b[2] < kPlane)) continue;
            const double t = (kPlane - a[2]) / (b[2] - a[2]);
            const Point at{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
            if (std::hypot(at[0], at[1]) > kBore) points.push_back(at);
        }
    }
    return points;
}

/// Corners of the mesh half-way up, the bore left out, by azimuth: they lie on the rim.
inline std::vector<Point> rim_of(const std::string& stl, double bore) {
    constexpr double kHalfWay = 1e-4;
    std::set<std::pair<double, Point>> corners;
    for (const Triangle& triangle : triangles_of(stl))
        for (const auto& p : triangle)
            if (const Point at{p[0], p[1]}; std::abs(p[2]) < kHalfWay && std::hypot(at[0], at[1]) > bore)
                corners.insert({std::atan2(at[1], at[0]), at});
    std::vector<Point> all;
    for (const auto& corner : corners) all.push_back(corner.second);
    return all;
}

/// The part as it stands at a cam angle.
inline std::vector<Point> at_angle(const std::vector<Point>& points, const nlohmann::json& part, double cam_angle) {
    const double angle = part["rotation_sign"].get<int>() * cam_angle, c = std::cos(angle), s = std::sin(angle);
    std::vector<Point> all;
    for (const Point& p : points) all.push_back({c * p[0] - s * p[1], s * p[0] + c * p[1]});
    return all;
}

/// The arm of a taut cable from the guide over the floor, half a cable above it.
inline double cable_arm(const std::vector<Point>& floor, const nlohmann::json& part, double cam_angle) {
    const double side = part["torque_sign"].get<int>();
    const double gx = part["guide"]["position_mm"][0], gy = part["guide"]["position_mm"][1],
                 half = 0.5 * part["cable_diameter_mm"].get<double>();
    double most = -M_PI;
    for (const Point& at : at_angle(floor, part, cam_angle)) {
        const double x = at[0] - gx, y = at[1] - gy;
        const double seen = side * std::atan2(-gx * y + gy * x, -gx * x - gy * y);  // from the line to the axis
        most = std::max(most, seen + std::asin(half / std::hypot(x, y)));
    }
    return std::hypot(gx, gy) * std::sin(most);
}

/// The greatest of the places to which the corners of a rim push a follower: the top of the quartic through the greatest one and two
/// neighbours on each side, over their distances along the rim. @param places -9: the corner does not reach the follower
inline double top_of(const std::vector<Point>& rim, const std::vector<double>& places) {
    constexpr std::size_t kCorners = 5, kMiddle = 2;
    constexpr int kSteps = 40;
    const auto greatest = static_cast<std::size_t>(std::max_element(places.begin(), places.end()) - places.begin()), n = places.size();
    std::array<double, kCorners> x{}, y{};
    for (std::size_t k = 0; k < kCorners; ++k) {
        const std::size_t at = (greatest + n + k - kMiddle) % n, before = (at + n - 1) % n;
        if (k > 0) x[k] = x[k - 1] + std::hypot(rim[at][0] - rim[before][0], rim[at][1] - rim[before][1]);
        y[k] = places[at];
        if (y[k] < -8.0) return places[greatest];
    }
    const auto quartic = [&](double at) {
        double sum = 0.0;
        for (std::size_t k = 0; k < kCorners; ++k) {
            double share = y[k];
            for (std::size_t other = 0; other < kCorners; ++other)
                if (other != k) share *= (at - x[other]) / (x[k] - x[other]);
            sum += share;
        }
        return sum;
    };
    double low = x[kMiddle - 1], high = x[kMiddle + 1];
    for (int i = 0; i < kSteps; ++i) {
        const double third = (high - low) / 3.0;
        if (quartic(low + third) < quartic(high - third))
            low += third;
        else
            high -= third;
    }
    return quartic(0.5 * (low + high));
}

/// How far the rim lifts the roller on a slide from its place at cam angle 0.
inline double lift(const std::vector<Point>& rim, const nlohmann::json& part, double cam_angle) {
    const nlohmann::json& guide = part["guide"];
    const double ux = guide["direction"][0], uy = guide["direction"][1], side = part["torque_sign"].get<int>();
    const double radius = guide["radius_mm"], offset = guide["offset_mm"];
    std::vector<double> places;
    for (const Point& at : at_angle(rim, part, cam_angle)) {
        const double along = at[0] * ux + at[1] * uy, across = side * (at[1] * ux - at[0] * uy) - offset;
        places.push_back(along < 0.0 || std::abs(across) > radius ? -9.0 : along + std::sqrt(radius * radius - across * across));
    }
    return top_of(rim, places) - guide["start_mm"].get<double>();
}

/// How far the rim turns the follower's arm from its place at cam angle 0 [rad].
inline double swing(const std::vector<Point>& rim, const nlohmann::json& part, double cam_angle) {
    const nlohmann::json& guide = part["guide"];
    const double arm = guide["arm_mm"], roller = guide["radius_mm"], sense = guide["sense"];
    const double start = std::atan2(guide["direction"][1].get<double>(), guide["direction"][0].get<double>());
    std::vector<double> places;
    for (const Point& at : at_angle(rim, part, cam_angle)) {
        const double x = at[0] - guide["position_mm"][0].get<double>(), y = at[1] - guide["position_mm"][1].get<double>(),
                     away = std::hypot(x, y);
        const double cosine = (arm * arm + away * away - roller * roller) / (2.0 * arm * away);
        places.push_back(std::abs(cosine) > 1.0 ? -9.0 : sense * std::remainder(std::atan2(y, x) - start, 2.0 * M_PI) + std::acos(cosine));
    }
    return top_of(rim, places);
}

/// Slope at x of the polynomial of degree 5 that is nearest to the values within `half` of it.
inline double slope_at(const std::vector<double>& x, const std::vector<double>& y, double at, double half) {
    constexpr std::size_t kTerms = 6;
    std::array<std::array<double, kTerms + 1>, kTerms> m{};  // normal equations
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = (x[i] - at) / half;
        if (std::abs(u) > 1.0) continue;
        for (std::size_t r = 0; r < kTerms; ++r) {
            for (std::size_t k = 0; k < kTerms; ++k) m[r][k] += std::pow(u, r + k);
            m[r][kTerms] += std::pow(u, r) * y[i];
        }
    }
    for (std::size_t p = 0; p < kTerms; ++p)
        for (std::size_t r = 0; r < kTerms; ++r) {
            if (r == p) continue;
            const double factor = m[r][p] / m[p][p];
            for (std::size_t k = p; k <= kTerms; ++k) m[r][k] -= factor * m[p][k];
        }
    return m[1][kTerms] / m[1][1] / half;
}

}  // namespace fusee::second_reader
