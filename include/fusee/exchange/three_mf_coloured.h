#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/exchange/colour.h"
#include "fusee/solid/mesh.h"

namespace fusee::exchange {

inline constexpr Colour kGrey = {190, 190, 190};

/// Writes a 3MF in millimetres with one colour per triangle. A mesh that is not closed, manifold and oriented is written as a surface, so
/// that its faults can be seen. Triangles with fewer than three points are omitted: 3MF has none. Equal input gives equal bytes.
/// Thread-safe.
/// @throws core::InvalidInput unless there is one colour per triangle; core::IoError
void write_coloured_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::vector<Colour>& colours,
                        const std::string& name, const std::string& provenance);

/// The colours of the triangles of the first mesh of a 3MF, at their first corners. Thread-safe. @throws core::IoError naming the file
[[nodiscard]] std::vector<Colour> read_3mf_colours(const std::filesystem::path& path);

}  // namespace fusee::exchange
