#pragma once
#include <chrono>
#include <filesystem>

namespace fusee::exchange {

/// Renders a SCAD file to binary STL with `openscad` from PATH; every warning is an error. Runs it without a shell. The STL is complete or
/// absent.
/// @throws IoError naming `scad` with the message of openscad: not installed, failed, or ended after `timeout`
void render_scad(const std::filesystem::path& scad, const std::filesystem::path& stl,
                 std::chrono::seconds timeout = std::chrono::seconds(600));

}  // namespace fusee::exchange
