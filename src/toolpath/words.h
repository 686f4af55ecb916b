#pragma once
#include <string>
#include <vector>

#include "fusee/toolpath/read_back.h"

namespace fusee::toolpath {

/// The pose at a share of the way.
[[nodiscard]] inline Pose between(const Pose& a, const Pose& b, double s) {
    return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z), a.a + s * (b.a - a.a)};
}

/// A number in a comment. @throws IoError naming the file
[[nodiscard]] double number_in(const Interpreted& program, const std::vector<std::string>& words, std::size_t which);
/// The words of the first comment that begins with `begin` and has `count` words; empty if there is none.
[[nodiscard]] std::vector<std::string> find_words(const Interpreted& program, const std::string& begin, std::size_t count);

}  // namespace fusee::toolpath
