#pragma once
#include <chrono>
#include <filesystem>
#include <string>

namespace fusee::exchange {

/// How a part is sliced: upright as it stands in its file, three perimeters, 20 % infill, no support, a 0.4 mm nozzle. Outlines are kept as
/// they are: no compensation, no smoothing, beads of one width.
struct SliceOptions {
    double layer_mm = 0.2;   ///< every layer, the first too
    double width_mm = 0.45;  ///< of a bead; PrusaSlicer's own for a nozzle of 0.4 mm
    double lowest_mm = 0.0;  ///< z of the part's lowest point, which the slicer puts on the bed
};

/// Can parts be sliced here? `prusa-slicer` has to be on PATH.
[[nodiscard]] bool can_slice();

/// Has PrusaSlicer slice an STL to G-code. Runs it without a shell; the file appears only whole. Its first lines name the part, the
/// slicer's version and the height of the bed in the part's frame; the time that PrusaSlicer puts there is left out. Temperatures and start
/// code are PrusaSlicer's defaults: the file is there to be read back, a printer wants its own.
/// @throws InvalidInput if layer or width is not above 0, or the width not above the layer's height
/// @throws IoError naming `stl` and what PrusaSlicer said: not installed, failed, or still running after `timeout` (it is then ended)
void slice_stl(const std::filesystem::path& stl, const std::filesystem::path& gcode, const SliceOptions& options,
               const std::string& provenance, std::chrono::seconds timeout = std::chrono::seconds(600));

}  // namespace fusee::exchange
