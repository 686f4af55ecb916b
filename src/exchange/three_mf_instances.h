#pragma once
#include <filesystem>

#include "lib3mf.h"

namespace fusee::exchange {

/// Counts the triangles of all build items with their components before lib3mf copies them: nested components multiply.
/// @throws core::IoError naming the file: more than kMostTriangles, or components nested deeper than 100
void require_few_instances(const Handle& model, const std::filesystem::path& path);

}  // namespace fusee::exchange
