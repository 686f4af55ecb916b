#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue (sRGB)

/// A mesh and its name, such as "k_se"; it may have several shells.
struct NamedMesh {
    std::string name;
    solid::Mesh mesh;
    std::optional<Colour> colour = {};
};

/// Writes 3MF with lib3mf: unit millimetre, one object and one build item per mesh, identity transforms, coordinates to 1e-6 mm. Equal
/// input gives equal bytes: lib3mf writes no time, and a hash of meshes, names and provenance replaces its random UUIDs.
/// @param provenance stored as metadata "Description"
/// Thread-safe. @throws IoError; InvalidInput if a mesh is not closed and oriented
void write_3mf(const std::filesystem::path& path, const std::vector<NamedMesh>& objects, const std::string& provenance);
/// The same for one mesh.
void write_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& name, const std::string& provenance);

/// Reads the build items of a 3MF in millimetres, in the order of the file; meshes must have no transform, as write_3mf writes them.
/// Thread-safe.
/// @throws IoError naming the file
[[nodiscard]] std::vector<NamedMesh> read_3mf_objects(const std::filesystem::path& path);
/// The only mesh of a 3MF. @throws IoError as above, and if it has several
[[nodiscard]] solid::Mesh read_3mf(const std::filesystem::path& path);

inline constexpr Colour kGrey = {190, 190, 190};

/// Writes a 3MF in millimetres with one colour per triangle. A mesh that is not closed, manifold and oriented is written as a surface, so
/// that its faults can be seen. Triangles with fewer than three points are omitted: 3MF has none. Equal input gives equal bytes.
/// Thread-safe.
/// @throws core::InvalidInput unless there is one colour per triangle; core::IoError
void write_coloured_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::vector<Colour>& colours,
                        const std::string& name, const std::string& provenance);

}  // namespace fusee::exchange
