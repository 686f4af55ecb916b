#include <fmt/format.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "dice.h"
#include "fusee/core/file.h"
#include "generator.h"

namespace fusee::random_profiles {

namespace {

/// How a figure differs from the shipped one: by a factor within 1 +- `share`, in one of `often` profiles of 1.
struct Spread {
    double share, often;
};
const std::map<std::string, Spread> kSpreads{{"rig.capstan_radius_mm", {0.03, 0.3}},
                                             {"rig.joint_radius_mm", {0.2, 0.3}},
                                             {"rig.gear_friction", {0.03, 0.3}},
                                             {"law.k_per_Nm_rad", {0.04, 0.3}},
                                             {"law.c_Nm", {0.02, 0.3}},
                                             {"law.start_torque_Nm", {0.02, 0.3}},
                                             {"law.end_torque_Nm", {0.02, 0.3}},
                                             {"law.lead_in_deg", {0.3, 0.3}},
                                             {"cable.breaking_load_N", {0.1, 0.3}},
                                             {"groove.depth_ratio", {0.05, 0.2}},
                                             {"groove.throat_deg", {0.05, 0.2}},
                                             {"groove.rib_mm", {0.2, 0.3}},
                                             {"k_se.spring.rate_Nm_per_rad", {0.04, 0.4}},
                                             {"k_se.spring.preload_rad", {0.04, 0.4}},
                                             {"k_se.guide.distance_mm", {0.2, 0.5}},
                                             {"k_se.path.margin_deg", {0.15, 0.3}},
                                             {"k_se.hub.bore_mm", {0.1, 0.2}},
                                             {"k_pe.spring.rate_N_per_m", {0.04, 0.4}},
                                             {"k_pe.spring.preload_mm", {0.04, 0.4}},
                                             {"k_pe.guide.distance_mm", {0.2, 0.5}},
                                             {"k_pe.path.margin_deg", {0.15, 0.3}},
                                             {"k_pe.path.min_idle_radius_mm", {0.1, 0.3}},
                                             {"k_pe.hub.boss_mm", {0.1, 0.3}},
                                             {"k_pe.hub.boss_height_mm", {0.1, 0.3}}};

/// A line "key = value  # words" in its parts.
struct Line {
    std::string key, value;
};
Line parts(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || text.starts_with('#')) return {};
    const auto trimmed = [](std::string part) {
        part.erase(0, std::min(part.find_first_not_of(' '), part.size()));
        part.erase(part.find_last_not_of(' ') + 1);
        return part;
    };
    return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1, text.find('#') - equals - 1))};
}

std::string changed_value(Dice& dice, const std::string& key, const std::string& value, double cable_mm, const char* process) {
    if (key == "outputs.formats") return "[\"stl\", \"3mf\", \"dxf\"]";
    if (key == "tolerances.chordal_error_mm") return "0.004";
    if (key == "cable.diameter_mm" && cable_mm > 0.0) return fmt::format("{}", cable_mm);
    if (key == "process.kind" && *process != '\0') return fmt::format("\"{}\"", process);
    if (key.ends_with("guide.direction_deg") && dice.chance(0.3)) return fmt::format("{:.1f}", dice.between(-180.0, 180.0));
    const auto spread = kSpreads.find(key);
    if (spread == kSpreads.end() || !dice.chance(spread->second.often)) return value;
    double number = 0.0;
    if (std::from_chars(value.data(), value.data() + value.size(), number).ec != std::errc{}) return value;
    const double factor = 1.0 + dice.between(-spread->second.share, spread->second.share);
    return fmt::format("{:.4g}", number * factor);
}

}  // namespace

std::string near_profile(std::uint64_t seed, int number) {
    static constexpr std::array kBases{"pnrvsa", "pnrvsa_co_design", "free_curve", "from_dead_band"};
    Dice dice(seed, number);
    std::istringstream lines(core::read_file(fmt::format(FUSEE_SOURCE_DIR "/profiles/{}.toml", dice.one_of(kBases))));
    const double cable_mm = dice.chance(0.15) ? dice.one_of(std::array{0.6, 0.7, 1.0}) : 0.0;
    const char* process = dice.chance(0.2) ? dice.one_of(std::array{"sla", "sls"}) : "";
    std::string text, table;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('[')) table = line.substr(1, line.find(']') - 1);
        const auto [key, value] = parts(line);
        if (key.empty())
            text += line;
        else if (key == "name" && table.empty())
            text += fmt::format("name = \"near_{:05}\"", number);
        else
            text += key + " = " + changed_value(dice, table + "." + key, value, cable_mm, process);
        text += "\n";
    }
    return text;
}

}  // namespace fusee::random_profiles
