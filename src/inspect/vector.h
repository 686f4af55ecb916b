#pragma once
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"

namespace fusee::inspect {

using core::cross;
using core::dot;
using solid::Vec3;

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return core::minus(a, b); }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
/// The zero vector stays zero.
inline Vec3 unit(const Vec3& a) {
    const double l = length(a);
    return l > 0.0 ? (1.0 / l) * a : a;
}
/// A direction that is parallel to no edge of a usual part.
inline const Vec3 kAskew = unit({0.6180339887, 0.3819660113, 0.7320508076});
/// Two unit vectors that form a right-handed frame with the unit vector `w`.
struct Frame {
    Vec3 u, v;
};
inline Frame frame_about(const Vec3& w) {
    const Vec3 u = unit(cross(w, std::abs(w[0]) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    return {u, cross(w, u)};
}

}  // namespace fusee::inspect
