#pragma once
#include <chrono>
#include <filesystem>
#include <string>

namespace fusee::exchange {

/// Settings of the slicer. The part is upright as in its file, with three perimeters, 20 % infill, no support and a 0.4 mm nozzle. Outlines
/// stay unchanged: no compensation, no smoothing, beads of constant width.
struct SliceOptions {
    double layer_mm = 0.2;   ///< every layer, including the first
    double width_mm = 0.45;  ///< of a bead; the default of PrusaSlicer for a 0.4 mm nozzle
    double lowest_mm = 0.0;  ///< z of the lowest point of the part; the slicer puts it on the bed
};

/// Is `prusa-slicer` on PATH?
[[nodiscard]] bool can_slice();

/// Slices an STL to G-code with PrusaSlicer. Runs it without a shell; the file is complete or absent. Its first lines name the part, the
/// version of the slicer and the height of the bed in the part's frame, without the time of slicing. Temperatures and start code are
/// defaults of PrusaSlicer: the file is for read-back, not for a printer.
/// @throws InvalidInput if layer or width is not above 0, or if the width is not above the layer height
/// @throws IoError naming `stl` with the message of PrusaSlicer: not installed, failed, or ended after `timeout`
void slice_stl(const std::filesystem::path& stl, const std::filesystem::path& gcode, const SliceOptions& options,
               const std::string& provenance, std::chrono::seconds timeout = std::chrono::seconds(600));

}  // namespace fusee::exchange
