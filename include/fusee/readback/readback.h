#pragma once
#include <array>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/path.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/stl.h"

namespace fusee::readback {

/// The law as recomputed from an exported file. This module does not know how the part was made: it uses only `core`, `exchange` and
/// the reader of programs in `toolpath`.
struct ArmError {
    std::string file;
    /// "assimp", "openmesh", "lib3mf", "dxflib", "dxflib, spline", "opencascade", "rs274 lower", "rs274 upper", "rs274 wrap", "perimeters"
    std::string reader;
    std::size_t rows = 0;         ///< working positions compared
    double worst_relative = 0.0;  ///< largest |found arm / requested arm - 1| over the working range; of a roller's arms below a tenth of
                                  ///< the largest one, which may cross 0: relative to that tenth
    double worst_angle_rad = 0.0;
    double allowed = 1e-3;                                ///< 1e-4 for splines: STEP, and those of DXF; for a print half a layer
    core::Severity when_broken = core::Severity::kError;  ///< kWarning for a print
    std::vector<double> arms_mm = {};                     ///< found arms, one for each row of the target
    std::string mirror_of = {};  ///< the file that `reader` read; its bytes prove that `file` is its mirror image. Empty: it read `file`
    [[nodiscard]] bool passed() const { return worst_relative <= allowed; }  ///< false for NaN
};

/// One file of PART.json to read back.
struct LawFile {
    std::filesystem::path path;
    const exchange::FileEntry& entry;  ///< the file's entry in `part`
    const exchange::PartFile& part;
};
/// The arms that one file carries, an error for each library that reads it and each groove that it holds. @throws IoError
using LawReader = std::vector<ArmError> (*)(const LawFile& file);

/// Diameter of the hole about the axis in the lowest face of an STL file [mm], key and flat aside; for a compensated file, as made on the
/// machine of `part.compensated`.
/// @throws core::IoError if the file cannot be read or has no such hole
[[nodiscard]] double bore_mm(const std::filesystem::path& stl, const exchange::PartFile& part);

/// Reads the plate's 3MF in `folder`: each object moved back to its part's frame and its arm recomputed as `read_back` does, against
/// NAME.json there. One error for each object, reader "lib3mf NAME".
/// @throws IoError if a file cannot be read, the 3MF has not the stated SHA-256, triangles and objects, or two objects' bounding boxes are
/// nearer than the spacing or out of the build volume
[[nodiscard]] std::vector<ArmError> read_back_plate(const std::filesystem::path& folder, const exchange::Plate& plate);

// Readers of the files that carry the law: they find the floor of the groove, turn the body to each working angle, lay a taut cable from
// the guide (the tangent of largest moment) and add half a cable.

/// Finds the arms that a mesh carries: horizontal rays from the axis find the floor.
/// @param reader name of the library that read the mesh
/// @throws IoError if the mesh does not have the stated number of triangles
[[nodiscard]] ArmError compare_mesh(const LawFile& file, const std::string& reader, const solid::Mesh& mesh);

[[nodiscard]] std::vector<ArmError> read_stl(const LawFile& file);  ///< with assimp and OpenMesh
[[nodiscard]] std::vector<ArmError> read_3mf(const LawFile& file);  ///< with lib3mf
[[nodiscard]] std::vector<ArmError> read_drawing(
    const LawFile& file);  ///< DXF with dxflib: polylines and splines; a flange without a groove has none
[[nodiscard]] std::vector<ArmError> read_step(const LawFile& file);  ///< with OpenCASCADE
/// G-code: the floor is what the cutter leaves by the moves that LinuxCNC's interpreter makes of it. None without `rs274` on PATH.
/// @throws IoError also if the moves are not safe (toolpath::faults)
[[nodiscard]] std::vector<ArmError> read_program(const LawFile& file);
/// A slicer's G-code: the cable lies on the beads near its height. Off by the steps of the layers, which a person has to accept
/// (docs/theory/read_back.md, eq. 6).
[[nodiscard]] std::vector<ArmError> read_print(const LawFile& file);

}  // namespace fusee::readback
