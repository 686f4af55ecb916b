#pragma once
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/coupon/sheet.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"

namespace fusee::coupon {

/// Input of the coupons of one design. They are never compensated: they measure the compensation.
struct CouponOptions {
    solid::GrooveOptions groove;
    solid::HubOptions hub;               ///< of the disc; the ladder is for its shaft
    double cable_diameter = 1e-3;        ///< [m]
    double loaded_wall = 1.2e-3;         ///< thinnest wall that carries load [m]
    double detail = 0.4e-3;              ///< narrowest slot [m]
    core::Range clearance{0.0, 0.4e-3};  ///< of the ladder's holes, in diameter [m]
    int holes = 5;                       ///< 2 to 9
    double disc_turns = 3.0;             ///< of cable that can be drawn off; 0.5 to 10
    double chordal_error = 2e-6;         ///< [m]
};

/// Lengths along three axes and the bore ladder: an L with a tower on its corner. Hole i has i notches on the plate's top; the first has
/// none.
struct Plate {
    solid::Mesh mesh;
    double length_mm = 0.0;                 ///< of both arms
    double width_mm = 0.0;                  ///< of both arms
    double plate_mm = 0.0, tower_mm = 0.0;  ///< heights above the bed
    std::vector<double> bores_mm;           ///< rising, from the corner outwards
};
/// Refusal: "coupon.validity". @throws core::InvalidInput naming an option of a profile
[[nodiscard]] core::Outcome<Plate> make_plate(const CouponOptions& options);

/// Round grooves above one another, counted from the wide foot, with different floor radii; that of the profile is among them.
struct GrooveLadder {
    solid::Mesh mesh;
    std::vector<double> ratios;  ///< floor radius over cable diameter, rising, from the foot up
    std::vector<double> z_mm;    ///< of each groove's middle above the bed
};
/// Refusal: "coupon.validity". @throws core::InvalidInput naming an option of a profile
[[nodiscard]] core::Outcome<GrooveLadder> make_groove_ladder(const CouponOptions& options);

/// A disc with the profile's groove: the cam of a linear law on a linear spring, with a constant arm; several turns as a helix.
struct Disc {
    solid::Part part;
    spring::BaseSpring spring;  ///< of its part file
    double floor_mm = 0.0;      ///< radius of the groove's floor, also that of the ladder's grooves
};
/// Refusal: that of cam and solid. @throws core::InvalidInput naming an option of a profile
[[nodiscard]] core::Outcome<Disc> make_disc(const CouponOptions& options);

/// Radius of the floors of disc and groove ladder: whole millimetres with space for shaft and key [mm].
[[nodiscard]] double floor_mm(const CouponOptions& options);

/// Rounds to STL's precision and proves that the mesh is one closed solid. Refusal: "coupon.validity"
[[nodiscard]] core::Outcome<solid::Mesh> finished(solid::Mesh mesh, const char* name);

}  // namespace fusee::coupon
