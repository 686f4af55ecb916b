#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "fusee/blind/blind.h"

namespace fusee::blind {

/// Does a program fusee-NAME-plant move the rig?
[[nodiscard]] bool is_engine(Maker maker);
/// This program. @pre is_engine(maker) @throws core::InvalidInput "plant" if it is not installed
[[nodiscard]] std::string engine_program(Maker maker);
/// A case whose rig another engine moves, held-out measurements included. Every byte follows from the arguments and the engine's version.
/// @throws core::InvalidInput "plant" with the words of the program
void write_engine_case(Maker maker, const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label);

}  // namespace fusee::blind
