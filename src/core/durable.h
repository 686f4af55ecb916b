#pragma once
#include <filesystem>
#include <string>

namespace fusee::core {

/// Hands a file's bytes, or a folder's names, to the disk: they stand there after a loss of power. Where a file system cannot, nothing
/// happens. @throws IoError if the disk is full or fails
void sync(const std::filesystem::path& path);

/// The same for all files below a folder.
void sync_tree(const std::filesystem::path& folder);

[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace fusee::core
