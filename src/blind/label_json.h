#pragma once
#include <nlohmann/json.hpp>

#include "fusee/blind/blind.h"

namespace fusee::blind {

/// The effects of a label: [{"extra": {NAME: value}, "id", "side", "size"}].
[[nodiscard]] nlohmann::json effects_json(const Label& label);

}  // namespace fusee::blind
