#include "measure.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>

namespace fusee::exchange::brep {

namespace {

std::size_t count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    std::size_t count = 0;
    for (TopExp_Explorer at(shape, kind); at.More(); at.Next()) ++count;
    return count;
}

}  // namespace

std::size_t count_faces(const TopoDS_Shape& shape) { return count_of(shape, TopAbs_FACE); }

TopoDS_Shape solids_of(const TopoDS_Shape& shape) {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    std::size_t count = 0;
    TopoDS_Shape last;
    for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next(), ++count) builder.Add(all, last = at.Current());
    return count == 1 ? last : TopoDS_Shape(all);
}

std::size_t count_solids(const TopoDS_Shape& shape) { return count_of(shape, TopAbs_SOLID); }

double volume_mm3(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

bool is_one_solid(const TopoDS_Shape& shape) { return is_valid(shape) && count_solids(shape) == 1; }

bool is_valid(const TopoDS_Shape& shape) { return !shape.IsNull() && count_solids(shape) > 0 && BRepCheck_Analyzer(shape).IsValid(); }

solid::Box bounding_box(const TopoDS_Shape& shape) {
    Bnd_Box found;
    BRepBndLib::AddOptimal(shape, found, false, false);
    const gp_Pnt low = found.CornerMin(), high = found.CornerMax();
    return {{low.X(), low.Y(), low.Z()}, {high.X(), high.Y(), high.Z()}};
}

double common_volume_mm3(const TopoDS_Shape& a, const TopoDS_Shape& b) { return volume_mm3(BRepAlgoAPI_Common(a, b).Shape()); }

gp_Trsf transform_of(const Eigen::Isometry3d& placement) {
    const Eigen::Matrix4d& m = placement.matrix();
    gp_Trsf to;
    to.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0), m(2, 1), m(2, 2), m(2, 3));
    return to;
}

}  // namespace fusee::exchange::brep
