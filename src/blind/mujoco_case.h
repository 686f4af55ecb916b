#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "fusee/blind/blind.h"

namespace fusee::blind {

/// The program fusee-mujoco-plant. @throws core::InvalidInput "plant" if it is not installed
[[nodiscard]] std::string mujoco_plant();
/// A case whose rig moves in MuJoCo, held-out measurements included. Every byte follows from the arguments and MuJoCo's version.
/// @throws core::InvalidInput "plant" with the words of the program
void write_mujoco_case(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label);

}  // namespace fusee::blind
