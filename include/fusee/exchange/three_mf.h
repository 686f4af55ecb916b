#pragma once
#include <filesystem>
#include <string>

#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// Writes 3MF with lib3mf: unit millimetre, one object, one build item, identity transform, coordinates to 1e-6 mm. Equal input gives equal
/// bytes: lib3mf stamps no time and its random UUIDs are replaced by a hash of mesh, name and provenance.
/// @param name of the object, e.g. "k_se"
/// @param provenance kept as metadata "Description"
/// Thread-safe. @throws IoError; InvalidInput if lib3mf does not take the mesh or finds it not manifold and oriented
void write_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& name, const std::string& provenance);

/// Reads a 3MF that holds one mesh in millimetres without transform, as write_3mf leaves it. Thread-safe.
/// @throws IoError naming the file
[[nodiscard]] solid::Mesh read_3mf(const std::filesystem::path& path);

}  // namespace fusee::exchange
