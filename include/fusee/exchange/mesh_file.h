#pragma once
#include <filesystem>
#include <string>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// A part by anybody, as its file has it: nothing is repaired.
struct MeshFile {
    solid::Mesh mesh;  ///< in millimetres; may be open, inside out, several bodies
    std::string unit;  ///< what the file says of it: "none, taken as millimetres", "inch", "millimetre (STEP)"
};

/// How far the tessellation of a STEP file may leave its surface.
inline constexpr double kTessellation_mm = 0.01, kTessellation_rad = 0.2;

/// Reads STL (binary or text) and OBJ by assimp, 3MF by lib3mf, STEP by OpenCASCADE, told apart by the file's ending. Corners with the same
/// coordinates (single precision) become one point, but for 3MF, which says itself which corners are one. All build items of a 3MF with
/// their components and transforms, all solids and shells of a STEP file. Thread-safe.
/// @throws core::InvalidInput naming the ending; core::IoError naming the file: missing, cut short, not of its format, without triangles,
///         a coordinate that is not finite, a face that is no polygon
[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& path);

/// Has `path` an ending that read_mesh_file knows?
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& path);

}  // namespace fusee::exchange
