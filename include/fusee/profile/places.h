#pragma once
#include <filesystem>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Returns what `work` returns. An error of a module names the key; this function adds its file and line.
/// @throws core::InvalidInput with all three
template <class Work>
auto with_places(const Profile& profile, const Work& work) {
    try {
        return work();
    } catch (const core::InvalidInput& e) {
        if (e.field().starts_with("--")) throw;  // an option, no key
        throw core::InvalidInput(profile.place_of(e.field()), e.value(), e.allowed());
    }
}

/// Files as given, whether they exist or not; a folder stands for its *.toml files, by name.
/// @throws IoError if a folder holds none or cannot be read
[[nodiscard]] std::vector<std::filesystem::path> find_profiles(const std::vector<std::filesystem::path>& paths);

}  // namespace fusee::profile
