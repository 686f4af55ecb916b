#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

namespace fusee::core {

/// Writes to a temporary name beside `path` and renames it, so that a reader never sees half a file.
/// @throws IoError
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// @throws IoError, also when it is no regular file or has more than `largest` bytes
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t largest = std::numeric_limits<std::size_t>::max());

/// Hands the bytes to `take` a piece at a time, in order: for what is too large to be kept. @throws IoError as read_file
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

/// A folder that is filled under a hidden name beside its target and takes the target's place only when it is complete; what stood
/// there before is replaced as a whole. Destroyed uncommitted, it leaves nothing behind; what a killed process left is removed by the next
/// one.
class StagedFolder {
public:
    /// @throws IoError
    explicit StagedFolder(std::filesystem::path target);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return staging_; }
    /// @throws IoError; after a throw the earlier target still stands
    void commit();

private:
    std::filesystem::path target_, staging_;
    bool committed_ = false;
};

}  // namespace fusee::core
