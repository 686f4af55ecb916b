#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

#include "fusee/core/json.h"
#include "fusee/exchange/part_file.h"

namespace fusee::exchange {

using Json = nlohmann::ordered_json;
using core::JsonNode;

inline Json entry_json(const FileEntry& f) {
    return {{"name", f.name}, {"sha256", f.sha256}, {"triangles", f.triangles}, {"chordal_error_mm", f.chordal_error_mm}};
}

/// @throws core::InvalidInput naming file and key
inline FileEntry read_entry(const JsonNode& node) {
    FileEntry entry{node["name"].text(), node["sha256"].text(), node["triangles"].count(), node["chordal_error_mm"].number_at_least(0.0)};
    if (entry.name.empty() || std::filesystem::path(entry.name).filename() != entry.name)
        node["name"].refuse("a file name without a folder");
    return entry;
}

}  // namespace fusee::exchange
