#include "hub.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "fusee/core/units.h"

namespace fusee::exchange::brep {

namespace {

using core::mm_from_m;

constexpr double kSame_mm = 1e-9;  // an arc that ends at the start of the next one needs no line between them

gp_Pnt raised(const solid::Point2& p, double z_mm) { return {p[0], p[1], z_mm}; }

TopoDS_Edge edge_of(const solid::Arc& arc, double z_mm) {
    const gp_Circ round(gp_Ax2(raised(arc.centre_mm, z_mm), gp_Dir(0.0, 0.0, 1.0)), arc.radius_mm);
    if (arc.full()) return BRepBuilderAPI_MakeEdge(round);
    return BRepBuilderAPI_MakeEdge(round, arc.begin, arc.end);
}

TopoDS_Wire wire_of(const solid::Outline& outline, double z_mm) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const solid::Arc &arc = outline[i], &next = outline[(i + 1) % outline.size()];
        if (arc.radius_mm > 0.0) wire.Add(edge_of(arc, z_mm));
        const gp_Pnt from = raised(arc.at(arc.end), z_mm), to = raised(next.at(next.begin), z_mm);
        if (!arc.full() && from.Distance(to) > kSame_mm) wire.Add(BRepBuilderAPI_MakeEdge(from, to));
    }
    return wire.Wire();
}

/// A flat face at the wire's height with holes; sewing and orienting the solid correct its direction.
TopoDS_Face flat(const TopoDS_Wire& outer, double z_mm, const std::vector<TopoDS_Wire>& holes = {}) {
    BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0.0, 0.0, z_mm), gp_Dir(0.0, 0.0, 1.0)), outer);
    for (const TopoDS_Wire& hole : holes) face.Add(TopoDS::Wire(hole.Reversed()));
    return face.Face();
}

TopoDS_Shape wall(const solid::Outline& outline, double low_mm, double high_mm) {
    return BRepPrimAPI_MakePrism(wire_of(outline, low_mm), gp_Vec(0.0, 0.0, high_mm - low_mm)).Shape();
}

}  // namespace

std::vector<TopoDS_Shape> closing_faces(const Side& side, const solid::HubOptions& hub) {
    const bool boss = hub.boss_height > 0.0, through = hub.kind == solid::HubKind::kThrough;
    const double z_boss = side.z_low_mm - (boss ? mm_from_m(hub.boss_height) : 0.0);
    const double z_end = through ? side.z_high_mm : side.lower_lip_mm - mm_from_m(hub.web);
    const solid::Outline bore = solid::bore_outline(hub), rim = solid::circle(mm_from_m(0.5 * hub.boss_diameter));
    std::vector<TopoDS_Shape> faces{wall(bore, z_boss, z_end)};
    if (boss) {
        faces.push_back(flat(side.lower_rim, side.z_low_mm, {wire_of(rim, side.z_low_mm)}));
        faces.push_back(wall(rim, z_boss, side.z_low_mm));
        faces.push_back(flat(wire_of(rim, z_boss), z_boss, {wire_of(bore, z_boss)}));
    } else {
        faces.push_back(flat(side.lower_rim, side.z_low_mm, {wire_of(bore, z_boss)}));
    }
    if (through) {
        faces.push_back(flat(side.upper_rim, side.z_high_mm, {wire_of(bore, z_end)}));
    } else {
        faces.push_back(flat(wire_of(bore, z_end), z_end));
        faces.push_back(flat(side.upper_rim, side.z_high_mm));
    }
    return faces;
}

TopoDS_Shape prism(const solid::Outline& outline, const std::vector<solid::Outline>& holes, double low_mm, double high_mm) {
    std::vector<TopoDS_Wire> inner;
    for (const solid::Outline& hole : holes) inner.push_back(wire_of(hole, low_mm));
    return BRepPrimAPI_MakePrism(flat(wire_of(outline, low_mm), low_mm, inner), gp_Vec(0.0, 0.0, high_mm - low_mm)).Shape();
}

TopoDS_Shape prism(const solid::Cutter& cutter) {
    const TopoDS_Shape upright = prism(cutter.outline, {}, cutter.low_mm, cutter.high_mm);
    if (!cutter.radial) return upright;
    gp_Trsf cycle;  // (y, z, x) to (x, y, z)
    cycle.SetValues(0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0);
    return BRepBuilderAPI_Transform(upright, cycle).Shape();
}

}  // namespace fusee::exchange::brep
