#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace fusee::exchange {

inline constexpr std::size_t kStlHeader = 80, kStlTriangle = 50;  ///< bytes; a count of 4 bytes is between them

/// The bytes of the file after a check: a binary STL with exactly the length of its count of triangles and finite corners. The readers rely
/// on the count.
/// @throws IoError
[[nodiscard]] std::string read_stl_bytes(const std::filesystem::path& path);

}  // namespace fusee::exchange
