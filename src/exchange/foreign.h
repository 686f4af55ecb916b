#pragma once
#include <string>

#include "fusee/exchange/mesh_file.h"

/// The readers of read_mesh_file, one per library. Each reads the bytes of the one file; `path` is its name for messages.
namespace fusee::exchange {

inline constexpr std::size_t kMostMeshBytes = std::size_t{1} << 30;  ///< of one file

[[nodiscard]] MeshFile read_foreign_stl(std::string bytes, const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_obj(std::string bytes, const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_3mf(std::string bytes, const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_step(std::string bytes, const std::filesystem::path& path);
void load_step_reader();

/// Loads the library that reads files with this ending, so that read_mesh_bytes opens no file. @pre is_mesh_file
void load_mesh_reader(const std::filesystem::path& path);
/// The work of read_mesh_file on the bytes of the file, which `path` names. It opens no file: none that the bytes refer to either.
[[nodiscard]] MeshFile read_mesh_bytes(std::string bytes, const std::filesystem::path& path);

/// The library that reads files with this ending, for error messages: "OpenCASCADE". @pre is_mesh_file
[[nodiscard]] std::string reader_of(const std::filesystem::path& path);

/// The bytes of such a file. @throws core::IoError: missing, empty, not a regular file, larger than kMostMeshBytes
[[nodiscard]] std::string read_foreign_bytes(const std::filesystem::path& path);
/// @throws core::InvalidInput naming the ending; core::IoError if it is not a regular file of at most kMostMeshBytes
void require_mesh_file(const std::filesystem::path& path);
/// Checks the points and faces of a text OBJ. @throws core::IoError naming file and line: a number that is not finite, a face with too many
/// corners or with a missing point
void require_sound_obj(const std::string& bytes, const std::filesystem::path& path);

}  // namespace fusee::exchange
