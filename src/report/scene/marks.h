#pragma once
#include <map>
#include <string>

namespace fusee::report {

/// Colours of a scene that marks places: bodies by name, cables as "series cable, agonist". All others are pale.
using Marks = std::map<std::string, std::string>;

inline constexpr const char* kPaleMark = "#c9ced6";

inline std::string mark_of(const Marks& marks, const std::string& name) {
    const auto mark = marks.find(name);
    return mark != marks.end() ? mark->second : kPaleMark;
}

}  // namespace fusee::report
