#pragma once
#include <filesystem>

namespace fusee {

/// Paths and folders, in every module.
namespace fs = std::filesystem;

}  // namespace fusee
