#pragma once
#include "fusee/exchange/part_file.h"

namespace fusee::readback {

/// The body as made from a file with `mesh`: for a compensated file, every coordinate times 1 - shrinkage.
[[nodiscard]] solid::Mesh as_made(solid::Mesh mesh, const exchange::PartFile& part);

}  // namespace fusee::readback
