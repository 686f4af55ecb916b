#pragma once
#include <filesystem>
#include <string_view>

namespace fusee::exchange {

/// Checks a STEP file (ISO 10303-21) before OpenCASCADE reads it, which follows references to entities that are not there.
/// @throws core::IoError naming file and line: header or end missing, a reference to an entity that the file does not hold, one that it
///         holds twice, a number that is not finite, a word where a value belongs, parentheses nested deeper than 100 or left open
void require_sound_step(std::string_view bytes, const std::filesystem::path& path);

}  // namespace fusee::exchange
