#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace fusee::exchange {

inline constexpr std::size_t kStlHeader = 80, kStlTriangle = 50;  ///< bytes; a count of 4 bytes stands between them

/// The file's bytes, proven to be a binary STL of exactly the length that its count asks for, with finite corners: the readers behind it
/// trust the count.
/// @throws IoError
[[nodiscard]] std::string read_stl_bytes(const std::filesystem::path& path);

}  // namespace fusee::exchange
