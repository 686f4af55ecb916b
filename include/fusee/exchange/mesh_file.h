#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "fusee/core/path.h"
#include "fusee/core/process.h"
#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// A build item of a 3MF: its triangles follow those of the item before.
struct MeshItem {
    std::string name;  ///< of its object; may be empty
    std::size_t triangles = 0;
};

/// A third-party mesh as it is in its file; nothing is repaired.
struct MeshFile {
    solid::Mesh mesh;                  ///< in millimetres; may be open or inside out, or have several bodies
    std::string unit;                  ///< as the file states it: "none, taken as millimetres", "inch", "millimetre (STEP)"
    std::vector<MeshItem> items = {};  ///< empty: the format has none
};

/// Per file; a file with more is refused.
inline constexpr std::size_t kMostTriangles = 5'000'000;
/// Per face of an OBJ file: the time in which assimp triangulates a face grows with the square of its corners.
inline constexpr std::size_t kMostCorners = 5'000;

/// Largest deviation of the tessellation of a STEP file from its surface.
inline constexpr double kTessellation_mm = 0.01, kTessellation_rad = 0.2;

/// Reads STL (binary or text) and OBJ with assimp, 3MF with lib3mf, STEP with OpenCASCADE; the ending of the file decides. Corners with the
/// same coordinates (single precision) become one point, except in 3MF, which has its own points. Reads all build items of a 3MF with their
/// components and transforms, and all solids and shells of a STEP file. Thread-safe. The libraries do not check files completely: use
/// read_mesh_isolated for a third-party file.
/// @throws core::InvalidInput naming the ending; core::IoError naming the file, and the line where it is text: missing, not a regular
///         file, larger than 1 GB, cut short, not of its format, without triangles or with more than kMostTriangles, a coordinate that is
///         not finite, a face that is not a polygon, a reference to an entity that is not in the file
[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& path);

/// Does `path` have an ending that read_mesh_file can read?
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& path);
/// All endings that read_mesh_file can read: ".stl", ...
[[nodiscard]] std::vector<std::string> mesh_endings();

/// The argument that makes the fusee program a reader: `fusee --read-mesh FILE` calls serve_mesh_file.
inline constexpr const char* kReadMesh = "--read-mesh";

/// Limits of the reader of this file. Time: 10 s and 30 s per megabyte, at most 10 minutes. Memory: 2 GiB and 20 bytes per byte of the
/// file.
[[nodiscard]] core::ChildLimits reader_limits(const std::filesystem::path& path);

/// Does the work of read_mesh_file in a separate process. If assimp, lib3mf or OpenCASCADE crashes, loops or uses all memory, only that
/// process ends (docs/decisions/0006-third-party-readers.md). Thread-safe.
/// @param reader the command of a program that calls serve_mesh_file; the path is appended to it: {"/usr/bin/fusee", "--read-mesh"}
/// @throws core::InvalidInput, core::IoError as read_mesh_file; core::IoError also if the reader crashes or reaches a limit, or if the
///         path is not a regular file
[[nodiscard]] MeshFile read_mesh_isolated(const std::filesystem::path& path, const std::vector<std::string>& reader);

/// The work of the reader: limits this process, reads the file and writes the mesh or the error to standard output, in a binary form that
/// only the same version reads. Once it has the bytes of that file it opens no other, whatever these refer to. Messages of libraries do not
/// reach standard output. @returns the exit code
int serve_mesh_file(const std::filesystem::path& path);

}  // namespace fusee::exchange
