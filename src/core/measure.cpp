#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "fusee/core/csv.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"

namespace fusee::core {

namespace {

/// Grouped by quantity, SI first. A kilogram-force has 9.80665 N, an inch 25.4 mm, a pound-force 4.4482216152605 N: exact by definition.
constexpr std::array kUnits{MeasureUnit{"rad", "angle"},
                            MeasureUnit{"mrad", "angle", 1, 1e3},
                            MeasureUnit{"deg", "angle", kPi, 180},
                            MeasureUnit{"turn", "angle", 2 * kPi, 1},
                            MeasureUnit{"Nm", "torque"},
                            MeasureUnit{"mNm", "torque", 1, 1e3},
                            MeasureUnit{"uNm", "torque", 1, 1e6},
                            MeasureUnit{"kNm", "torque", 1e3, 1},
                            MeasureUnit{"Ncm", "torque", 1, 1e2},
                            MeasureUnit{"Nmm", "torque", 1, 1e3},
                            MeasureUnit{"kgfm", "torque", 9.80665, 1},
                            MeasureUnit{"kgfcm", "torque", 9.80665, 1e2},
                            MeasureUnit{"gfcm", "torque", 9.80665, 1e5},
                            MeasureUnit{"ozfin", "torque", 4.4482216152605 * 0.0254, 16},
                            MeasureUnit{"lbfin", "torque", 4.4482216152605 * 0.0254, 1},
                            MeasureUnit{"lbfft", "torque", 4.4482216152605 * 0.3048, 1},
                            MeasureUnit{"N", "force"},
                            MeasureUnit{"mN", "force", 1, 1e3},
                            MeasureUnit{"cN", "force", 1, 1e2},
                            MeasureUnit{"kN", "force", 1e3, 1},
                            MeasureUnit{"kgf", "force", 9.80665, 1},
                            MeasureUnit{"gf", "force", 9.80665, 1e3},
                            MeasureUnit{"lbf", "force", 4.4482216152605, 1},
                            MeasureUnit{"m", "length"},
                            MeasureUnit{"cm", "length", 1, 1e2},
                            MeasureUnit{"mm", "length", 1, 1e3},
                            MeasureUnit{"um", "length", 1, 1e6},
                            MeasureUnit{"in", "length", 0.0254, 1},
                            MeasureUnit{"s", "time"},
                            MeasureUnit{"ms", "time", 1, 1e3},
                            MeasureUnit{"us", "time", 1, 1e6},
                            MeasureUnit{"min", "time", 60, 1},
                            MeasureUnit{"kg", "mass"},
                            MeasureUnit{"g", "mass", 1, 1e3},
                            MeasureUnit{"m/s", "speed"},
                            MeasureUnit{"mm/s", "speed", 1, 1e3},
                            MeasureUnit{"mm/min", "speed", 1, 60e3},
                            MeasureUnit{"Nm/rad", "rotational stiffness"},
                            MeasureUnit{"mNm/rad", "rotational stiffness", 1, 1e3},
                            MeasureUnit{"Nmm/rad", "rotational stiffness", 1, 1e3},
                            MeasureUnit{"Nm/deg", "rotational stiffness", 180, kPi},
                            MeasureUnit{"mNm/deg", "rotational stiffness", 180, 1e3 * kPi},
                            MeasureUnit{"Nmm/deg", "rotational stiffness", 180, 1e3 * kPi},
                            MeasureUnit{"N/m", "stiffness"},
                            MeasureUnit{"kN/m", "stiffness", 1e3, 1},
                            MeasureUnit{"N/mm", "stiffness", 1e3, 1},
                            MeasureUnit{"N/cm", "stiffness", 1e2, 1},
                            MeasureUnit{"Pa", "stress"},
                            MeasureUnit{"kPa", "stress", 1e3, 1},
                            MeasureUnit{"MPa", "stress", 1e6, 1},
                            MeasureUnit{"GPa", "stress", 1e9, 1},
                            MeasureUnit{"N/mm2", "stress", 1e6, 1}};

using Rewrite = std::pair<std::string_view, std::string_view>;
/// Spellings inside a unit.
constexpr std::array kUnitSpellings{Rewrite{"\xC2\xB0", "deg"},
                                    Rewrite{"\xC2\xBA", "deg"},
                                    Rewrite{"\xC2\xB5", "u"},
                                    Rewrite{"\xCE\xBC", "u"},
                                    Rewrite{"\xC2\xB7", ""},
                                    Rewrite{"\xE2\x8B\x85", ""},
                                    Rewrite{"\xE2\x88\x99", ""},
                                    Rewrite{"\xE2\x80\xA2", ""},
                                    Rewrite{"\xC3\x97", ""},
                                    Rewrite{"\xC2\xB2", "2"},
                                    Rewrite{"\xC2\xA0", ""},
                                    Rewrite{"\xE2\x80\xAF", ""},
                                    Rewrite{"\xE2\x81\xBB\xC2\xB9", "-1"},
                                    Rewrite{"_per_", "/"},
                                    Rewrite{"degree", "deg"},
                                    Rewrite{"Grad", "deg"},
                                    Rewrite{"radian", "rad"},
                                    Rewrite{"rad-1", "/rad"},
                                    Rewrite{"-lb", "lb"},
                                    Rewrite{"-in", "in"},
                                    Rewrite{"-ft", "ft"},
                                    Rewrite{"N-", "N"}};
/// Spellings of a whole unit.
constexpr std::array kUnitNames{Rewrite{"degs", "deg"},   Rewrite{"rads", "rad"},   Rewrite{"turns", "turn"},     Rewrite{"rev", "turn"},
                                Rewrite{"sec", "s"},      Rewrite{"seconds", "s"},  Rewrite{"msec", "ms"},        Rewrite{"usec", "us"},
                                Rewrite{"inch", "in"},    Rewrite{"\"", "in"},      Rewrite{"kgcm", "kgfcm"},     Rewrite{"gcm", "gfcm"},
                                Rewrite{"ozin", "ozfin"}, Rewrite{"lbin", "lbfin"}, Rewrite{"inlb", "lbfin"},     Rewrite{"lbft", "lbfft"},
                                Rewrite{"ftlb", "lbfft"}, Rewrite{"Newton", "N"},   Rewrite{"Newtonmeter", "Nm"}, Rewrite{"m_s", "m/s"},
                                Rewrite{"mm_s", "mm/s"}};

std::string_view bare(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n_");
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n_") - first + 1);
}

constexpr std::string_view kOpen = "([{<", kClose = ")]}>";

std::string plain_unit(std::string_view text) {
    std::string unit(bare(text));
    if (unit.size() > 2 && kOpen.find(unit.front()) != std::string_view::npos && kClose.find(unit.back()) != std::string_view::npos)
        unit = unit.substr(1, unit.size() - 2);
    std::erase_if(unit, [](char c) { return std::string_view(" \t.*^()").find(c) != std::string_view::npos; });
    for (const auto& [from, to] : kUnitSpellings)
        for (std::size_t at = unit.find(from); at != std::string::npos; at = unit.find(from, at + to.size()))
            unit.replace(at, from.size(), to);
    const Rewrite* known = find_by(kUnitNames, &Rewrite::first, unit);
    return known == nullptr ? unit : std::string(known->second);
}

/// Letters and figures in lower case: "Motor_Torque" and "motorTorque" are one. A single letter keeps its case: t is a time, T is not.
std::string stem_of(std::string_view text) {
    std::string stem;
    for (const char c : text)
        if (static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)) != 0) stem += c;
    return stem.size() > 1 ? lower(stem) : stem;
}

