#pragma once
#include <filesystem>
#include <string>

#include "fusee/core/destination.h"
#include "fusee/core/error.h"
#include "fusee/profile/profile.h"

namespace fusee::app {

/// What `work` returns; a module below knows the key that it refuses, the profile its file and line.
/// @throws core::InvalidInput with both
template <class Work>
auto with_places(const profile::Profile& profile, const Work& work) {
    try {
        return work();
    } catch (const core::InvalidInput& e) {
        throw core::InvalidInput(profile.place_of(e.field()), e.value(), e.allowed());
    }
}

/// May a new profile be written to `file`? It takes the place of no old one unless forced, and of no CSV
/// file that was named by mistake.
/// @throws core::InvalidInput naming the option; core::IoError
inline void require_new_profile(const std::string& option, const std::filesystem::path& file, const std::filesystem::path& old,
                                bool force) {
    if (file.extension() != ".toml") throw core::InvalidInput(option, file.string(), "a name that ends in .toml, for a profile");
    if (std::filesystem::weakly_canonical(file) == std::filesystem::weakly_canonical(old))
        throw core::InvalidInput(option, file.string(), "another file than the profile, which stays as it is");
    core::require_new_file(file, force);
}

}  // namespace fusee::app
