#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "fusee/core/folder.h"

namespace fusee::core {

/// A file that fusee made.
struct MadeFile {
    std::string command, source;  ///< source: relative to the folder; "." the folder itself
    std::string sha256;           ///< of its bytes
    std::string earlier;          ///< hash of the previous bytes while a run moves its files; otherwise empty
    bool sheet = false;           ///< to be filled in by the user

    [[nodiscard]] bool holds(const std::string& hash) const { return !hash.empty() && (hash == sha256 || hash == earlier); }
};
/// The made files by name relative to the folder, with '/'.
using Manifest = std::map<std::string, MadeFile>;

/// Gives none if the folder has none. @throws IoError if it is damaged or names a file outside the folder
[[nodiscard]] std::optional<Manifest> read_manifest(const OpenFolder& folder);

/// The manifest as JSON. Bytes that are not UTF-8 are written as %XX.
[[nodiscard]] std::string manifest_text(const Manifest& manifest);

/// Flushes a file's bytes, or a folder's names, to the disk, so that they survive a loss of power. Does nothing if the file system cannot.
/// @throws IoError if the disk is full or fails
void sync(const std::filesystem::path& path);

/// The same for all files below a folder.
void sync_tree(const std::filesystem::path& folder);

}  // namespace fusee::core
