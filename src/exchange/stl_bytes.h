#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace fusee::exchange {

inline constexpr std::size_t kStlHeader = 80, kStlTriangle = 50;  ///< bytes; a count of 4 bytes is between them

/// Checks that it is a binary STL with exactly the length of its count of triangles, on which the readers rely, and finite corners.
/// @throws core::IoError
void require_binary_stl(const std::string& bytes, const std::filesystem::path& path);

/// The bytes of the file after this check. @throws core::IoError
[[nodiscard]] std::string read_stl_bytes(const std::filesystem::path& path);

}  // namespace fusee::exchange
