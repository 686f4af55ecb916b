#pragma once
#include <filesystem>

namespace fusee::core {

/// Flushes a file's bytes, or a folder's names, to the disk, so that they survive a loss of power. Does nothing if the file system cannot.
/// @throws IoError if the disk is full or fails
void sync(const std::filesystem::path& path);

/// The same for all files below a folder.
void sync_tree(const std::filesystem::path& folder);

}  // namespace fusee::core
