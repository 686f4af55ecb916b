#pragma once
#include <filesystem>

#include "lib3mf.h"

namespace fusee::exchange {

/// Counts what placing every build item with its components would make, before lib3mf copies it: components of components multiply.
/// @throws core::IoError naming the file: more than kMostTriangles, or components nested deeper than 100
void require_few_instances(const Handle& model, const std::filesystem::path& path);

}  // namespace fusee::exchange
