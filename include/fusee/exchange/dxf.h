#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/exchange/brep.h"
#include "fusee/solid/extrusion.h"
#include "fusee/solid/part.h"

namespace fusee::exchange {

using Vec2 = std::array<double, 2>;

/// Chordal error of `spool_drawing` [mm].
inline constexpr double kDrawingChord_mm = 1e-3;

struct DxfPolyline {
    std::vector<Vec2> points_mm;
    bool closed = true;
};
struct DxfCircle {
    Vec2 centre_mm{};
    double radius_mm = 0.0;
};
/// Counter-clockwise.
struct DxfArc {
    Vec2 centre_mm{};
    double radius_mm = 0.0, begin_deg = 0.0, end_deg = 0.0;
};
struct DxfLine {
    Vec2 from_mm{}, to_mm{};
};
struct DxfLayer {
    std::string name;
    std::vector<DxfPolyline> polylines;
    std::vector<DxfCircle> circles;
    std::vector<brep::PlaneSpline> splines = {};
    std::vector<DxfArc> arcs = {};
    std::vector<DxfLine> lines = {};
};

/// A flat drawing in millimetres.
struct DxfDrawing {
    std::vector<DxfLayer> layers;
    std::string provenance;  ///< stored as a comment (group 999)
    /// The layer with this name, or nullptr.
    [[nodiscard]] const DxfLayer* layer(const std::string& name) const;
};

/// Writes DXF R2000 with dxflib: LWPOLYLINE, CIRCLE, ARC, LINE and SPLINE on named layers, $INSUNITS 4 (mm), each number with the shortest
/// digits that give it back, in any locale. @throws IoError
void write_dxf(const std::filesystem::path& path, const DxfDrawing& drawing);
/// Reads such a file with dxflib; ignores other kinds of entities.
/// @throws IoError naming the file: unreadable, cut short, not in millimetres, or a number that is not finite
[[nodiscard]] DxfDrawing read_dxf(const std::filesystem::path& path);

/// The outlines of a part seen from +z: layers PITCH (cable centreline), FLOOR (floor of the groove), FLANGE (outer edge), LOWER_FLANGE (if
/// a boss widens it) and MARK (timing mark, a line at body angle 0 up to the outer edge), as polylines with a chordal error below 1
/// micrometre; PIVOT, of a roller on an arm, a cross of two lines in the arm's pivot at cam angle 0; BORE (with keyway or flat), ANCHOR
/// (hole of the cable's end) and LEG_SLOT, if the part has them, as circles or as closed chains of arcs and lines: a polyline with bulges
/// is exact too, but OpenSCAD ignores it. PITCH_SPLINE, FLOOR_SPLINE and FLANGE_SPLINE are the same curves as splines, within 0.0002 mm, a
/// rim for a roller within 0.00001 mm. A helix has open PITCH and FLOOR and a round FLANGE. Nominal: kerf is not applied.
[[nodiscard]] DxfDrawing spool_drawing(const solid::Part& part, const std::string& provenance);
/// @throws InvalidInput naming outputs.kerf_mm if the bore or its keyway would close
void require_kerf(double kerf_mm, const solid::HubOptions& hub);
/// The path of a beam or wire of width `kerf_mm`: FLANGE moved outwards and BORE inwards by half the width. It has no other layer, so that
/// nobody confuses it with the nominal drawing.
/// @throws InvalidInput as require_kerf
[[nodiscard]] DxfDrawing kerf_drawing(const solid::Part& part, double kerf_mm, const std::string& provenance);

/// The plates of a stack (solid/stack.h), lowest first, one drawing per plate. Every line is cut through, except MARK. The outline of the
/// core is on the layer FLOOR (the floor of the groove) and on FLOOR_SPLINE; that of a flange is on FLANGE and FLANGE_SPLINE. Openings:
/// BORE, DOWEL, ANCHOR, LEG_SLOT. The number of ticks in MARK is the number of the plate from below; the first tick is at body angle 0. In
/// the core, ANCHOR crosses FLOOR: it opens into the groove and is cut first. Polylines stay within `kDrawingChord_mm`.
/// @pre a planar part for a cable, without a boss
[[nodiscard]] std::vector<DxfDrawing> stack_drawings(const solid::Part& part, const std::string& provenance);
/// The path of a beam or wire of width `kerf_mm`: outlines moved outwards and openings inwards by half the width. No other layers.
/// @throws InvalidInput naming outputs.kerf_mm if an opening would close
[[nodiscard]] std::vector<DxfDrawing> stack_kerf_drawings(const solid::Part& part, double kerf_mm, const std::string& provenance);

/// A flat plate seen from +z of its frame: the outline on the layer OUTLINE, round holes on a layer for each diameter [mm]: HOLE_3.4.
[[nodiscard]] DxfDrawing plate_drawing(const solid::Extrusion& plate, const std::string& provenance);

}  // namespace fusee::exchange
