#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fusee::core {

/// A profile key and its new value, both as TOML: {"k_se.hub.bore_mm", "5.2"}.
struct Change {
    std::string key, value;
};
/// Changes that are made together.
using Changes = std::vector<Change>;

/// The alternatives that a finding's suggestion names, in its order. A suggestion is a sentence for a person. Every `key = value` in it is
/// a change; ", or " and " (or " begin another alternative; any other text between two changes joins them:
///     k_pe.hub.bore_mm = 5.2, or k_pe.spring.rate_N_per_m = 9e3 with k_pe.spring.preload_mm = 4.1 (every arm x 0.9)
/// has two alternatives, the second of two changes. Values are numbers, texts in quotes, or arrays in one line. Advice without a key ("a
/// guide rod") is left out.
[[nodiscard]] std::vector<Changes> suggested_changes(std::string_view suggestion);

}  // namespace fusee::core
