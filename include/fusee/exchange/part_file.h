#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/provenance.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"

/// The files that state what was exported: PART.json and plate.json.
///
/// Example:
/// @code
/// const exchange::PartFile part = exchange::read_part_file("out/pnrvsa/k_se.json");
/// for (const readback::ArmError& e : formats::read_back("out/pnrvsa", part))  // every file of the part, by every reader
///     std::cout << e.file << ' ' << e.reader << ' ' << e.worst_relative << '\n';
/// const exchange::Plate plate = exchange::read_plate_file("out/pnrvsa/plate.json");
/// for (const readback::ArmError& e : readback::read_back_plate("out/pnrvsa", plate))
///     std::cout << e.reader << ' ' << e.worst_relative << '\n';
/// @endcode
namespace fusee::exchange {

/// One exported file in the folder of PART.json.
struct FileEntry {
    std::string name;  ///< file name without folder
    std::string sha256;
    std::size_t triangles = 0;  ///< 0 if the format has none
    double chordal_error_mm = 0.0;
};

/// One row of the required law of the part.
struct TargetRow {
    double angle_rad = 0.0;
    double arm_mm = 0.0;
    double load = 0.0;                      ///< cable tension, or the spring's force on the follower [N]
    std::array<double, 3> contact_mm = {};  ///< contact of the cable's centreline or of the roller, in the body frame
    double lift_mm = 0.0;                   ///< roller: travel of the spring since angle 0; on a slide that of its centre
    double stretch_mm = 0.0;                ///< cable elongation since angle 0; 0 for a rigid cable
};

struct PartGuide {
    std::string kind;                        ///< "parallel", "point", "idler" of a cable; "roller" on a slide, "arm": a roller on one
    std::array<double, 2> direction = {};    ///< unit vector in the world frame; parallel, roller: from the cam along the cable or the
                                             ///< line; arm: from the pivot to the roller's centre at cam angle 0
    std::array<double, 2> position_mm = {};  ///< point, idler; arm: the pivot
    double radius_mm = 0.0;                  ///< idler; the roller's
    int sense = 1;                           ///< idler; arm: about +z, in which it turns as the spring is compressed
    double z_mm = 0.0;                       ///< point, idler: height in the part's frame
    double offset_mm = 0.0;                  ///< roller: of the line from the axis, to the side of torque_sign (-D_y, D_x)
    double start_mm = 0.0;                   ///< roller: its centre along the line at cam angle 0
    double arm_mm = 0.0;                     ///< arm: pivot to roller centre
    double lever_mm = 0.0;                   ///< arm: pivot to the spring's pin on it
    double spring_mm = 0.0;                  ///< arm: between the spring's pins at cam angle 0, at a right angle to the lever

    [[nodiscard]] bool has_roller() const { return kind == "roller" || kind == "arm"; }
};

/// Compensation of the files for their process (docs/part-file.md): the process turns the compensated files into the nominal part.
struct Compensated {
    std::array<double, 3> shrink_percent{};  ///< along x, y, z: coordinate of the part = coordinate in the file times 1 - shrink/100
    double bore_offset_mm = 0.0;             ///< by how much the process makes the bore smaller, in diameter, without shrinkage
    double bore_mm = 0.0;                    ///< nominal diameter
};

/// The place of one of two parts of a single spring on their shaft, one part for each cable (docs/part-file.md). At the law's first angle
/// the bodies of both stand in one frame.
struct OnShaft {
    double first_rad = 0.0;  ///< angle of the law at cam angle 0
    int sense = 1;           ///< of the law's angle as the cam angle rises; the part's share of the law's torque has this sign
    double height_mm = 0.0;  ///< by which the part stands above its own frame
};

/// PART.json: the data from which the law of an exported part is recomputed (docs/part-file.md). The cam's axis is +z through the origin,
/// lengths in mm; body and world agree at cam angle 0; at cam angle a the body is turned by rotation_sign * a about +z.
struct PartFile {
    std::string part;  ///< "k_se" or "k_pe"
    double cable_diameter_mm = 0.0;
    int rotation_sign = 1, torque_sign = 1;
    PartGuide guide;
    std::string spring_kind;      ///< "torsion" or "compression"
    double spring_rate = 0.0;     ///< JSON key rate_Nm_per_rad (torsion) or rate_N_per_m (compression)
    double spring_preload = 0.0;  ///< JSON key preload_rad or preload_m
    std::vector<TargetRow> target;
    std::vector<FileEntry> files;
    std::string provenance;
    std::optional<OnShaft> shaft;            ///< none: the part is alone
    std::optional<Compensated> compensated;  ///< none: the files are nominal
};

[[nodiscard]] PartFile describe_part(const solid::Part& part, const spring::BaseSpring& spring, std::vector<FileEntry> files,
                                     const core::Provenance& provenance);
/// @throws IoError
void write_part_file(const std::filesystem::path& path, const PartFile& part);
/// @throws core::IoError if the file cannot be read, core::InvalidInput naming file, line and key
[[nodiscard]] PartFile read_part_file(const std::filesystem::path& path);

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

// Proofs from what was written that files of one part are the mirror images of another's, y -> -y. They compare numbers exactly (0 = -0):
// what is proven here has the same lever arms, and need not be read back a second time.

/// Everything from which arms are recomputed: cable, signs, guide, spring, and each row with its contact. Their files may differ.
[[nodiscard]] bool is_mirror_image(const PartFile& image, const PartFile& part);

/// The bytes of two binary STL files, headers apart: triangle by triangle in the same order, each with its corners the other way round.
[[nodiscard]] bool is_mirrored_stl(std::string_view image, std::string_view stl);

}  // namespace fusee::exchange
