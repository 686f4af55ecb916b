#pragma once
#include <cstddef>

class TopoDS_Shape;

namespace fusee::brep {

[[nodiscard]] std::size_t count_faces(const TopoDS_Shape& shape);
/// As any client of OpenCASCADE reads it: by its default integral, with at most 61 Gauss points over a whole face in each direction.
[[nodiscard]] double volume_mm3(const TopoDS_Shape& shape);
/// Exactly one solid that is valid by BRepCheck. (For BRepCheck an empty shape is valid too.)
[[nodiscard]] bool is_one_solid(const TopoDS_Shape& shape);

}  // namespace fusee::brep
