#pragma once
#include <string>
#include <vector>

#include "fusee/core/isolated.h"
#include "fusee/exchange/mesh_file.h"

namespace fusee::exchange {

/// The argument that makes the fusee program a reader: `fusee --read-mesh FILE` calls serve_mesh_file.
inline constexpr const char* kReadMesh = "--read-mesh";

/// What the reader of this file may take: 10 s and 30 s for each megabyte, at most 10 minutes; 2 GiB and 20 bytes for each byte of the
/// file.
[[nodiscard]] core::ChildLimits reader_limits(const std::filesystem::path& path);

/// As read_mesh_file, but in a process of its own: a file on which assimp, lib3mf or OpenCASCADE crashes, loops or takes all memory ends
/// that process only (docs/decisions/0006-third-party-readers.md). Thread-safe.
/// @param reader the words of a program that calls serve_mesh_file with the path that is added to them: {"/usr/bin/fusee", "--read-mesh"}
/// @throws core::InvalidInput, core::IoError as read_mesh_file; core::IoError also if the reader crashes or reaches a limit, and if the
///         path is no regular file
[[nodiscard]] MeshFile read_mesh_isolated(const std::filesystem::path& path, const std::vector<std::string>& reader);

/// The other side: limits this process, reads the file and writes the mesh, or why there is none, to standard output in a binary form of
/// this version's own. Nothing else reaches standard output, whatever a library prints. @returns the exit code
int serve_mesh_file(const std::filesystem::path& path);

}  // namespace fusee::exchange
