#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue (sRGB)
inline constexpr Colour kGrey = {190, 190, 190};

/// Writes a 3MF whose triangles have colours, in millimetres. A mesh that is not closed, manifold and oriented is written as a surface, so
/// that what is wrong with it can be looked at; triangles of fewer than three points are left out, since 3MF has none. Equal input gives
/// equal bytes. Thread-safe.
/// @throws core::InvalidInput unless there is one colour for each triangle; core::IoError
void write_coloured_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::vector<Colour>& colours,
                        const std::string& name, const std::string& provenance);

/// The triangles' colours of a 3MF's first mesh, at their first corners. Thread-safe. @throws core::IoError naming the file
[[nodiscard]] std::vector<Colour> read_3mf_colours(const std::filesystem::path& path);

}  // namespace fusee::exchange