/// "torque_Nm", "angle deg", "v_m_s", "stiffness_Nm_per_rad": a unit behind the last separators.
Measured with_ending(std::string_view name) {
    std::size_t from = name.size();
    Measured found{stem_of(name), "", nullptr};
    for (int words = 1; words <= 3 && from != 0; ++words) {
        from = name.find_last_of(" _", from - 1);
        if (from == std::string_view::npos || from == 0) break;
        if (const MeasureUnit* unit = find_measure_unit(name.substr(from + 1)))
            found = {stem_of(name.substr(0, from)), std::string(name.substr(from + 1)), unit};
    }
    return found;
}

}  // namespace

const MeasureUnit* find_measure_unit(std::string_view text) {
    const std::string name = plain_unit(text);
    if (const MeasureUnit* exact = find_by(kUnits, &MeasureUnit::name, name)) return exact;
    // In one case throughout: "mPa" is no MPa, "MNM" may be no mNm, and one letter alone is another unit: "S" is siemens.
    const bool one_case =
        std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isupper(c); }) ||
        (std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::islower(c); }) && !name.starts_with("MN"));
    const auto alike = [&, small = lower(name)](const MeasureUnit& unit) {
        return small == lower(unit.name) && (one_case || std::string_view(unit.quantity) == "angle");
    };
    const auto found = std::find_if(kUnits.begin(), kUnits.end(), alike);
    return name.size() < 2 || found == kUnits.end() ? nullptr : &*found;
}

std::span<const MeasureUnit> measure_units(std::string_view quantity) {
    const auto of = [quantity](const MeasureUnit& unit) { return quantity == unit.quantity; };
    const auto first = std::find_if(kUnits.begin(), kUnits.end(), of);
    return {first, std::find_if_not(first, kUnits.end(), of)};
}

std::string measure_unit_names(std::string_view quantity) { return listed(measure_units(quantity), &MeasureUnit::name); }

Measured measured_name(std::string_view name) {
    name = bare(name);
    std::string_view stem, unit;
    const auto ends_with_word = [](std::string_view text, std::string_view word) {
        return text.size() > word.size() && text.ends_with(word) &&
               std::string_view(" _").find(text[text.size() - word.size() - 1]) != std::string_view::npos;
    };
    if (!name.empty() && kClose.find(name.back()) != std::string_view::npos) {
        const std::size_t open = name.rfind(kOpen[kClose.find(name.back())]);
        if (open != std::string_view::npos && open > 0) stem = bare(name.substr(0, open)), unit = name.substr(open);
        if (stem.ends_with('/')) stem.remove_suffix(1);
    }
    if (unit.empty()) {
        if (const Measured ending = with_ending(name); ending.unit != nullptr) {
            unit = bare(name).substr(name.size() - ending.unit_text.size());
            stem = bare(name.substr(0, name.size() - unit.size()));
            if (stem.ends_with('/') || stem.ends_with(',')) stem.remove_suffix(1);
        } else if (const std::size_t slash = name.find('/'); slash != std::string_view::npos && slash > 0) {
            stem = name.substr(0, slash), unit = name.substr(slash + 1);
        } else {
            return {stem_of(name), "", nullptr};
        }
    }
    stem = bare(stem);
    if (ends_with_word(stem, "in")) stem.remove_suffix(3);
    std::string shown(bare(unit));
    if (shown.size() > 2 && kOpen.find(shown.front()) != std::string_view::npos) shown = bare(shown.substr(1, shown.size() - 2));
    if (shown == "-" || shown == "1") shown.clear();
    return {stem_of(stem), shown, find_measure_unit(unit)};
}

}  // namespace fusee::core
