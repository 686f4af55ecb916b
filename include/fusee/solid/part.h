#pragma once
#include <array>
#include <string>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/core/finding.h"
#include "fusee/solid/mesh.h"

/// The solid of a part: its options, its making, its mirror image, its compensation for a process.
namespace fusee::solid {

/// Section of the cable groove: a round floor, straight flanks at half the throat angle, and lips.
struct GrooveOptions {
    double radius_ratio = 0.53;          ///< floor radius over cable diameter
    double depth_ratio = 1.5;            ///< depth of the lips above the floor, in cable diameters
    double throat = 1.5707963267948966;  ///< full angle between the flanks [rad]
    double rib = 1e-3;                   ///< flange thickness beside the groove (planar), least land between turns (helix) [m]
    double plate = 0.0;                  ///< stack of plates: thickness of the one that carries the floor; 0 = two floor radii [m]
    bool stacked = false;                ///< cut from sheet: a planar part for a cable is a stack of plates (fusee/solid/stack.h)
};

enum class HubKind {
    kThrough,   ///< the bore goes through the groove's plane
    kOverhung,  ///< a boss below the cam carries a blind bore: for arms too short for a shaft
};
enum class HubLock { kPlain, kKeyway, kDFlat, kSetScrew };

/// How a keyway gets the fit of its key: as the process leaves it, or filed or broached to the key.
enum class KeyFit { kAsMade, kByHand };

struct HubOptions {
    HubKind kind = HubKind::kThrough;
    HubLock lock = HubLock::kKeyway;
    double bore_diameter = 5e-3;     ///< [m], nominal plus `bore_clearance`
    double bore_clearance = 0.2e-3;  ///< added to the diameter [m]
    double key_width = 2e-3;         ///< b, DIN 6885-1 [m]
    double key_depth = 1e-3;         ///< t2, above the bore's radius [m]
    KeyFit key_fit = KeyFit::kAsMade;
    double flat_depth = 0.5e-3;   ///< D-flat: bore radius minus distance of the flat from the axis [m]
    double screw_diameter = 0.0;  ///< set screw hole, radial, in the boss [m]
    double boss_diameter = 0.0;   ///< [m]; overhung and set screw
    double boss_height = 0.0;     ///< below the lower flange [m]; 0 = no boss
    double web = 1.5e-3;          ///< overhung: material between the blind bore's end and the lower flange's top [m]
};

struct FeatureOptions {
    double anchor_hole_diameter = 2e-3;  ///< axial, on the groove's floor at cam.anchor_psi, to the top (anchor_leads_down); 0 = none
    double anchor_edge_radius = 0.0;     ///< of that hole's edge at the floor [m]: rounded by hand, not part of the solid
    double leg_slot_width = 0.0;         ///< K_SE: spring leg, wire plus clearance [m]; 0 = none
    double leg_slot_length = 0.0;        ///< radial [m]
    double leg_slot_radius = 0.0;        ///< its middle, from the axis [m]
    double leg_slot_depth = 0.0;         ///< from the top face [m]
    double leg_slot_angle = 3.1415926535897931;  ///< in the body frame [rad]
    double mark_width = 0.5e-3;                  ///< timing mark at body angle 0 on the top face [m]; 0 = none
    double mark_depth = 0.4e-3;                  ///< [m]
};

struct PartOptions {
    GrooveOptions groove;
    HubOptions hub;
    FeatureOptions features;
    double chordal_error = 2e-6;  ///< largest distance between mesh and analytic surface [m]
    double flange_height = 0.0;   ///< height of the flanges above the lips [m]; 0 = flush with the lips
    double dowel_diameter = 0.0;  ///< of two pins through milled half plates (pin_places) [m]; 0: one piece, or no pins
    double rim_width = 8e-3;      ///< of a roller cam: the plate's thickness, above two ribs [m]
};

/// One vertex rail of the section: at every psi a point at `offset` from the cable's centreline along n, `z` above the path's height.
struct SectionPoint {
    double offset_mm = 0.0;  ///< along n, from the pitch curve; the floor's bottom is at -d/2
    double z_mm = 0.0;       ///< from the path's height
};
/// The groove's section from the lower lip over the floor (its lowest point is a vertex) to the upper lip.
[[nodiscard]] std::vector<SectionPoint> groove_section(const GrooveOptions& groove, double cable_diameter, double chordal_error);
/// A roller cam's: the flat rim between the two ribs, with a vertex half-way up. @throws InvalidInput naming k_pe.roller.rim_width_mm
[[nodiscard]] std::vector<SectionPoint> rim_section(const PartOptions& options);

/// The solid of a part, with all data that exports and checks need.
struct Part {
    cam::Cam cam;
    PartOptions options;
    Mesh mesh;                          ///< finished: groove, hub, holes, slot, mark
    Mesh skin;                          ///< the same body without groove, bore and cutters (helix: the start of a CSG kernel)
    std::vector<double> columns_psi;    ///< psi of the sweep's columns, one turn (planar) or the whole groove (helix)
    std::vector<SectionPoint> section;  ///< of the groove
    double z_low = 0.0, z_high = 0.0;   ///< of the flanges' outer faces [m]; a boss reaches below z_low
    double chordal_error_mm = 0.0;      ///< stated and kept by the sweep
};

/// The part without meshes and columns, if its geometry is possible. A search calls this before it builds a solid. Refusals: "solid.turns",
/// "solid.floor", "solid.axis", "solid.anchor", "solid.bore", "solid.run_out". @throws InvalidInput naming the option
[[nodiscard]] core::Outcome<Part> outline_part(const cam::Cam& cam, const PartOptions& options);

/// Builds the solid: swept groove and faces meshed from the parametric surface, Booleans only for anchor hole, leg slot, mark and set
/// screw. Refusals: "solid.turns" (no land between turns), "solid.floor" (the groove's floor folds), "solid.axis" (the contour does not
/// enclose the axis), "solid.anchor" (too wide a hole), "solid.bore" (the bore breaks out), "solid.run_out" (the arms of a helix grow too
/// fast at the end of its groove), "solid.validity" (not closed, not one piece, or self-intersecting, with the place).
/// @throws InvalidInput naming the option
[[nodiscard]] core::Outcome<Part> build_part(const cam::Cam& cam, const PartOptions& options);

// Mirror images in the plane of the cam's axis and its timing mark, y -> -y (fusee/cam/mirror.h).

/// Points are reflected and triangles reversed, so that they still face outward.
[[nodiscard]] Mesh mirrored(const Mesh& mesh);
/// The leg slot's angle changes its sign; bore, key, flat, mark and set screw are their own images.
[[nodiscard]] PartOptions mirrored(const PartOptions& options);
/// The whole part, as `build_part` makes it from the mirrored cam and options, without a second build. Its mesh needs no second proof of
/// validity: reflection keeps every incidence and commutes with rounding to single precision.
[[nodiscard]] Part mirrored(const Part& part);

// Compensates files for the shrinkage of a process, so that the part comes out nominal. The design itself stays nominal.

/// Deviations of a process, measured on coupons (docs/theory/calibration.md).
struct Compensation {
    std::array<double, 3> shrink{};  ///< along x, y, z: a length L comes out as (1 - shrink) L; below 0: it grows
    double bore_offset = 0.0;        ///< loss of a bore's diameter besides shrinkage [m]
    [[nodiscard]] bool scales() const { return shrink != std::array<double, 3>{}; }
    [[nodiscard]] bool none() const { return !scales() && bore_offset == 0.0; }
};

/// The part with bore and key wider by `offset` [m]: each of their walls moves by half of it, nothing else moves.
/// Refusal: as build_part, if there is no space for the wider bore
[[nodiscard]] core::Outcome<Part> with_wider_bore(const Part& part, double offset);

/// The mesh to write so that the part comes out as `mesh`: every coordinate divided by (1 - shrink), rounded to single precision.
[[nodiscard]] Mesh grown(const Mesh& mesh, const std::array<double, 3>& shrink);

}  // namespace fusee::solid
