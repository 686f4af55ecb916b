#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// A third-party part, as its file has it: nothing is repaired.
struct MeshFile {
    solid::Mesh mesh;  ///< in millimetres; may be open, inside out, several bodies
    std::string unit;  ///< what the file says of it: "none, taken as millimetres", "inch", "millimetre (STEP)"
};

/// Of a file; more are refused.
inline constexpr std::size_t kMostTriangles = 5'000'000;
/// Corners of one face of an OBJ file: assimp cuts faces into triangles in a time that grows with the square of their corners.
inline constexpr std::size_t kMostCorners = 5'000;

/// How far the tessellation of a STEP file may leave its surface.
inline constexpr double kTessellation_mm = 0.01, kTessellation_rad = 0.2;

/// Reads STL (binary or text) and OBJ by assimp, 3MF by lib3mf, STEP by OpenCASCADE, told apart by the file's ending. Corners with the same
/// coordinates (single precision) become one point, but for 3MF, which says itself which corners are one. All build items of a 3MF with
/// their components and transforms, all solids and shells of a STEP file. Thread-safe. The libraries trust files more than they should: for
/// a third-party file use read_mesh_isolated.
/// @throws core::InvalidInput naming the ending; core::IoError naming the file, and the line where it is text: missing, no regular file,
///         larger than 1 GB, cut short, not of its format, without triangles or with more than kMostTriangles, a coordinate that is not
///         finite, a face that is no polygon, a reference to what the file does not hold
[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& path);

/// Has `path` an ending that read_mesh_file knows?
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& path);
/// ".stl" and the others.
[[nodiscard]] std::vector<std::string> mesh_endings();

}  // namespace fusee::exchange
