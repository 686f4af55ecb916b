#pragma once
#include <chrono>
#include <filesystem>

namespace fusee::exchange {

/// Has `openscad` (found on PATH) render a SCAD file to binary STL, every warning an error. Runs it without a shell; the STL appears only
/// whole.
/// @throws IoError naming `scad` and what openscad said: not installed, failed, or still running after `timeout` (it is then ended)
void render_scad(const std::filesystem::path& scad, const std::filesystem::path& stl,
                 std::chrono::seconds timeout = std::chrono::seconds(600));

}  // namespace fusee::exchange
