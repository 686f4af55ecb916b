#pragma once
#include <string>
#include <vector>

#include "fusee/core/isolated.h"
#include "fusee/exchange/mesh_file.h"

namespace fusee::exchange {

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
