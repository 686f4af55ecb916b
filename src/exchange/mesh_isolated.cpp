#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <new>
#include <optional>
#include <string_view>

#include "foreign.h"
#include "fusee/core/error.h"
#include "fusee/exchange/mesh_file.h"

namespace fusee::exchange {

namespace {

// A message is one letter and its content.
constexpr char kMesh = 'M', kRefusal = 'R', kNoMemory = 'O';

struct Sizes {
    std::uint64_t unit = 0, items = 0, points = 0, triangles = 0;
    [[nodiscard]] std::uint64_t bytes() const {
        return 1 + sizeof(Sizes) + unit + items + points * sizeof(solid::Vec3) + triangles * sizeof(solid::Triangle);
    }
};

/// "12 4 k_se": triangles, length of the name, name; one after the other.
std::string text_of(const std::vector<MeshItem>& items) {
    std::string text;
    for (const MeshItem& item : items) text += fmt::format("{} {} {}", item.triangles, item.name.size(), item.name);
    return text;
}
/// @returns nothing if a crash has damaged the text
std::optional<std::vector<MeshItem>> items_of(std::string_view text, std::uint64_t triangles) {
    std::vector<MeshItem> items;
    std::uint64_t sum = 0;
    while (!text.empty()) {
        std::uint64_t numbers[2] = {0, 0};
        for (std::uint64_t& number : numbers) {
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            if (error != std::errc() || end == text.data() + text.size() || *end != ' ') return std::nullopt;
            text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
        }
        if (numbers[1] > text.size() || numbers[0] > triangles) return std::nullopt;
        items.push_back({std::string(text.substr(0, numbers[1])), numbers[0]});
        text.remove_prefix(numbers[1]), sum += numbers[0];
    }
    return items.empty() || sum == triangles ? std::optional(items) : std::nullopt;
}

std::string message_of(const MeshFile& file) {
    const std::string items = text_of(file.items);
    const Sizes sizes{file.unit.size(), items.size(), file.mesh.points_mm.size(), file.mesh.triangles.size()};
    std::string bytes(1, kMesh);
    bytes.reserve(sizes.bytes());
    const auto append = [&bytes](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); };
    append(&sizes, sizeof sizes);
    append(file.unit.data(), file.unit.size());
    append(items.data(), items.size());
    append(file.mesh.points_mm.data(), sizes.points * sizeof(solid::Vec3));
    append(file.mesh.triangles.data(), sizes.triangles * sizeof(solid::Triangle));
    return bytes;
}

/// @returns nothing if a crash has damaged the message
std::optional<MeshFile> mesh_of(std::string_view bytes) {
    Sizes sizes;
    if (bytes.size() < 1 + sizeof sizes) return std::nullopt;
    std::memcpy(&sizes, bytes.data() + 1, sizeof sizes);
    const bool possible = std::max({sizes.unit, sizes.items, sizes.points, sizes.triangles}) <= bytes.size();
    if (!possible || sizes.bytes() != bytes.size()) return std::nullopt;
    const char* at = bytes.data() + 1 + sizeof sizes;
    MeshFile file{{}, std::string(at, sizes.unit)};
    at += sizes.unit;
    auto items = items_of({at, sizes.items}, sizes.triangles);
    if (!items) return std::nullopt;
    file.items = std::move(*items);
    at += sizes.items;
    file.mesh.points_mm.resize(sizes.points);
    file.mesh.triangles.resize(sizes.triangles);
    std::copy_n(at, sizes.points * sizeof(solid::Vec3), reinterpret_cast<char*>(file.mesh.points_mm.data()));
    at += sizes.points * sizeof(solid::Vec3);
    std::copy_n(at, sizes.triangles * sizeof(solid::Triangle), reinterpret_cast<char*>(file.mesh.triangles.data()));
    for (const solid::Triangle& t : file.mesh.triangles)
        if (*std::max_element(t.begin(), t.end()) >= sizes.points) return std::nullopt;
    return file;
}

/// The message of the reader about this file: the mesh or the error.
std::string answer(const fs::path& path) {
    try {
        std::string bytes = read_foreign_bytes(path);
        load_mesh_reader(path);
        core::open_no_more_files();
        return message_of(read_mesh_bytes(std::move(bytes), path));
    } catch (const std::bad_alloc&) {
        return std::string(1, kNoMemory);
    } catch (const std::exception& e) {  // IoError and InvalidInput, and the exceptions of a library
        const std::string prefix = path.string() + ": ", what = e.what();
        return kRefusal + (what.starts_with(prefix) ? what.substr(prefix.size()) : what);
    }
}

bool write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

std::string limits_line(const core::ChildLimits& limits) {
    return fmt::format("the limits are {} s of processor time and {} MB of memory", limits.time.count(), limits.memory_bytes >> 20);
}

/// @throws IoError naming why the reader returned no mesh
[[noreturn]] void refuse(const fs::path& path, const core::ChildResult& result, const core::ChildLimits& limits) {
    using End = core::ChildResult::End;
    const std::string reader = reader_of(path);
    const auto fail = [&path](const std::string& why) { throw core::IoError(path.string(), why); };
    if (result.end == End::kOutOfTime)
        fail(fmt::format("{} did not finish reading it; {}. The file is not valid or too large", reader, limits_line(limits)));
    if (result.end == End::kTooMuchOutput)
        fail(fmt::format("{} makes more than {} triangles of it; no more are read", reader, kMostTriangles));
    if (result.output.starts_with(kNoMemory)) fail(fmt::format("{} ran out of memory reading it; {}", reader, limits_line(limits)));
    if (result.output.starts_with(kRefusal)) fail(result.output.substr(1));
    fail(fmt::format("{} crashed reading it ({} {}): the file is not valid, or {} cannot read it", reader,
                     result.end == End::kSignalled ? "signal" : "exit code", result.code, reader));
    std::abort();
}

}  // namespace

