#include "manifest.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/provenance.h"
#include "fusee/core/resource_error.h"

namespace fusee::core {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestManifest = 50'000'000;  // bytes
constexpr int kManifestDepth = 4;

bool is_utf8(const std::string& text) {
    try {
        (void)Json(text).dump();
        return true;
    } catch (const Json::type_error&) {
        return false;
    }
}

std::string encoded(const std::string& text) {
    const bool readable = is_utf8(text);
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        result += c == '%' || (!readable && byte >= 0x80) ? fmt::format("%{:02X}", byte) : std::string(1, c);
    }
    return result;
}

std::string decoded(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned byte = 0;
        const char* const begin = text.data() + i + 1;
        if (text[i] == '%' && i + 2 < text.size() && std::from_chars(begin, begin + 2, byte, 16).ptr == begin + 2) {
            result += static_cast<char>(byte);
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

/// A plain name below the folder: no "..", not absolute, not the manifest.
bool is_inside(const fs::path& name) {
    if (name.empty() || name.is_absolute() || name != name.lexically_normal() || name.filename().empty()) return false;
    for (const fs::path& part : name)
        if (part == ".." || part == ".") return false;
    return name != kManifestName && name.string().find('\0') == std::string::npos;
}

MadeFile made_file(const Json& json) {
    MadeFile file;
    file.command = json.at("command").get<std::string>();
    file.source = decoded(json.at("source").get<std::string>());
    file.sha256 = json.at("sha256").get<std::string>();
    file.earlier = json.value("earlier", std::string());
    file.sheet = json.value("sheet", false);
    return file;
}

/// Starts writing to the disk; many files are then written in parallel.
void begin_sync(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    (void)::sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE);
    ::close(file);
}

}  // namespace

std::optional<Manifest> read_manifest(const OpenFolder& folder) {
    const OpenFolder::Kind kind = folder.kind(kManifestName);
    if (kind == OpenFolder::Kind::kNone) return std::nullopt;
    const auto damaged = [&folder](const std::string& why) {
        return IoError((folder.shown() / kManifestName).string(),
                       "the list of files that fusee made here is damaged (" + why +
                           "): restore it, move the folder away or choose another one; nothing was written");
    };
    if (kind != OpenFolder::Kind::kFile) throw damaged("it is not a file");
    std::string text;
    folder.read(kManifestName, [&](std::string_view piece) {
        if (text.append(piece).size() > kLargestManifest) throw damaged(fmt::format("it is larger than {} bytes", kLargestManifest));
    });
    const auto shallow = [](int depth, Json::parse_event_t, const Json&) { return depth <= kManifestDepth; };
    const Json json = Json::parse(text, shallow, false);
    if (!json.is_object() || !json.contains("files") || !json["files"].is_object()) throw damaged("no files");
    Manifest manifest;
    for (const auto& [name, entry] : json["files"].items()) {
        const std::string file = decoded(name);
        if (!is_inside(file)) throw damaged("\"" + name + "\" is not inside the folder");
        try {
            manifest[file] = made_file(entry);
        } catch (const Json::exception&) {
            throw damaged("\"" + name + "\" lacks command, source or sha256");
        }
    }
    return manifest;
}

std::string manifest_text(const Manifest& manifest) {
    Json files = Json::object();
    for (const auto& [name, file] : manifest) {
        Json& entry = files[encoded(name)];
        entry = {{"command", file.command}, {"source", encoded(file.source)}, {"sha256", file.sha256}};
        if (!file.earlier.empty()) entry["earlier"] = file.earlier;
        if (file.sheet) entry["sheet"] = true;
    }
    const Json json{{"fusee", version()}, {"about", "Files that fusee made here. It replaces and removes no others."}, {"files", files}};
    return json.dump(1) + "\n";
}

std::string write_failure(int error) {
    return std::string(std::strerror(error)) + (error == EFBIG ? " (ulimit -f states the largest size of a file)" : "");
}

bool is_lack(int error) {
    constexpr std::array kLacks{ENOSPC, EDQUOT, EFBIG, EIO, EMFILE, ENFILE, ENOMEM, EAGAIN};
    return std::find(kLacks.begin(), kLacks.end(), error) != kLacks.end();
}

void refuse_write(const std::string& path, int error) {
    const std::string why = "cannot be written: " + write_failure(error);
    if (is_lack(error)) throw ResourceError(path, why);
    throw IoError(path, why);
}

void sync(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    const int failed = ::fsync(file) != 0 ? errno : 0;
    ::close(file);
    if (failed == EIO || failed == ENOSPC || failed == EDQUOT) refuse_write(path.string(), failed);
}

void sync_tree(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    for (const fs::path& path : files) begin_sync(path);
    for (const fs::path& path : files) sync(path);
}

const char* version() { return FUSEE_VERSION; }

std::string Provenance::line() const {
    return fmt::format("fusee {}, {}, profile {}{}{}", version(), name, profile_sha256.substr(0, 12), options.empty() ? "" : ", ", options);
}

}  // namespace fusee::core
