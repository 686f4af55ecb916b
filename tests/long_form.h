#pragma once
#include <cstdlib>
#include <vector>

namespace fusee::fixtures {

/// Whether tests run in their long form: FUSEE_LONG_TESTS is set (docs/robustness.md). `./fusee test` runs the short one.
inline bool long_form() { return std::getenv("FUSEE_LONG_TESTS") != nullptr; }

/// How many cases a test tries: `few` in its short form, `all` in its long one.
inline int case_count(int few, int all) { return long_form() ? all : few; }

/// The first `few` of these cases in the short form, all of them in the long one.
template <class Case>
std::vector<Case> some_of(std::vector<Case> all, std::size_t few) {
    if (!long_form() && few < all.size()) all.erase(all.begin() + static_cast<std::ptrdiff_t>(few), all.end());
    return all;
}

}  // namespace fusee::fixtures
