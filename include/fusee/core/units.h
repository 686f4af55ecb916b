#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

/// Everything inside fusee is SI and radians; these are used only where a file or a person needs other units.
namespace fusee::core {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

constexpr double deg_from_rad(double rad) { return rad * 180.0 / kPi; }
constexpr double rad_from_deg(double deg) { return deg * kPi / 180.0; }
constexpr double mm_from_m(double metres) { return metres * 1e3; }
constexpr double m_from_mm(double millimetres) { return millimetres * 1e-3; }

/// A closed interval [low, high] of one quantity.
struct Range {
    double low = 0.0;
    double high = 0.0;
    [[nodiscard]] constexpr double width() const { return high - low; }
    [[nodiscard]] constexpr bool holds(double x) const { return x >= low && x <= high; }
    /// Number `i` of `count` evenly spaced values, both ends included. @pre i < count, count >= 2
    [[nodiscard]] constexpr double level(std::size_t i, std::size_t count) const {
        return i + 1 == count ? high : low + static_cast<double>(i) / static_cast<double>(count - 1) * width();
    }
};

inline constexpr double kTurn = 2.0 * kPi;  ///< [rad]

/// The same direction within [low, low + kTurn).
[[nodiscard]] inline double within_turn(double angle, double low) { return angle - kTurn * std::floor((angle - low) / kTurn); }

// Products of points and directions kept as arrays, as meshes, outlines and files have them.

template <std::size_t N>
constexpr std::array<double, N> minus(const std::array<double, N>& a, const std::array<double, N>& b) {
    std::array<double, N> difference{};
    for (std::size_t i = 0; i < N; ++i) difference[i] = a[i] - b[i];
    return difference;
}
template <std::size_t N>
constexpr double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
    double sum = a[0] * b[0];
    for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
    return sum;
}
constexpr double cross(const std::array<double, 2>& a, const std::array<double, 2>& b) { return a[0] * b[1] - a[1] * b[0]; }
constexpr std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace fusee::core
