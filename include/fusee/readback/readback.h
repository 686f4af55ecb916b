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
    [[nodiscard]] bool passed() const { return worst_relative <= allowed; }  ///< false for NaN
};

/// Reads every file of `part.files` in `folder` with each of its readers and recomputes the arm: horizontal rays from the axis find the
/// groove's floor, the body is turned to each working angle, a taut cable is laid from the guide (tangent of largest moment), half a cable
/// is added. The floor of a G-code program is the surface that the cutter leaves, by the moves of LinuxCNC's interpreter; without `rs274`
/// on PATH programs are skipped. In a slicer's G-code the cable lies on the beads near its height. Also requires that the bytes have the
/// stated SHA-256, that a mesh has the stated number of triangles, and that a program's moves are safe (toolpath::faults). SCAD files are
/// not read here.
/// @throws IoError if a file cannot be read or does not match its entry
[[nodiscard]] std::vector<ArmError> read_back(const std::filesystem::path& folder, const exchange::PartFile& part);

}  // namespace fusee::readback
