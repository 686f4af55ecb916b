#pragma once
#include <filesystem>

/// Where a command is going to write: looked at before it computes, so that nobody waits for what cannot be written.
namespace fusee::core {

/// Makes the folder, and those above it, unless it is there. @throws IoError
void make_folder(const std::filesystem::path& folder);

/// Can `write_file` write there? Leaves nothing behind, not even what a killed process left of that file. @throws IoError
void require_writable(const std::filesystem::path& file);

/// The same of a file that the user names: one that stands there is replaced by `force` only (docs/outputs.md).
/// @throws core::IoError naming the file
void require_new_file(const std::filesystem::path& file, bool force);

}  // namespace fusee::core
