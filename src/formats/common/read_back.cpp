#include <fmt/format.h>

#include <iterator>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"

namespace fs = std::filesystem;

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
