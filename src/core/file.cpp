#include "fusee/core/file.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>
#include <vector>

#include "fusee/core/crash_report.h"
#include "fusee/core/error.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"

namespace fusee::core {

void write_file(const fs::path& path, std::string_view bytes) {
    std::optional<StopHold> hold;  // a stop leaves no file of a temporary name
    if (!is_in_temporary_folder(path)) hold.emplace();
    NewFile file(path);
    file.add(bytes);
    file.commit();
}

namespace {

/// Names without ending of the folder's files with this ending; of a large folder, some.
std::vector<std::string> names_in(const fs::path& folder, const fs::path& ending) {
    constexpr std::size_t kMost = 1000;
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end && names.size() < kMost; at.increment(error))
        if (at->path().extension() == ending) names.push_back(at->path().stem().string());
    std::sort(names.begin(), names.end());  // the system lists them in any order
    return names;
}

/// Why a file does not open, and where it may be instead.
std::string why_closed(const fs::path& path, int reason) {
    if (reason == EACCES) return "you have no permission to read it";
    if (reason != ENOENT && reason != ENOTDIR) return std::strerror(reason);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code error;
    if (!fs::is_directory(folder, error)) return fmt::format("there is no folder {}", printable(folder.string()));
    const std::vector<std::string> near = near_names(path.stem().string(), names_in(folder, path.extension()), 1);
    return "it does not exist" + (near.empty() ? "" : "; did you mean " + printable(near.front() + path.extension().string()) + "?");
}

}  // namespace

void read_pieces(const fs::path& path, std::size_t largest, const std::function<void(std::string_view)>& take) {
    note_input(path);
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) throw IoError(path.string(), "is a folder, not a file");
    // Opening a pipe waits for a writer, who may never come; a device may have no end.
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw IoError(path.string(), "is a pipe, a socket or a device; only regular files are read");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw IoError(path.string(), "cannot be opened for reading: " + why_closed(path, errno));
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

std::string read_file(const fs::path& path, std::size_t largest) {
    std::string bytes;
    std::error_code none;
    if (const std::uintmax_t size = fs::file_size(path, none); !none && size <= largest) bytes.reserve(size);
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

std::string sha256_hex(std::string_view bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

}  // namespace fusee::core
