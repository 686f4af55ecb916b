#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "fusee/batch/batch.h"

namespace fusee::batch {

struct WatchOptions {
    OutFolder folder;
    std::function<void(const std::string& text)> say;          ///< one or a few lines, without the last line end
    std::function<void(const std::string& verdict)> answered;  ///< after each fast answer: its first line; may be empty
    std::function<void(const std::filesystem::path&)> made;    ///< after each finished make: out/NAME; may be empty
    std::function<bool()> stop;                                ///< asked 20 times a second
};

/// Watches a profile and the CSV files that it names. At the start and after each save: first the verdict of law, contours and rules
/// without a solid, then the full make in the background, which a newer save or a bad profile stops. Returns when `stop` says so, with no
/// make running; a stopped make leaves no file. @throws core::IoError if the profile does not exist or its folder cannot be watched
void watch_profile(const std::filesystem::path& profile, const WatchOptions& options);

}  // namespace fusee::batch
