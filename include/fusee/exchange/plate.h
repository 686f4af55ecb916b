#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/exchange/part_file.h"
#include "fusee/solid/mesh.h"

namespace fusee::exchange {

/// The place of a part on the plate. The mesh of its own files is flipped onto its top or not (180 deg about +x), turned or not (90 deg
/// about +z), then moved. The 3MF stores the moved vertices; the transform of the object is the identity.
struct PlateObject {
    std::string name;  ///< of the object in the 3MF; NAME.json is the part's own file
    bool turned = false;
    solid::Vec3 moved_mm{};
    bool flipped = false;  ///< the top face is on the bed
};

/// plate.json: the objects of plate.3mf and their places (docs/part-file.md). The corner of the bed is the origin; its surface is z = 0.
struct Plate {
    FileEntry file;           ///< plate.3mf, triangles of all objects
    solid::Vec3 build_mm{};   ///< build volume
    double spacing_mm = 0.0;  ///< least distance of the bounding boxes
    std::vector<PlateObject> objects;
    std::string provenance;
};

[[nodiscard]] solid::Mesh placed(const solid::Mesh& mesh, const PlateObject& place);
/// The inverse of `placed`: the mesh in the frame of its part.
[[nodiscard]] solid::Mesh taken_back(const solid::Mesh& mesh, const PlateObject& place);

/// @throws IoError
void write_plate_file(const std::filesystem::path& path, const Plate& plate);
/// @throws core::IoError if the file cannot be read, core::InvalidInput naming file, line and key
[[nodiscard]] Plate read_plate_file(const std::filesystem::path& path);

}  // namespace fusee::exchange
