#include "fusee/formats/format.h"

#include <algorithm>
#include <cassert>

#include "fusee/core/file.h"

namespace fs = std::filesystem;

namespace fusee::formats {

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

}  // namespace fusee::formats