core::ChildLimits reader_limits(const fs::path& path) {
    constexpr std::uintmax_t kMegabyte = 1 << 20;
    constexpr std::uintmax_t kSeconds = 10, kSecondsPerMegabyte = 30, kMostSeconds = 600, kMemoryPerByte = 20;
    constexpr int kClockPerProcessor = 10;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    const std::uintmax_t bytes = error ? 0 : std::min<std::uintmax_t>(size, kMostMeshBytes);
    core::ChildLimits limits;
    limits.time = std::chrono::seconds(std::min(kMostSeconds, kSeconds + kSecondsPerMegabyte * bytes / kMegabyte));
    limits.clock = kClockPerProcessor * limits.time;
    limits.memory_bytes = (std::size_t{2} << 30) + kMemoryPerByte * bytes;
    limits.output_bytes = kMostTriangles * (3 * sizeof(solid::Vec3) + sizeof(solid::Triangle)) + kMegabyte;
    return limits;
}

MeshFile read_mesh_isolated(const fs::path& path, const std::vector<std::string>& reader) {
    require_mesh_file(path);
    std::vector<std::string> words = reader;
    words.push_back(path.string());
    const core::ChildLimits limits = reader_limits(path);
    const core::ChildResult result = core::run_child(words, path.string(), limits);
    if (result.end == core::ChildResult::End::kExited && result.code == 0 && result.output.starts_with(kMesh))
        if (auto file = mesh_of(result.output)) return std::move(*file);
    refuse(path, result, limits);
}

int serve_mesh_file(const fs::path& path) {
    core::limit_this_process(reader_limits(path));
    // Libraries print to standard output; only the message may reach the calling process.
    const int out = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1), nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (out < 0 || nothing < 0 || ::dup2(nothing, STDOUT_FILENO) < 0) return 1;
    return write_all(out, answer(path)) ? 0 : 1;
}

}  // namespace fusee::exchange
