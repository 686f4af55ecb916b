#pragma once
#include <filesystem>
#include <string>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// Writes binary STL: millimetres, normals from the vertices, coordinates rounded to single precision. Equal meshes give equal bytes.
/// @param provenance goes into the 80-byte header, cut to its length
/// @throws InvalidInput if `provenance` begins with "solid", by which readers know text STL, or a triangle names a missing point
/// @throws IoError
void write_stl(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& provenance);

/// Reads binary STL with assimp; STL has no unit, so what it holds is taken as millimetres. Corners with the same coordinates become one
/// point; nothing is repaired.
/// @throws IoError naming the file: unreadable, cut short, longer than it says, not finite, or empty
[[nodiscard]] solid::Mesh read_stl_assimp(const std::filesystem::path& path);

/// The same file with OpenMesh, whose half-edge structure takes manifold surfaces only.
/// @throws IoError as read_stl_assimp, and if the surface is not manifold
[[nodiscard]] solid::Mesh read_stl_openmesh(const std::filesystem::path& path);

}  // namespace fusee::exchange
