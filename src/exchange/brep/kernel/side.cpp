#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gce_MakeCirc.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/stack.h"
#include "fusee/solid/sweep.h"
#include "strip.h"

namespace fusee::exchange::brep {

namespace {

using core::kTurn;
using core::mm_from_m;
using solid::Vec3;

constexpr int kArcs = 2;  // across the groove's floor

/// The groove's section as rails: lips, flanks and the floor's arc.
class Section {
public:
    explicit Section(const solid::Part& part) : cam_(part.cam), lip_(part.section.back()), flat_(part.cam.has_roller()) {
        const solid::GrooveOptions& groove = part.options.groove;
        half_cable_ = 0.5 * mm_from_m(cam_.options.cable_diameter);
        radius_ = 2.0 * half_cable_ * groove.radius_ratio;
        sweep_ = 0.5 * (core::kPi - groove.throat);  // half angle of the arc, which meets the flanks tangentially
        square_ = solid::is_stack(part.cam, part.options);
    }
    [[nodiscard]] Rail lower_lip() const { return at(lip_.offset_mm, -lip_.z_mm); }
    [[nodiscard]] Rail upper_lip() const { return at(lip_.offset_mm, lip_.z_mm); }
    [[nodiscard]] bool flat() const { return flat_; }      ///< a rim for a roller, without a groove
    [[nodiscard]] bool square() const { return square_; }  ///< a stack of plates: the floor is flat
    [[nodiscard]] double half_arc() const { return sweep_ / kArcs; }
    /// Ends of the arcs, and between them the corners of their tangents; of a stack both corners.
    [[nodiscard]] std::vector<Rail> floor() const {
        if (square_) return {at(-half_cable_, -lip_.z_mm), at(-half_cable_, lip_.z_mm)};
        std::vector<Rail> rails;
        for (int i = 0; i <= 2 * kArcs; ++i) {
            const double angle = -sweep_ + half_arc() * i, r = i % 2 == 0 ? radius_ : radius_ / std::cos(half_arc());
            rails.push_back(at(radius_ - r * std::cos(angle) - half_cable_, r * std::sin(angle)));
        }
        return rails;
    }

private:
    [[nodiscard]] Rail at(double offset_mm, double z_mm) const {
        return [this, offset_mm, z_mm](double psi) {
            const cam::PathPoint path = cam_.path(psi);
            const solid::Point2 p = solid::flange_point(path, offset_mm, 0.0).point;
            return Vec3{p[0], p[1], mm_from_m(path.z) + z_mm};
        };
    }
    const cam::Cam& cam_;
    solid::SectionPoint lip_;
    bool flat_, square_ = false;
    double half_cable_ = 0.0, radius_ = 0.0, sweep_ = 0.0;
};

void add_groove(std::vector<Strip>& strips, const Section& section) {
    if (section.flat()) return strips.push_back(ruled(section.lower_lip(), section.upper_lip()));
    const std::vector<Rail> floor = section.floor();
    strips.push_back(ruled(section.lower_lip(), floor.front()));
    strips.push_back(section.square() ? ruled(floor.front(), floor.back()) : arcs(floor, section.half_arc()));
    strips.push_back(ruled(floor.back(), section.upper_lip()));
}

void add_ruled(std::vector<Strip>& strips, const std::vector<Rail>& rails) {
    for (std::size_t i = 0; i + 1 < rails.size(); ++i) strips.push_back(ruled(rails[i], rails[i + 1]));
}

/// A column maker's rail number `k`, of the lower or the upper flange.
Rail flange_rail(const solid::ColumnMaker& maker, bool upper, std::size_t k) {
    return [&maker, upper, k](double psi) { return (upper ? maker.upper_rails(psi) : maker.lower_rails(psi))[k]; };
}
std::vector<Rail> flange_rails(const solid::ColumnMaker& maker, bool upper) {
    std::vector<Rail> rails;
    const std::size_t count = (upper ? maker.upper_rails(0.0) : maker.lower_rails(0.0)).size();
    for (std::size_t k = 0; k < count; ++k) rails.push_back(flange_rail(maker, upper, k));
    return rails;
}

/// Faces of strips over one range of psi, with common nodes for all their rails.
Nodes add_faces(Side& side, const cam::Cam& cam, const std::vector<Strip>& strips, core::Range psi) {
    std::vector<Rail> rails;
    for (const Strip& strip : strips) rails.insert(rails.end(), strip.rails.begin(), strip.rails.end());
    const Nodes nodes = nodes_for(rails, psi, allowed_mm(cam));
    for (const Strip& strip : strips) side.faces.push_back(face_of(strip, nodes));
    for (const Rail& rail : rails)
        for (const double deviation : deviations_mm(rail, nodes)) side.deviation_mm = std::max(side.deviation_mm, deviation);
    return nodes;
}

Side planar_side(const solid::Part& part, const solid::ColumnMaker& maker, int idle_pieces) {
    const Section section(part);
    std::vector<Rail> lower = flange_rails(maker, false), upper = flange_rails(maker, true);
    lower.push_back(section.lower_lip());
    upper.insert(upper.begin(), section.upper_lip());
    std::vector<Strip> strips;
    add_ruled(strips, lower);
    add_groove(strips, section);
    add_ruled(strips, upper);
    Side side;
    BRepBuilderAPI_MakeWire low, high;
    for (const core::Range& psi : smooth_pieces(part.cam, idle_pieces)) {
        const Nodes nodes = add_faces(side, part.cam, strips, psi);
        low.Add(BRepBuilderAPI_MakeEdge(spline(lower.front(), nodes)));
        high.Add(BRepBuilderAPI_MakeEdge(spline(upper.back(), nodes)));
    }
    side.lower_rim = low.Wire();
    side.upper_rim = high.Wire();
    return side;
}

/// The lips of a helix along its groove and, beyond it, along the run-out to the flanges' edges.
Rail lip_of(const solid::Part& part, const solid::ColumnMaker& maker, bool upper) {
    return [&part, &maker, upper](double psi) {
        if (part.cam.groove_psi.holds(psi)) {
            const std::vector<Vec3> section = maker.section_at(psi);
            return upper ? section.back() : section.front();
        }
        const solid::ColumnMaker::Lips lips = maker.run_out(psi);
        return upper ? lips.upper : lips.lower;
    };
}

Rail a_turn_on(Rail rail) {
    return [rail = std::move(rail)](double psi) { return rail(psi + kTurn); };
}

/// The flat end of a groove: flanks, floor and the land's edge from lip to lip.
TopoDS_Face groove_end(const Section& section, double psi) {
    std::vector<gp_Pnt> floor;
    for (const Rail& rail : section.floor()) floor.push_back(point(rail(psi)));
    const gp_Pnt lower = point(section.lower_lip()(psi)), upper = point(section.upper_lip()(psi));
    BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(lower, floor.front()).Edge());
    const gp_Circ round = gp_Circ(gce_MakeCirc(floor[0], floor[kArcs], floor.back()).Value());
    wire.Add(BRepBuilderAPI_MakeEdge(round, floor.front(), floor.back()).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(floor.back(), upper).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(upper, lower).Edge());
    return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

/// Sewing divides edges that meet others half-way. A strip begins and ends in a point where a lip leaves its flange.
Side helix_side(const solid::Part& part, const solid::ColumnMaker& maker) {
    const core::Range reach = maker.reach(), groove = part.cam.groove_psi;
    const Section section(part);
    const std::vector<Rail> low = flange_rails(maker, false), high = flange_rails(maker, true);
    const Rail lower = lip_of(part, maker, false), upper = lip_of(part, maker, true);
    Side side;
    const double turn_on = reach.low + kTurn, turn_back = reach.high - kTurn;
    const auto add_land = [&](const Rail& from, const Rail& to, core::Range psi, double high_corner) {
        for (const core::Range& piece : divided(psi, {groove.low, high_corner})) add_faces(side, part.cam, {ruled(from, to)}, piece);
    };  // lips have corners where the groove ends
    add_land(low.back(), lower, {reach.low, std::min(turn_on, reach.high)}, groove.high);
    add_land(upper, high.front(), {std::max(reach.low, turn_back), reach.high}, groove.high);
    if (turn_back > reach.low)
        add_land(upper, a_turn_on(lower), {reach.low, turn_back}, groove.high - kTurn);
    else
        add_land(low.back(), high.front(), {reach.high, turn_on}, groove.high);
    add_land(lower, upper, {reach.low, groove.low}, groove.high);
    add_land(lower, upper, {groove.high, reach.high}, groove.high);
    std::vector<Strip> strips;
    add_groove(strips, section);
    add_faces(side, part.cam, strips, groove);
    for (const double psi : {groove.low, groove.high}) side.faces.push_back(groove_end(section, psi));
    const Nodes nodes = add_faces(side, part.cam, {ruled(low[0], low[1]), ruled(high[0], high[1])}, {reach.low, turn_on});
    side.lower_rim = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline(low[0], nodes)).Edge()).Wire();
    side.upper_rim = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline(high[1], nodes)).Edge()).Wire();
    return side;
}

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

Side side_of(const solid::Part& part, int idle_pieces) {
    const solid::Flanges flanges = solid::flanges_of(part.options);
    const solid::ColumnMaker maker(part.cam, part.section, flanges);
    Side side = part.cam.closed() ? planar_side(part, maker, idle_pieces) : helix_side(part, maker);
    side.z_low_mm = maker.z_low_mm();
    side.z_high_mm = maker.z_high_mm();
    side.lower_lip_mm = side.z_low_mm + flanges.rib_mm;
    return side;
}

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
