#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

/// A required finding of this room, in millimetres.
core::Finding refusal(const char* rule, std::string what, double measured, double allowed, const std::string& where,
                      std::string suggestion);

/// Is there room for groove, axis, anchor hole and bore at all? How much material has to be left is for the checks to judge.
/// Findings "solid.turns", "solid.floor", "solid.axis", "solid.anchor", "solid.bore"; none where there is.
core::Findings check_room(const cam::Cam& cam, const PartOptions& options, const std::vector<SectionPoint>& section);

class ColumnMaker;

/// Can a helix's lips run out into its flange without turning back? Finding "solid.run_out"; none if they can.
core::Findings check_run_outs(const Part& part, const ColumnMaker& maker);

}  // namespace fusee::solid
