#include "fusee/formats/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::formats {

namespace {

/// The bytes of a file. @throws IoError unless they have the stated hash
std::string stated_bytes(const fs::path& path, const exchange::FileEntry& entry) {
    std::string bytes = core::read_file(path);
    const std::string found = core::sha256_hex(bytes);
    if (found != entry.sha256) throw core::IoError(path.string(), fmt::format("SHA-256 is {}, not {} as stated", found, entry.sha256));
    return bytes;
}

/// nullptr: files of this kind are not read back.
const Format* reading_format(const fs::path& path) {
    const std::string extension = path.extension().string();
    bool known = false;
    for (const Format& format : all_formats()) {
        if (extension != format.extension) continue;
        if (format.read_back != nullptr) return &format;
        known = true;
    }
    if (!known) throw core::IoError(path.string(), "is of a kind that cannot be read back");
    return nullptr;
}

void append(std::vector<readback::ArmError>& errors, std::vector<readback::ArmError> found) {
    std::move(found.begin(), found.end(), std::back_inserter(errors));
}

/// The arms found in `read`, which `image` mirrors.
std::vector<readback::ArmError> taken_over(const ReadPart& part, const std::string& read, const std::string& image) {
    std::vector<readback::ArmError> errors;
    for (const readback::ArmError& error : part.errors) {
        if (error.file != read) continue;
        errors.push_back(error);
        errors.back().file = image;
        errors.back().mirror_of = read;
    }
    return errors;
}

}  // namespace

#include "format_registry.h"

std::span<const Format> all_formats() {
    static const std::vector<Format> all = [] {
        std::vector<Format> made;
        for (const Registered& file : kRegistered) {  // by name
            made.push_back(file.make());
            assert(made.back().name == std::string_view(file.id) && "a format's name is that of its file");
            assert((made.back().write == nullptr) != (made.back().write_mesh == nullptr) && "a format has one writer");
        }
        std::stable_sort(made.begin(), made.end(), [](const Format& a, const Format& b) { return a.place < b.place; });
        return made;
    }();
    return all;
}

std::vector<std::string> default_formats(const checks::Process& process) {
    std::vector<std::string> names;
    for (const Format& format : all_formats())
        if (format.by_default != nullptr && format.by_default(process)) names.emplace_back(format.name);
    return names;
}

void write_formats(PartExport& out, const std::vector<std::string>& names) {
    for (const Format& format : all_formats()) {
        if (std::find(names.begin(), names.end(), format.name) == names.end()) continue;
        if (format.write != nullptr) {
            format.write(out);
            continue;
        }
        const fs::path path = out.path(format.extension);
        format.write_mesh(path, out.mesh, out.name(), out.provenance.line());
        out.state(path, out.mesh.triangles.size(), out.part.chordal_error_mm);
    }
}

FileRow file_row(const fs::path& path, std::size_t triangles, double chordal_error_mm) {
    const std::string bytes = core::read_file(path);
    return {{path.filename().string(), core::sha256_hex(bytes), triangles, chordal_error_mm}, bytes.size()};
}

std::vector<readback::ArmError> read_back(const fs::path& folder, const exchange::PartFile& part) {
    std::vector<readback::ArmError> errors;
    for (const exchange::FileEntry& entry : part.files) {
        const fs::path path = folder / entry.name;
        (void)stated_bytes(path, entry);
        if (const Format* format = reading_format(path)) append(errors, format->read_back({path, entry, part}));
    }
    return errors;
}

std::vector<readback::ArmError> read_back_image(const fs::path& folder, const exchange::PartFile& image, const ReadPart& part) {
    const std::vector<exchange::FileEntry>& read = part.file.files;
    const bool same_law = exchange::is_mirror_image(image, part.file) && image.files.size() == read.size();
    std::vector<readback::ArmError> errors;
    for (std::size_t i = 0; i < image.files.size(); ++i) {
        const exchange::FileEntry& entry = image.files[i];
        const fs::path path = folder / entry.name;
        const std::string bytes = stated_bytes(path, entry);
        const Format* format = reading_format(path);
        if (format == nullptr) continue;
        const bool comparable = same_law && format->is_mirror_image != nullptr && entry.triangles == read[i].triangles;
        if (comparable && format->is_mirror_image(bytes, stated_bytes(folder / read[i].name, read[i])))
            append(errors, taken_over(part, read[i].name, entry.name));
        else
            append(errors, format->read_back({path, entry, image}));
    }
    return errors;
}

}  // namespace fusee::formats
