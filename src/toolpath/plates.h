#pragma once
#include <string>
#include <vector>

#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"
#include "fusee/toolpath/settings.h"

namespace fusee::toolpath {

/// A vertical wall around a plate: from the foot of the one above down to `bottom`.
struct Wall {
    std::vector<solid::Arc> ring;  ///< as seen from the spindle, about the cam's axis [mm]
    double bottom = 0.0;           ///< below the stock's top [mm]
};

/// The cuts in one clamping from one face.
struct Plate {
    std::string name;
    bool turned_over = false;  ///< the part's lower side is up, turned about its x axis
    std::vector<Wall> walls;   ///< from the top down, each as wide as the one above or wider
    double thickness = 0.0;    ///< [mm]
    double bore_radius = 0.0;  ///< [mm]; 0 = none
    double bore_depth = 0.0;   ///< [mm]
    bool in_sheet = true;      ///< else it stands on its boss
    [[nodiscard]] bool bored_through() const { return bore_depth >= thickness; }
};

/// The two halves of a planar part, split in the groove's plane, which is the stock's top. The depth of a terrace is that of
/// the groove at its upper edge: no material remains inside the nominal groove, and the first terrace has the floor's radius.
[[nodiscard]] std::vector<Plate> half_plates(const solid::Part& part, const Settings& settings);
/// The planar part without its groove and its boss.
[[nodiscard]] Plate blank_plate(const solid::Part& part, const Settings& settings);
[[nodiscard]] Plate boss_plate(const solid::Part& part, const Settings& settings);

}  // namespace fusee::toolpath
