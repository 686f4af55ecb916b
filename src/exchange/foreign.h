#pragma once
#include <string>

#include "fusee/exchange/mesh_file.h"

/// The readers behind read_mesh_file, one library each.
namespace fusee::exchange {

inline constexpr std::size_t kMostMeshBytes = std::size_t{1} << 30;  ///< of a file that is read

[[nodiscard]] MeshFile read_foreign_stl(const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_obj(const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_3mf(const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_step(const std::filesystem::path& path);

/// The library that reads a file of this ending, for errors: "OpenCASCADE". @pre is_mesh_file
[[nodiscard]] std::string reader_of(const std::filesystem::path& path);

/// The bytes of such a file. @throws core::IoError: missing, empty, no regular file, larger than kMostMeshBytes
[[nodiscard]] std::string read_foreign_bytes(const std::filesystem::path& path);
/// @throws core::InvalidInput naming the ending; core::IoError if there is something else than a regular file of at most kMostMeshBytes
void require_mesh_file(const std::filesystem::path& path);
/// Corners of faces, index by index, that a text OBJ states: @throws core::IoError naming file and line: a number that is not finite, a
/// face of too many corners or of a point that is missing
void require_sound_obj(const std::string& bytes, const std::filesystem::path& path);

}  // namespace fusee::exchange
