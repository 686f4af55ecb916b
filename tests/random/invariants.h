#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Laws that hold for every design, so that a design that nobody chose can be tested without a known answer.
namespace fusee::random_profiles {

enum Invariant : std::size_t {
    kMirror,      ///< the cam of mirrored options is the mirror image, and its contour carries the same arms
    kScale,       ///< radii times a, torques times b: the cam times a
    kCut,         ///< a law cut in two: the second cam begins where the first ends, and both have the arms of the whole
    kRotate,      ///< the guide turned by an angle: the contour turned by it
    kUnits,       ///< profile -> TOML -> profile: the same numbers, bit for bit, and the same cam
    kFixedPoint,  ///< design -> files -> arms found in them -> springs -> law -> design: the same arms
    kInvariants
};
inline constexpr std::array<const char*, kInvariants> kInvariantNames{"mirror", "scale", "cut", "rotate", "units", "fixed point"};

/// What one design showed.
struct Shown {
    /// Largest relative error (to the largest arm) over both cams; none: the design has no cam to try it on.
    std::array<std::optional<double>, kInvariants> error{};
};
/// Allowed errors: rounding for the first four, none for the fifth; for the files the read-back limit of each of the two springs.
inline constexpr std::array<double, kInvariants> kAllowed{1e-9, 1e-9, 1e-9, 1e-9, 0.0, 2e-3};

/// Tries all on one profile. @param files also the fixed point through an STL, which takes a second
[[nodiscard]] Shown try_invariants(const std::string& toml, std::uint64_t seed, int number, bool files);

}  // namespace fusee::random_profiles
