#pragma once
#include <cstdint>
#include <filesystem>

#include "fusee/blind/blind.h"

namespace fusee::blind {

/// Takes a whole case and puts what the model predicts for a rig with the label's effects, with build tolerances and sensor noise, in place
/// of its measurements, held out ones included. Every byte follows from the arguments and the case.
void measure_by_model(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label);

}  // namespace fusee::blind
