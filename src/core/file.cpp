#include "fusee/core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>

#include "durable.h"
#include "fusee/core/crash_report.h"
#include "fusee/core/error.h"
#include "fusee/core/stop.h"
#include "fusee/core/temporary_folder.h"

namespace fs = std::filesystem;

namespace fusee::core {

namespace {

constexpr int kNames = 1000;  // tried for a temporary file

/// A name in the folder of `path` that no other process or thread uses.
fs::path hidden_sibling(const fs::path& path, std::string_view purpose) {
    static std::atomic<unsigned> serial{0};
    return path.parent_path() / fmt::format(".{}.{}-{}-{}", path.filename().string(), purpose, ::getpid(), serial++);
}

/// Writes all bytes to a new file and flushes them to the disk. @returns 0 or errno
int write_new(const fs::path& path, std::string_view bytes, bool to_disk) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) return errno;
    int failed = 0;
    while (!bytes.empty() && failed == 0) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            failed = errno;
    }
    if (to_disk && failed == 0 && ::fsync(file) != 0 && errno != EINVAL && errno != EROFS)
        failed = errno;  // some file systems have no fsync
    if (::close(file) != 0 && failed == 0) failed = errno;
    return failed;
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
    const bool to_disk = !is_in_temporary_folder(path);  // an output folder flushes all its files at once
    std::optional<StopHold> hold;                        // a stop leaves no file of a temporary name
    if (to_disk) hold.emplace();
    fs::path temporary;
    int failed = EEXIST;  // the name exists: left by a killed process
    for (int i = 0; i < kNames && failed == EEXIST; ++i) failed = write_new(temporary = hidden_sibling(path, "part"), bytes, to_disk);
    std::error_code error;
    if (failed != 0) {
        if (failed != EEXIST) fs::remove(temporary, error);
        throw IoError(path.string(), "cannot be written: " + write_failure(failed));
    }
    fs::rename(temporary, path, error);
    if (!error) return;
    const std::string why = error.message();
    fs::remove(temporary, error);
    throw IoError(path.string(), "cannot be written: " + why);
}

namespace {
void take_pieces(const fs::path& path, std::size_t largest, const std::function<void(std::string_view)>& take) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) throw IoError(path.string(), "is a folder, not a file");
    // Opening a pipe waits for a writer, who may never come; a device may have no end.
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw IoError(path.string(), "is a pipe, a socket or a device; only regular files are read");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw IoError(path.string(), "cannot be opened for reading");
    std::array<char, 1 << 16> piece;
    std::size_t size = 0;
    while (in.read(piece.data(), piece.size()), in.gcount() > 0) {
        const auto count = static_cast<std::size_t>(in.gcount());
        size += count;
        if (size > largest) throw IoError(path.string(), fmt::format("is larger than the {} bytes that are read", largest));
        take({piece.data(), count});
    }
    if (in.bad()) throw IoError(path.string(), "cannot be read to its end");
}
}  // namespace

void read_pieces(const fs::path& path, std::size_t largest, const std::function<void(std::string_view)>& take) {
    note_input(path);
    take_pieces(path, largest, take);
}

std::string read_file(const fs::path& path, std::size_t largest) {
    std::string bytes;
    read_pieces(path, largest, [&bytes](std::string_view piece) { bytes.append(piece); });
    return bytes;
}

Sha256::Sha256() : state_(EVP_MD_CTX_new(), [](void* state) { EVP_MD_CTX_free(static_cast<EVP_MD_CTX*>(state)); }) {
    EVP_DigestInit_ex(static_cast<EVP_MD_CTX*>(state_.get()), EVP_sha256(), nullptr);
}

void Sha256::add(std::string_view bytes) { EVP_DigestUpdate(static_cast<EVP_MD_CTX*>(state_.get()), bytes.data(), bytes.size()); }

std::string Sha256::hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    EVP_DigestFinal_ex(static_cast<EVP_MD_CTX*>(state_.get()), digest.data(), &length);
    std::string hex;
    for (unsigned int i = 0; i < length; ++i) hex += fmt::format("{:02x}", digest[i]);
    return hex;
}

std::string sha256_of_file(const fs::path& path) {
    Sha256 hash;
    take_pieces(path, std::numeric_limits<std::size_t>::max(), [&hash](std::string_view piece) { hash.add(piece); });
    return hash.hex();
}

std::string sha256_hex(std::string_view bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

}  // namespace fusee::core
