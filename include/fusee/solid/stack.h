#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"

/// A planar part as a stack of plates that are cut through. Then the groove is no undercut (docs/theory/cams.md).
namespace fusee::solid {

/// Is the part cut from sheet, as plates that meet at square corners?
[[nodiscard]] bool is_stack(const cam::Cam& cam, const PartOptions& options);
/// The groove's section between its plates: lips, corners of the floor, and a vertex half-way up. @pre is_stack
[[nodiscard]] std::vector<SectionPoint> stack_section(const cam::Cam& cam, const PartOptions& options);

/// Diameter of the two pins that align the plates of a stack [mm].
inline constexpr double kDowel_mm = 2.0;
/// So much less the plates' holes are cut: both are reamed through the clamped stack [mm].
inline constexpr double kReamed_mm = 0.2;

/// The places of two opposite dowels with the most space between the bore, the groove's floor and all openings of the plates.
struct Dowels {
    std::array<Point2, 2> centres_mm{};
    double space_mm = 0.0;  ///< diameter of the largest free circle around the tighter one; not above 0: there is no space
};
/// @pre a planar part
[[nodiscard]] Dowels place_dowels(const Part& part);

/// An opening through a plate.
struct Opening {
    std::string name;  ///< "bore", "anchor", "leg_slot", "dowel"
    Outline outline;
};

/// One plate of a stack; plates are sorted by height.
struct Plate {
    std::string name;               ///< "lower flange", "core", "upper flange"
    double thickness_mm = 0.0;      ///< core: the groove's width
    double offset_mm = 0.0;         ///< of its outline from the pitch curve; core: -d/2, the groove's floor
    std::vector<Opening> openings;  ///< the anchor's hole crosses the outline of the core: it opens into the groove
};

/// Thickness of the plate that carries the groove's floor [m]: groove.plate, or two floor radii.
[[nodiscard]] double core_thickness(const Part& part);
/// The three plates; no dowels where there is no space for them. @pre a planar part for a cable, without a boss
[[nodiscard]] std::vector<Plate> stack_plates(const Part& part);
/// The same opening with every edge moved inwards by `inset_mm`; nothing if it closes. @pre no corners, as of circle and stadium
[[nodiscard]] std::optional<Outline> inset(const Outline& outline, double inset_mm);

}  // namespace fusee::solid
