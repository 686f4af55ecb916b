#pragma once
#include <filesystem>

#include "fusee/exchange/part_file.h"
#include "json_node.h"

namespace fusee::exchange {

inline Json entry_json(const FileEntry& f) {
    return {{"name", f.name}, {"sha256", f.sha256}, {"triangles", f.triangles}, {"chordal_error_mm", f.chordal_error_mm}};
}

/// @throws IoError naming file and key
inline FileEntry read_entry(const Node& node) {
    FileEntry entry{node.at("name").text(), node.at("sha256").text(), node.at("triangles").count(),
                    node.at("chordal_error_mm").number(0.0)};
    if (std::filesystem::path(entry.name).filename() != entry.name) node.at("name").fail("must be a file name without a folder");
    return entry;
}

}  // namespace fusee::exchange
