#pragma once
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "fusee/core/path.h"

/// Files, read and written whole.
namespace fusee::core {

/// Writes to a temporary name in the same folder and renames it, so that a reader never sees half a file.
/// @throws IoError
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// @throws IoError, also if it is not a regular file or has more than `largest` bytes
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t largest = std::numeric_limits<std::size_t>::max());

/// Each file read by these two is an input of the run (note_input of crash_report.h).
/// Passes the bytes to `take` in pieces, in order: for files too large to keep in memory. @throws IoError as read_file
void read_pieces(const std::filesystem::path& path, std::size_t largest, const std::function<void(std::string_view)>& take);

/// Lower-case hex SHA-256 of the bytes.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// SHA-256 of bytes that come in pieces.
class Sha256 {
public:
    Sha256();
    void add(std::string_view bytes);
    /// Lower-case hex of all bytes so far; nothing can be added afterwards.
    [[nodiscard]] std::string hex();

private:
    std::shared_ptr<void> state_;  // of OpenSSL
};

// Checks of a command's output path before it computes, so that nobody waits for files that cannot be written.

/// Makes the folder and its parents unless they exist. @throws IoError
void make_folder(const std::filesystem::path& folder);

/// Checks that `write_file` can write there. Also removes what a killed process left of that file. @throws IoError
void require_writable(const std::filesystem::path& file);

/// The same for a file that the user names: an existing one is replaced only with `force` (docs/outputs.md).
/// @throws core::IoError naming the file
void require_new_file(const std::filesystem::path& file, bool force);

}  // namespace fusee::core
