#pragma once
#include <cstdint>
#include <filesystem>

#include "fusee/blind/blind.h"

namespace fusee::blind {

/// Replaces the measurements of a case, held-out ones included, by predictions of the model for a rig with the label's effects, build
/// tolerances and sensor noise. Every byte follows from the arguments and the case.
void measure_by_model(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label);

}  // namespace fusee::blind
