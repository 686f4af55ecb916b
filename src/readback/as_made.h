#pragma once
#include "fusee/exchange/part_file.h"

namespace fusee::readback {

/// What comes off the machine where `mesh` is in its file: of a compensated one, every coordinate times 1 - shrinkage.
[[nodiscard]] solid::Mesh as_made(solid::Mesh mesh, const exchange::PartFile& part);

}  // namespace fusee::readback
