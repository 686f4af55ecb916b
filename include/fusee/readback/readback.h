#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/exchange/part_file.h"

namespace fusee::readback {

/// The law as recomputed from an exported file. This module does not know how the part was made: it uses only `core`, `exchange` and
/// the reader of programs in `toolpath`.
struct ArmError {
    std::string file;
    /// "assimp", "openmesh", "lib3mf", "dxflib", "dxflib, spline", "opencascade", "rs274 lower", "rs274 upper", "rs274 wrap", "perimeters"
    std::string reader;
    std::size_t rows = 0;         ///< working positions compared
    double worst_relative = 0.0;  ///< largest |found arm / requested arm - 1| over the working range
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
    const exchange::FileEntry& entry;  ///< of it in `part`
    const exchange::PartFile& part;
};
/// The arms that one file carries, an error for each library that reads it and each groove that it holds. @throws IoError
using LawReader = std::vector<ArmError> (*)(const LawFile& file);

}  // namespace fusee::readback
