#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/batch/batch.h"
#include "generator.h"

namespace fusee::random_profiles {

/// random_profile or near_profile.
using Generator = std::string (*)(std::uint64_t seed, int number);

/// Writes the profiles `first` to `first + count - 1` of a seed into `folder` and makes them there, `jobs` at a time.
[[nodiscard]] std::vector<batch::Row> make_some(std::uint64_t seed, int first, int count, const std::filesystem::path& folder, unsigned jobs,
                                                Generator generator = random_profile);

/// What is wrong with how a design ended; empty if nothing: made, every file on disk, read back and every arm found; or refused, with what
/// binds, by how much, where and what to change, and nothing on disk.
[[nodiscard]] std::string fault(const batch::Row& row);

}  // namespace fusee::random_profiles
