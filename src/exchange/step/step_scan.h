#pragma once
#include <filesystem>
#include <string_view>

namespace fusee::exchange {

/// Checks a STEP file (ISO 10303-21) before OpenCASCADE reads it: OpenCASCADE follows references to missing entities.
/// @throws core::IoError naming file and line: header or end missing, a reference to a missing entity, an entity
///         defined twice, a number that is not finite, a word in the place of a value, parentheses that are nested deeper than 100 or not
///         closed
void require_sound_step(std::string_view bytes, const std::filesystem::path& path);

}  // namespace fusee::exchange
