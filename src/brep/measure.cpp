#include "fusee/brep/measure.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>

namespace fusee::brep {

namespace {

std::size_t count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    std::size_t count = 0;
    for (TopExp_Explorer at(shape, kind); at.More(); at.Next()) ++count;
    return count;
}

}  // namespace

std::size_t count_faces(const TopoDS_Shape& shape) { return count_of(shape, TopAbs_FACE); }

double volume_mm3(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

bool is_one_solid(const TopoDS_Shape& shape) {
    return !shape.IsNull() && count_of(shape, TopAbs_SOLID) == 1 && BRepCheck_Analyzer(shape).IsValid();
}

}  // namespace fusee::brep
