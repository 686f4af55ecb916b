#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"

/// A planar part as plates that are cut through and stacked: the groove opens sideways and is no undercut then (docs/theory/cams.md).
namespace fusee::solid {

/// Diameter of the two pins that hold the plates of a stack in line [mm].
inline constexpr double kDowel_mm = 2.0;

/// Where two opposite dowels have the most room between the bore, the groove's floor and all that is cut through the plates.
struct Dowels {
    std::array<Point2, 2> centres_mm{};
    double room_mm = 0.0;  ///< diameter of the largest circle about the tighter one that meets nothing; not above 0: there is no room
};
/// @pre a planar part
[[nodiscard]] Dowels place_dowels(const Part& part);

/// An opening through a plate.
struct Opening {
    std::string name;  ///< "bore", "anchor", "leg_slot", "dowel"
    Outline outline;
};

/// One plate of a stack, by rising height.
struct Plate {
    std::string name;               ///< "lower flange", "core", "upper flange"
    double thickness_mm = 0.0;      ///< core: the groove's width
    double offset_mm = 0.0;         ///< of its outline from the pitch curve; core: -d/2, the groove's floor
    std::vector<Opening> openings;  ///< in the core the anchor's hole crosses the outline: it opens into the groove
};

/// Thickness of the plate that carries the groove's floor [m]: groove.plate, or two floor radii.
[[nodiscard]] double core_thickness(const Part& part);
/// The three plates; no dowels where they have no room. @pre a planar part for a cable, without a boss
[[nodiscard]] std::vector<Plate> stack_plates(const Part& part);
/// The same opening, every edge moved inwards by `inset_mm`; nothing where it closes. @pre no corners, as of circle and stadium
[[nodiscard]] std::optional<Outline> inset(const Outline& outline, double inset_mm);

}  // namespace fusee::solid
