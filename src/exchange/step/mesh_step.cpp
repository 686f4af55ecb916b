#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "fusee/core/error.h"
#include "kernel.h"
#include "step_shape.h"
#include "weld.h"

namespace fusee::exchange {

namespace {

/// The triangles of one face, with the orientation of the face.
void append(Welder& welder, const TopoDS_Face& face, const std::filesystem::path& path) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull()) throw core::IoError(path.string(), "OpenCASCADE cannot tessellate one of its faces");
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        std::array<int, 3> node{};
        mesh->Triangle(i).Get(node[0], node[1], node[2]);
        if (face.Orientation() == TopAbs_REVERSED) std::swap(node[1], node[2]);
        solid::Triangle t{};
        for (std::size_t k = 0; k < 3; ++k) {
            const gp_Pnt p = mesh->Node(node[k]).Transformed(location);
            t[k] = welder.index({static_cast<float>(p.X()), static_cast<float>(p.Y()), static_cast<float>(p.Z())});
        }
        welder.mesh().triangles.push_back(t);
    }
}

}  // namespace

MeshFile read_step_mesh(const std::filesystem::path& path, const std::string& bytes) {
    Welder welder;
    with_step_shape(path, bytes, [&](const TopoDS_Shape& shape, const STEPControl_Reader&) {
        const BRepMesh_IncrementalMesh tessellation(shape, kTessellation_mm, false, kTessellation_rad);
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) append(welder, TopoDS::Face(face.Current()), path);
    });
    return {std::move(welder.mesh()), "millimetre (STEP)"};
}

}  // namespace fusee::exchange
