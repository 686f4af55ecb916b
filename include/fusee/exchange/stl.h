#pragma once
#include <filesystem>
#include <string>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// Writes binary STL: millimetres, normals from the vertices, coordinates rounded to single precision. Equal meshes give equal bytes.
/// @param provenance stored in the 80-byte header, cut to its length
/// @throws InvalidInput if `provenance` begins with "solid" (readers would take the file for text STL) or a triangle names a missing point
/// @throws IoError
void write_stl(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& provenance);

/// Reads binary STL with assimp. STL has no unit: the numbers are taken as millimetres. Corners with the same coordinates become one point;
/// nothing is repaired.
/// @throws IoError naming the file: unreadable, longer or shorter than its count of triangles, not finite, or empty
[[nodiscard]] solid::Mesh read_stl_assimp(const std::filesystem::path& path);

/// Reads the same file with OpenMesh, whose half-edge structure allows only manifold surfaces.
/// @throws IoError as read_stl_assimp, and if the surface is not manifold
[[nodiscard]] solid::Mesh read_stl_openmesh(const std::filesystem::path& path);

}  // namespace fusee::exchange
