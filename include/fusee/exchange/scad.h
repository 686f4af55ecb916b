#pragma once
#include <filesystem>
#include <string>

#include "fusee/solid/part.h"

namespace fusee::exchange {

/// Fills templates/k_se.scad or k_pe.scad with a part's data: a file that a person opens in OpenSCAD, reads and changes, and from which
/// `openscad --hardwarnings` builds the part anew with its own features (extruded outlines or the bare body, one swept tube, cutters). Same
/// columns, section and diagonals as the direct mesh, so that the two can be compared.
/// @param templates folder with k_se.scad, k_pe.scad and library.scad; empty = those built into the program
/// @throws InvalidInput if a template names a value that a part does not have
/// @throws IoError
void write_scad(const std::filesystem::path& path, const solid::Part& part, const std::string& provenance,
                const std::filesystem::path& templates = {});

}  // namespace fusee::exchange
