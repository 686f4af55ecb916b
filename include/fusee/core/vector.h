#pragma once
#include <array>
#include <cstddef>

/// Products of points and directions kept as arrays, as meshes, outlines and files have them.
namespace fusee::core {

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
