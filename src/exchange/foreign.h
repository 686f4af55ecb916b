#pragma once
#include "fusee/exchange/mesh_file.h"

/// The readers behind read_mesh_file, one library each.
namespace fusee::exchange {

[[nodiscard]] MeshFile read_foreign_stl(const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_obj(const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_3mf(const std::filesystem::path& path);
[[nodiscard]] MeshFile read_foreign_step(const std::filesystem::path& path);

}  // namespace fusee::exchange
