#pragma once
#include <filesystem>
#include <string>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/profile/edit.h"
#include "fusee/profile/places.h"

namespace fusee::app {

using profile::with_places;

/// A file in the folder of the profile: "x-fixed.toml" for "x.toml" and "-fixed".
inline std::filesystem::path beside(const std::filesystem::path& profile, const std::string& ending) {
    return profile.parent_path() / (profile::derived_name(profile.stem().string(), ending) + ".toml");
}

/// Refuses to write a profile over an old one unless forced, or to a file that is not a .toml file.
/// @throws core::InvalidInput naming the option; core::IoError
inline void require_new_profile(const std::string& option, const std::filesystem::path& file, const std::filesystem::path& old,
                                bool force) {
    if (file.extension() != ".toml") throw core::InvalidInput(option, file.string(), "a file name that ends in .toml");
    if (std::filesystem::weakly_canonical(file) == std::filesystem::weakly_canonical(old))
        throw core::InvalidInput(option, file.string(), "a file other than the profile, which is not changed");
    core::require_new_file(file, force);
}

}  // namespace fusee::app
