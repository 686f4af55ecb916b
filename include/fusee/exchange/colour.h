#pragma once
#include <array>
#include <cstdint>

namespace fusee::exchange {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue (sRGB)

}  // namespace fusee::exchange
