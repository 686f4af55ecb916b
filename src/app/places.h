#pragma once
#include <filesystem>
#include <string>

#include "fusee/core/destination.h"
#include "fusee/core/error.h"
#include "fusee/profile/places.h"

namespace fusee::app {

using profile::with_places;

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
