#pragma once
#include <filesystem>
#include <vector>

namespace fusee::profile {

/// Files as given, whether they exist or not; a folder stands for its *.toml files, by name.
/// @throws IoError if a folder holds none or cannot be read
[[nodiscard]] std::vector<std::filesystem::path> find_profiles(const std::vector<std::filesystem::path>& paths);

}  // namespace fusee::profile
