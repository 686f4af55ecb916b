#pragma once
#include <filesystem>
#include <string>

namespace fusee::core {

/// Why a write failed, by errno, with the limit that the user can change.
[[nodiscard]] std::string write_failure(int error);

/// Flushes a file's bytes, or a folder's names, to the disk, so that they survive a loss of power. Does nothing if the file system cannot.
/// @throws IoError if the disk is full or fails
void sync(const std::filesystem::path& path);

/// The same for all files below a folder.
void sync_tree(const std::filesystem::path& folder);

}  // namespace fusee::core
