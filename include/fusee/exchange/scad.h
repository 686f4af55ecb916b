#pragma once
#include <chrono>
#include <filesystem>
#include <string>

#include "fusee/solid/part.h"

namespace fusee::exchange {

/// Fills templates/k_se.scad or k_pe.scad with the data of a part. A person can read and change the file in OpenSCAD.
/// `openscad --hardwarnings` builds the part from it by its own operations: extruded outlines or the bare body, one swept tube, cutters.
/// Columns, section and diagonals are those of the direct mesh, so that the two can be compared.
/// @param templates folder with k_se.scad, k_pe.scad and library.scad; empty: the templates in the program
/// @throws InvalidInput if a template names a value that parts do not have
/// @throws IoError
void write_scad(const std::filesystem::path& path, const solid::Part& part, const std::string& provenance,
                const std::filesystem::path& templates = {});

/// Renders a SCAD file to binary STL with `openscad` from PATH; every warning is an error. Runs it without a shell. The STL is complete or
/// absent.
/// @throws IoError naming `scad` with the message of openscad: not installed, failed, or ended after `timeout`
void render_scad(const std::filesystem::path& scad, const std::filesystem::path& stl,
                 std::chrono::seconds timeout = std::chrono::seconds(600));

}  // namespace fusee::exchange
