#pragma once
#include <string>
#include <vector>

#include "fusee/drawing/sheet.h"

/// Symbols of tolerances, datums, roughness and edges, drawn.
namespace fusee::drawing {

enum class Symbol {
    kLineProfile,    ///< ISO 1101: profile of a line
    kPosition,       ///< ISO 1101: position
    kPerpendicular,  ///< ISO 1101: perpendicularity
    kRunout,         ///< ISO 1101: circular run-out
    kDatum,          ///< ISO 5459: a datum feature
    kRoughness,      ///< ISO 21920-1: surface texture, any process
    kRoughnessCut,   ///< the same, material removal required
    kEdge,           ///< ISO 13715: state of an edge
};

/// A symbol with its cells: value and datums of a tolerance frame, letter of a datum, "Ra 3.2", "-0.3".
struct Badge {
    Symbol symbol = Symbol::kDatum;
    std::vector<std::string> cells;
};

inline constexpr double kBadgeHeight = 6.4;  ///< [mm]
/// A tolerance frame. @param width of the zone [m] @param prefix of the value: the sign of a diameter
[[nodiscard]] Badge frame(Symbol symbol, double width, const std::vector<std::string>& datums, const std::string& prefix = "");
[[nodiscard]] double width_of(const Badge& badge);   ///< [mm]
[[nodiscard]] double height_of(const Badge& badge);  ///< [mm]
/// A datum's triangle stands with its base on the line above it, its box below (ISO 5459).
/// @param corner upper left
void draw_badge(Sheet& sheet, const Badge& badge, const Point& corner);

}  // namespace fusee::drawing
