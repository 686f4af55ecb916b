#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

/// An error about the geometry of a part, in millimetres.
core::Finding refusal(const char* rule, std::string what, double measured, double allowed, const std::string& where,
                      core::Suggestion suggestion);

/// Do groove, axis, anchor hole and bore fit into the part at all? The checks judge the remaining material.
/// Findings "solid.turns", "solid.floor", "solid.axis", "solid.anchor", "solid.bore"; none if they fit.
core::Findings check_geometry(const cam::Cam& cam, const PartOptions& options, const std::vector<SectionPoint>& section);

class ColumnMaker;

/// Can a helix's lips run out into its flange without turning back? Finding "solid.run_out"; none if they can.
core::Findings check_run_outs(const Part& part, const ColumnMaker& maker);

}  // namespace fusee::solid
