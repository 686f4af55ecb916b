#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "fusee/drawing/drawing.h"
#include "fusee/solid/extrusion.h"

namespace fusee::drawing {

/// A round hole of a body, along its axis.
struct BodyHole {
    Eigen::Vector3d from_mm, to_mm;  ///< its ends, `from` with the larger coordinate
    double radius_mm = 0.0;
};

/// A body beside the cams: touching shapes whose axes are along x, y or z.
struct SheetBody {
    std::vector<solid::Extrusion> shapes;  ///< in its own frame
    std::string title;                     ///< "bracket of the frame"
    std::string axis;                      ///< its z axis: "the joint's axis"
    /// What a hole is for, with its fit: "bearing seat, H7"
    std::function<std::string(const BodyHole&)> use;
    double chordal_mm = 0.0;  ///< of its mesh
    std::vector<std::string> notes = {};
    bool locked = false;  ///< shapes with a bore have the keyway or flat of the subject's hub
};

/// Its round holes, each once where touching shapes continue it, in the order of the sheet's table: along z, then along y.
[[nodiscard]] std::vector<BodyHole> holes_of(const std::vector<solid::Extrusion>& shapes);

/// The body on one A3 sheet, first angle: from -y, from above below that, overall sizes and the table of its holes, which are numbered
/// where they are seen round. Places are from its middle plane (x), from its z axis or else its face towards the joint (y), and from its
/// upper face (z) [mm].
/// @param subject process, design, title block and the hub whose bore the body has; its name is the body's
[[nodiscard]] Sheet draw_sheet(const Subject& subject, const SheetBody& body);

}  // namespace fusee::drawing
