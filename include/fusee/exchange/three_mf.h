#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// A mesh and what it is called: "k_se".
struct NamedMesh {
    std::string name;
    solid::Mesh mesh;
};

/// Writes 3MF with lib3mf: unit millimetre, one object and one build item for each mesh, identity transforms, coordinates to 1e-6 mm. Equal
/// input gives equal bytes: lib3mf stamps no time and its random UUIDs are replaced by a hash of meshes, names and provenance.
/// @param provenance kept as metadata "Description"
/// Thread-safe. @throws IoError; InvalidInput if lib3mf does not take a mesh or finds it not manifold and oriented
void write_3mf(const std::filesystem::path& path, const std::vector<NamedMesh>& objects, const std::string& provenance);
/// The same of one mesh.
void write_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& name, const std::string& provenance);

/// Reads the build items of a 3MF in millimetres, meshes without transforms as write_3mf leaves them, in the file's order. Thread-safe.
/// @throws IoError naming the file
[[nodiscard]] std::vector<NamedMesh> read_3mf_objects(const std::filesystem::path& path);
/// The metadata "Description" of a 3MF; "" if it has none. Thread-safe. @throws IoError naming the file
[[nodiscard]] std::string read_3mf_description(const std::filesystem::path& path);
/// The mesh of a 3MF that holds one. @throws IoError as above, and if it holds several
[[nodiscard]] solid::Mesh read_3mf(const std::filesystem::path& path);

}  // namespace fusee::exchange
