#pragma once
#include <vector>

#include "fusee/assembly/assembly.h"
#include "fusee/checks/limits.h"

/// What of a joint a shop has to make.
namespace fusee::assembly {

/// The bodies beside the cams that the workshop makes, in the assembly's order. The pointers are into `assembly`.
[[nodiscard]] std::vector<const Body*> bodies_to_make(const Assembly& assembly);
/// Of such a body: the frame's plate is a sheet of aluminium, since a printed one would give way; others are of the parts' material, or
/// that of prints where the parts are cut from sheets.
[[nodiscard]] checks::Material material_of(const Assembly& assembly, const Body& body);

}  // namespace fusee::assembly
