#pragma once
#include <filesystem>

/// Checks of a command's output path before it computes, so that nobody waits for files that cannot be written.
namespace fusee::core {

/// Makes the folder and its parents unless they exist. @throws IoError
void make_folder(const std::filesystem::path& folder);

/// Checks that `write_file` can write there. Also removes what a killed process left of that file. @throws IoError
void require_writable(const std::filesystem::path& file);

/// The same for a file that the user names: an existing one is replaced only with `force` (docs/outputs.md).
/// @throws core::IoError naming the file
void require_new_file(const std::filesystem::path& file, bool force);

}  // namespace fusee::core
