#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fusee::core {

/// Least number of letters to insert, delete, replace or swap with the next one (optimal string alignment).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The names that a person may have meant by `asked`, nearest first, at most `most`; of equally near ones the earlier first. Near is a name
/// that differs by a third of its letters at most, or that begins with `asked` of three letters or more; capitals do not count. Empty: no
/// name is near.
[[nodiscard]] std::vector<std::string> near_names(std::string_view asked, const std::vector<std::string>& names, std::size_t most = 3);

/// "; did you mean make or fix?"; "" if no name is near. `quote` stands around each name.
[[nodiscard]] std::string did_you_mean(std::string_view asked, const std::vector<std::string>& names, std::string_view quote = "");

}  // namespace fusee::core
