#pragma once
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

}  // namespace fusee::core
