#pragma once
#include <vector>

#include "fusee/assembly/assembly.h"

/// What of a joint a shop has to make.
namespace fusee::assembly {

/// The bodies beside the cams that the workshop makes, in the assembly's order. The pointers are into `assembly`.
[[nodiscard]] std::vector<const Body*> bodies_to_make(const Assembly& assembly);

}  // namespace fusee::assembly
