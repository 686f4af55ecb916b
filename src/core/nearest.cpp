#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/text.h"

namespace fusee::core {

namespace {

constexpr std::size_t kLongestCompared = 100;  // letters: known names have less than half as many

std::string small(std::string_view text) { return lower(text.substr(0, kLongestCompared)); }

struct Near {
    std::size_t distance;
    const std::string* name;
};

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d.back().back();
}

std::vector<std::string> near_names(std::string_view asked, const std::vector<std::string>& names, std::size_t most) {
    constexpr std::size_t kLeastBeginning = 3;  // letters that identify a name
    const std::string wanted = small(asked);
    std::vector<Near> near;
    for (const std::string& name : names) {
        const std::string known = small(name);
        const bool begins = wanted.size() >= kLeastBeginning && known.starts_with(wanted);
        const std::size_t distance = begins ? 1 : edit_distance(wanted, known);
        if (distance <= std::max<std::size_t>(1, known.size() / 3) && distance < wanted.size()) near.push_back({distance, &name});
    }
    std::stable_sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });
    std::vector<std::string> found;
    for (const Near& one : near)
        if (found.size() < most && std::find(found.begin(), found.end(), *one.name) == found.end()) found.push_back(*one.name);
    return found;
}

std::string did_you_mean(std::string_view asked, const std::vector<std::string>& names, std::string_view quote) {
    const std::vector<std::string> near = near_names(asked, names);
    if (near.empty()) return "";
    std::string text;
    for (std::size_t i = 0; i < near.size(); ++i)
        text += fmt::format("{}{}{}{}", i == 0 ? "" : i + 1 == near.size() ? " or " : ", ", quote, near[i], quote);
    return "; did you mean " + text + "?";
}

}  // namespace fusee::core
