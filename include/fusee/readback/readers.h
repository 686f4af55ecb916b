#pragma once
#include <string>

#include "fusee/exchange/stl.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {

// Readers of the files that carry the law: they find the floor of the groove, turn the body to each working angle, lay a taut cable from
// the guide (the tangent of largest moment) and add half a cable.

/// Of a mesh: horizontal rays from the axis find the floor.
/// @param reader name of the library that read the mesh
/// @throws IoError if the mesh does not have the stated number of triangles
[[nodiscard]] ArmError compare_mesh(const LawFile& file, const std::string& reader, const solid::Mesh& mesh);

[[nodiscard]] std::vector<ArmError> read_stl(const LawFile& file);  ///< with assimp and OpenMesh
[[nodiscard]] std::vector<ArmError> read_3mf(const LawFile& file);  ///< with lib3mf
[[nodiscard]] std::vector<ArmError> read_drawing(
    const LawFile& file);  ///< DXF with dxflib: polylines and splines; a flange without a groove has none
[[nodiscard]] std::vector<ArmError> read_step(const LawFile& file);  ///< with OpenCASCADE
/// G-code: the floor is what the cutter leaves by the moves that LinuxCNC's interpreter makes of it. None without `rs274` on PATH.
/// @throws IoError also if the moves are not safe (toolpath::faults)
[[nodiscard]] std::vector<ArmError> read_program(const LawFile& file);
/// A slicer's G-code: the cable lies on the beads near its height. Off by the steps of the layers, which a person has to accept
/// (docs/theory/read_back.md, eq. 6).
[[nodiscard]] std::vector<ArmError> read_print(const LawFile& file);

}  // namespace fusee::readback
