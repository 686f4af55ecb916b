#pragma once
#include <filesystem>

/// Where a command is going to write: looked at before it computes, so that nobody waits for what cannot be written.
namespace fusee::core {

/// Makes the folder, and those above it, unless it is there. @throws IoError
void make_folder(const std::filesystem::path& folder);

/// Can `write_file` write there? Leaves nothing behind. @throws IoError
void require_writable(const std::filesystem::path& file);

}  // namespace fusee::core
