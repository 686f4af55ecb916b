#pragma once
#include <string_view>

#include "fusee/exchange/part_file.h"

/// Proofs from what was written that files of one part are the mirror images of another's, y -> -y. They compare numbers exactly (0 = -0):
/// what is proven here has the same lever arms, and need not be read back a second time.
namespace fusee::exchange {

/// Everything from which arms are recomputed: cable, signs, guide, spring, and each row with its contact. Their files may differ.
[[nodiscard]] bool is_mirror_image(const PartFile& image, const PartFile& part);

/// The bytes of two binary STL files, headers apart: triangle by triangle in the same order, each with its corners the other way round.
[[nodiscard]] bool is_mirrored_stl(std::string_view image, std::string_view stl);

}  // namespace fusee::exchange
