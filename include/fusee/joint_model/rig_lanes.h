#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fusee/joint_model/built_rig.h"

/// Figures of several rigs that are calculated together, one rig in each lane. The code is written once for V = double (one rig) and
/// V = Lanes (four): each lane has the bits that its rig has alone.
namespace fusee::joint_model {

/// GCC's vector extension: two SSE2 registers or one of AVX. Four independent steps take little longer than one, whose time is that of a
/// chain of operations.
using Lanes = double __attribute__((vector_size(32)));
template <class V>
inline constexpr std::size_t kWidth = sizeof(V) / sizeof(double);
template <class V>
using Mask = decltype(V{} < V{});
template <class V>
using RigsOf = std::array<const BuiltRig*, kWidth<V>>;

[[nodiscard]] inline double lane(double v, std::size_t) { return v; }
[[nodiscard]] inline double lane(const Lanes& v, std::size_t i) { return v[i]; }
template <class V>
inline void set_lane(V& v, std::size_t i, double value) {
    if constexpr (kWidth<V> == 1)
        (void)i, v = value;
    else
        v[i] = value;
}
/// f(0), f(1), ... in the lanes.
template <class V, class F>
[[nodiscard]] inline V each(const F& f) {
    if constexpr (kWidth<V> == 1)
        return f(0);
    else
        return V{f(0), f(1), f(2), f(3)};
}
template <class V>
[[nodiscard]] inline V in_all(double value) {
    return each<V>([value](std::size_t) { return value; });
}
[[nodiscard]] inline bool any(bool mask) { return mask; }
[[nodiscard]] inline bool any(const Mask<Lanes>& mask) {
    const auto either = __builtin_shufflevector(mask, mask, 0, 1) | __builtin_shufflevector(mask, mask, 2, 3);
    return (either[0] | either[1]) != 0;
}
[[nodiscard]] inline double least(double v) { return v; }
[[nodiscard]] inline double least(const Lanes& v) { return std::min({v[0], v[1], v[2], v[3]}); }
// Whole numbers in the lanes.
using LaneNumbers = int __attribute__((vector_size(16)));
template <class V>
using Numbers = std::conditional_t<kWidth<V> == 1, int, LaneNumbers>;
[[nodiscard]] inline int whole(double v) { return static_cast<int>(v); }
[[nodiscard]] inline LaneNumbers whole(const Lanes& v) { return __builtin_convertvector(v, LaneNumbers); }
[[nodiscard]] inline double figures(int n) { return n; }
[[nodiscard]] inline Lanes figures(const LaneNumbers& n) { return __builtin_convertvector(n, Lanes); }
[[nodiscard]] inline int lane(int n, std::size_t) { return n; }
[[nodiscard]] inline int lane(const LaneNumbers& n, std::size_t i) { return n[i]; }
template <class V>
[[nodiscard]] inline V greater(V a, V b) {
    return a < b ? b : a;
}
template <class V>
[[nodiscard]] inline V clamped(V v, V low, V high) {
    return v < low ? low : high < v ? high : v;
}
[[nodiscard]] inline double magnitude(double v) { return std::abs(v); }
[[nodiscard]] inline double with_sign(double v, double of) { return std::copysign(v, of); }
[[nodiscard]] inline Lanes with_sign(Lanes v, Lanes of) {
    const Mask<Lanes> sign = Mask<Lanes>{} + std::numeric_limits<std::int64_t>::min();
    return reinterpret_cast<Lanes>((reinterpret_cast<Mask<Lanes>>(v) & ~sign) | (reinterpret_cast<Mask<Lanes>>(of) & sign));
}
[[nodiscard]] inline Lanes magnitude(Lanes v) { return with_sign(v, Lanes{}); }

/// The table of a spring (CamSpring) in each lane.
template <class V>
class SpringLanes {
public:
    SpringLanes(const RigsOf<V>& rigs, std::size_t side, CamSpring BuiltSide::*spring) {
        for (std::size_t i = 0; i < kWidth<V>; ++i) {
            const CamSpring& own = rigs[i]->sides[side].*spring;
            table_[i] = own.cells();
            set_lane(per_step_, i, own.cells_per_rad());
            set_lane(last_, i, own.last_cell());
        }
        first_ = each<V>([&](std::size_t i) { return table_[i][0]; });
    }
    /// Torque at deflection x, as CamSpring::torque.
    [[nodiscard]] V torque(V x) const {
        const V place = x * per_step_;
        V cell = place < last_ ? place : last_;
        cell = cell > 0.0 ? cell : V{};
        const Numbers<V> n = whole(cell);
        const V low = each<V>([&](std::size_t i) { return table_[i][lane(n, i)]; });
        const V high = each<V>([&](std::size_t i) { return table_[i][lane(n, i) + 1]; });
        const V inside = low + (place - figures(n)) * (high - low);
        if (!any(x <= 0.0)) return inside;
        const V slack = x <= -CamSpring::kStop ? V{} : first_ * (1.0 + x / CamSpring::kStop);
        return x <= 0.0 ? slack : inside;
    }

private:
    std::array<const double*, kWidth<V>> table_{};
    V per_step_{}, last_{}, first_{};
};

/// What every step needs of a side; the rarer terms are asked of the rigs themselves, where a flag says that one of them has any.
template <class V>
struct SideLanes {
    SideLanes(const RigsOf<V>& rigs, std::size_t side);
    V ratio, capstan_scale, motor_inertia, load_friction, coulomb, quadratic, asymmetry, stribeck, viscous, torque_scale, saturation;
    V half_backlash, se_hysteresis, pe_hysteresis;
    SpringLanes<V> se, pe;
    bool moving_terms = false, has_stribeck = false;
};

/// The same of the rigs as a whole.
template <class V>
struct RigLanes {
    explicit RigLanes(const RigsOf<V>& rigs);
    RigsOf<V> rigs;
    std::array<SideLanes<V>, 2> sides;
    V joint_inertia, joint_coulomb, tension_friction, joint_viscous, stop, stop_stiffness, stop_damping, gravity, half_play;
    V memory;                                                      ///< 1: a spring or cable depends on time
    bool remembers = false, hysteresis = false, backlash = false;  ///< of any rig
    bool arm = false, torque = false, drag = false, bump = false, has_gravity = false, plays = false;  ///< terms of any joint
};

}  // namespace fusee::joint_model
