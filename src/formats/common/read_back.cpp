#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/formats/format.h"

namespace fs = std::filesystem;

namespace fusee::formats {

namespace {

void require_entry(const fs::path& path, const exchange::FileEntry& entry) {
    const std::string found = core::sha256_hex(core::read_file(path));
    if (found != entry.sha256) throw core::IoError(path.string(), fmt::format("SHA-256 is {}, not {} as stated", found, entry.sha256));
}

/// nullptr: files of this kind are not read back.
readback::LawReader reader_of(const fs::path& path) {
    const std::string extension = path.extension().string();
    bool known = false;
    for (const Format& format : all_formats()) {
        if (extension != format.extension) continue;
        if (format.read_back != nullptr) return format.read_back;
        known = true;
    }
    if (!known) throw core::IoError(path.string(), "is of a kind that cannot be read back");
    return nullptr;
}

}  // namespace

std::vector<readback::ArmError> read_back(const fs::path& folder, const exchange::PartFile& part) {
    std::vector<readback::ArmError> errors;
    for (const exchange::FileEntry& entry : part.files) {
        const fs::path path = folder / entry.name;
        require_entry(path, entry);
        const readback::LawReader reader = reader_of(path);
        if (reader == nullptr) continue;
        std::vector<readback::ArmError> found = reader({path, entry, part});
        std::move(found.begin(), found.end(), std::back_inserter(errors));
    }
    return errors;
}

}  // namespace fusee::formats
