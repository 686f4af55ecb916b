#pragma once
#include <algorithm>

#include "exchange/fixtures/disc.h"
#include "fusee/core/file.h"
#include "fusee/formats/format.h"

namespace fusee::fixtures {

inline const formats::Format& format_of(const std::string& name) {
    const auto all = formats::all_formats();
    const auto found = std::find_if(all.begin(), all.end(), [&](const formats::Format& f) { return f.name == name; });
    EXPECT_NE(found, all.end()) << name;
    return found == all.end() ? all.front() : *found;
}

/// Writes a disc as k_se in one mesh format. @returns its part file, with that one file
inline exchange::PartFile only_file(const std::filesystem::path& folder, const std::string& name, const exchange::PartGuide& guide) {
    const formats::Format& format = format_of(name);
    const solid::Mesh mesh = disc_mesh({});
    const std::filesystem::path path = folder / (std::string("k_se") + format.extension);
    format.write_mesh(path, mesh, "k_se", "fusee test");
    exchange::PartFile part = disc_part({}, guide, 1, 1);
    part.files = {formats::file_row(path, mesh.triangles.size(), 0.002).entry};
    return part;
}

}  // namespace fusee::fixtures
