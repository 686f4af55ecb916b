#pragma once
#include <optional>

#include "fusee/solid/mesh.h"

class TopoDS_Shape;

namespace fusee::exchange {

/// The triangles of a body that BRepMesh has tessellated, with one point for each vertex and each node of an edge. Faces share these, so
/// that the mesh is connected as the B-rep is; no point is found by its coordinates. Seams and degenerate edges (poles, apexes) are closed.
/// @returns nothing if a face has no triangulation
[[nodiscard]] std::optional<solid::Mesh> mesh_of_body(const TopoDS_Shape& body);

}  // namespace fusee::exchange
