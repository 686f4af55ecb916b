#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/exchange/part_file.h"
#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// Where a part stands on the plate: its mesh, as in its own files, is laid on its top (turned by 180 deg about +x) or not, turned by 90
/// deg about +z or not, then moved. The object's vertices are where they stand: its transform in the 3MF is the identity.
struct PlateObject {
    std::string name;  ///< of the object in the 3MF; NAME.json is the part's own file
    bool turned = false;
    solid::Vec3 moved_mm{};
    bool flipped = false;  ///< stands on its top face
};

/// plate.json: what is where in plate.3mf (docs/part-file.md). The bed's corner is the origin, its surface z = 0.
struct Plate {
    FileEntry file;           ///< plate.3mf, triangles of all objects
    solid::Vec3 build_mm{};   ///< build volume
    double spacing_mm = 0.0;  ///< between the bounding boxes, at least
    std::vector<PlateObject> objects;
    std::string provenance;
};

[[nodiscard]] solid::Mesh placed(const solid::Mesh& mesh, const PlateObject& place);
/// The mesh of a placed object in its part's frame again.
[[nodiscard]] solid::Mesh taken_back(const solid::Mesh& mesh, const PlateObject& place);

/// @throws IoError
void write_plate_file(const std::filesystem::path& path, const Plate& plate);
/// @throws core::IoError if the file cannot be read, core::InvalidInput naming file, line and key
[[nodiscard]] Plate read_plate_file(const std::filesystem::path& path);

}  // namespace fusee::exchange
