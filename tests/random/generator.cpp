#include "generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "dice.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "fusee/spring/law.h"

namespace fusee::random_profiles {

namespace {

std::string stiction_law(Dice& dice) {
    const double c = dice.between(0.2, 0.4), start = dice.between(1.2, 2.6) * c;
    return fmt::format(
        "kind = \"stiction_compensating\"\nk_per_Nm_rad = {}\nu_Nm = {}\nc_Nm = {}\nstart_torque_Nm = {}\nend_torque_Nm = {}\n",
        dice.between(0.1, 0.8), dice.between(0.0, 0.02), c, start, start * dice.between(1.5, 3.5));
}

std::string polynomial_law(Dice& dice) {
    const double series = dice.between(0.05, 0.3), parallel = dice.between(0.1, 0.5), start = dice.between(0.05, 0.3);
    return fmt::format(
        "kind = \"polynomial\"\nseries_Nm = [0.0, {}, {}]\nparallel_Nm = [0.0, {}, {}]\nstart_torque_Nm = {}\nend_torque_Nm = {}\n", series,
        series * dice.between(0.1, 0.8), parallel, parallel * dice.between(0.05, 0.4), start, start * dice.between(3.0, 12.0));
}

std::string exponential_law(Dice& dice) {
    const double start = dice.between(0.1, 0.5);
    return fmt::format(
        "kind = \"exponential\"\nseries_scale_Nm = {}\nseries_rate_per_rad = {}\nseries_offset_Nm = {}\nparallel_scale_Nm = {}\n"
        "parallel_rate_per_rad = {}\nparallel_offset_Nm = {}\nstart_torque_Nm = {}\nend_torque_Nm = {}\n",
        dice.between(0.02, 0.2), dice.between(0.5, 2.0), dice.between(0.0, 0.05), dice.between(0.05, 0.3), dice.between(0.2, 1.0),
        dice.between(0.0, 0.05), start, start * dice.between(2.0, 6.0));
}

std::string law_from_dead_band(Dice& dice) {
    const double start = dice.between(0.3, 0.7);
    return fmt::format(
        "kind = \"from_dead_band\"\ndead_band_deg = \"{} * exp(-{} * tau)\"\nstart_transmission = {}\nstart_torque_Nm = {}\n"
        "end_torque_Nm = {}\n",
        dice.between(40.0, 160.0), dice.between(0.5, 1.5), dice.between(0.3, 0.7), start, start * dice.between(1.5, 3.5));
}

std::string free_law(Dice& dice) {
    const double start = dice.between(0.3, 0.7), ratio = dice.between(1.15, 1.4), share = dice.between(0.2, 0.6);
    const double stiffness = dice.between(0.02, 0.2), growth = dice.between(1.2, 1.8), fall = dice.between(0.85, 1.0);
    std::string loads, series, transmission;
    for (int i = 0; i < 5; ++i) {
        const char* comma = i > 0 ? ", " : "";
        loads += fmt::format("{}{}", comma, start * std::pow(ratio, i));
        series += fmt::format("{}{}", comma, stiffness * std::pow(growth, i));
        transmission += fmt::format("{}{}", comma, share * std::pow(fall, i));
    }
    return fmt::format("kind = \"free_curve\"\nloads_Nm = [{}]\nseries_Nm_per_rad = [{}]\ntransmission = [{}]\n", loads, series,
                       transmission);
}

struct Rig {
    std::string text;
    double capstan_radius_mm = 0.0;
};

Rig rig_and_law(Dice& dice) {
    const double radius = dice.between(15.0, 45.0), peak = dice.between(0.6, 1.4);
    const std::array laws{stiction_law, polynomial_law, exponential_law, law_from_dead_band, free_law};
    std::string text = fmt::format(
        "[rig]\ncapstan_radius_mm = {}\njoint_radius_mm = {}\ngear_friction = {}\nleast_torque_Nm = {}\npeak_torque_Nm = {}\n"
        "overdrive_torque_Nm = {}\n\n[law]\n{}",
        radius, dice.between(15.0, 45.0), dice.between(0.1, 0.4), 0.8 * peak, peak, 1.2 * peak, dice.one_of(laws)(dice));
    text += fmt::format("lead_in_deg = {}\n", dice.chance(0.5) ? 0.0 : dice.between(1.0, 6.0));
    return {text, radius};
}

/// One base spring, and what a cam on it has.
struct Base {
    std::string text;
    double least_arm_mm = 0.0;  ///< at the law's ends
    double turn_rad = 0.0;      ///< over the law
};

/// Preload and first arm are drawn; the rate follows from them (docs/theory/cams.md, table 1).
Base series_spring(Dice& dice, double capstan_radius_mm, const spring::LawPoint& lowest, const spring::LawPoint& highest) {
    const double arm_mm = dice.between(12.0, 25.0), winding = dice.between(1.0, 6.0);
    const double rate = arm_mm * lowest.f_se / capstan_radius_mm / winding;
    const double wound = std::sqrt(winding * winding + 2.0 * (highest.u_se - lowest.u_se) / rate);
    return {fmt::format("[k_se.spring]\nrate_Nm_per_rad = {}\npreload_rad = {}\n\n", rate, winding),
            std::min(arm_mm, rate * wound * capstan_radius_mm / highest.f_se), wound - winding};
}

Base parallel_spring(Dice& dice, const spring::LawPoint& lowest, const spring::LawPoint& highest) {
    const double arm_mm = dice.between(3.0, 12.0), compression_mm = dice.between(4.0, 30.0);
    const double rate = lowest.f_pe / (arm_mm * compression_mm * 1e-6);
    const double compressed_mm = 1e3 * std::sqrt(compression_mm * compression_mm * 1e-6 + 2.0 * (highest.u_pe - lowest.u_pe) / rate);
    return {fmt::format("[k_pe.spring]\nrate_N_per_m = {}\npreload_mm = {}\n\n", rate, compression_mm),
            std::min(arm_mm, highest.f_pe / (rate * compressed_mm * 1e-6)), highest.theta - lowest.theta};
}

std::string guide(Dice& dice) {
    const double direction = dice.between(-180.0, 180.0);
    if (dice.chance(0.5)) return fmt::format("kind = \"parallel\"\ndirection_deg = {}\ndistance_mm = 10000\n", direction);
    std::string text =
        fmt::format("direction_deg = {}\ndistance_mm = {}\nz_mm = {}\n", direction, dice.between(80.0, 300.0), dice.between(0.0, 4.0));
    if (dice.chance(0.5)) return "kind = \"point\"\n" + text;
    return fmt::format("kind = \"idler\"\nradius_mm = {}\nsense = {}\n{}", dice.between(5.0, 15.0), dice.chance(0.5) ? 1 : -1, text);
}

struct Path {
    std::string text;
    bool helix = false;
};

Path path(Dice& dice, bool aims, double turn_rad) {
    constexpr double kMostPlanar = 5.0;  // [rad]
    const std::string margin = fmt::format("margin_deg = {}\n", dice.between(15.0, 60.0));
    if (turn_rad < kMostPlanar && dice.chance(0.7))
        return {margin + fmt::format("kind = \"planar\"\nmin_idle_radius_mm = {}\n", dice.between(1.0, 2.5))};
    if (aims && dice.chance(0.5)) return {margin + "kind = \"helix\"\nlead = \"aimed\"\n", true};
    return {margin + fmt::format("kind = \"helix\"\npitch_mm = {}\n", dice.between(3.0, 8.0)), true};
}

/// A part whose arms leave no room for a shaft stands on a boss.
std::string hub(Dice& dice, double arm_mm) {
    constexpr double kWall_mm = 3.5;  // what bore and key need around them
    const double bore = std::clamp(std::floor(2.0 * (arm_mm - kWall_mm)), 4.0, 8.0);
    if (arm_mm < 0.5 * bore + kWall_mm)
        return "bore_mm = 6.0\nkind = \"overhung\"\nlock = \"keyway\"\nboss_mm = 16.0\nboss_height_mm = 12.0\n";
    return fmt::format("bore_mm = {}\nlock = \"{}\"\n", bore, dice.one_of(std::array{"plain", "keyway", "d_flat"}));
}

std::string part(Dice& dice, const char* name, const Base& base) {
    const std::string leads = guide(dice);
    const Path way = path(dice, leads.find("parallel") == std::string::npos, base.turn_rad);
    return base.text +
           fmt::format(
               "[{0}]\ntorque_sign = {1}\n\n[{0}.guide]\n{2}\n[{0}.path]\n{3}\n[{0}.hub]\n{4}\n[{0}.features]\nanchor_hole_mm = {5}\n\n",
               name, dice.chance(0.8) ? 1 : -1, leads, way.text, hub(dice, base.least_arm_mm), way.helix ? 0.0 : 2.0);
}

/// The costly formats are asked for now and then.
std::string shop(Dice& dice, double cable_mm) {
    std::string formats = "\"stl\", \"3mf\", \"dxf\"";
    if (dice.chance(0.3)) formats += ", \"scad\"";
    if (dice.chance(0.05)) formats += ", \"step\"";
    if (dice.chance(0.05)) formats += ", \"ngc\"";
    return fmt::format(
        "[cable]\ndiameter_mm = {}\nconstruction = \"{}\"\n\n[groove]\nthroat_deg = {}\nrib_mm = {}\n\n[process]\nkind = \"{}\"\n"
        "build_mm = [200.0, 200.0, 200.0]\n\n[tolerances]\nchordal_error_mm = 0.004\n\n[outputs]\nformats = [{}]\n\n",
        cable_mm, dice.one_of(std::array{"fibre", "fibre", "fibre", "7x49"}), dice.between(80.0, 100.0), dice.between(0.8, 2.0),
        dice.one_of(std::array{"fdm", "sla", "sls", "mill", "mill4", "edm", "laser"}), formats);
}

}  // namespace

std::string random_profile(std::uint64_t seed, int number) {
    Dice dice(seed, number);
    const std::string name = fmt::format("name = \"random_{:05}\"\n\n", number);
    const Rig rig = rig_and_law(dice);
    const profile::Profile law_only = profile::parse_profile(name + rig.text, std::filesystem::path("random.toml"));
    const auto design = pipeline::resolve(law_only);
    // Without a law the design is refused for any springs.
    spring::LawPoint lowest{.f_se = 0.1, .f_pe = 0.1}, highest = lowest;
    if (design) {
        const core::Range loads = design->law()->loads();
        lowest = design->law()->at_load(loads.low);
        highest = design->law()->at_load(loads.high);
    }
    const double cable_mm = dice.one_of(std::array{0.5, 0.6, 0.8, 1.0});
    const std::string series = part(dice, "k_se", series_spring(dice, rig.capstan_radius_mm, lowest, highest));
    const std::string parallel = part(dice, "k_pe", parallel_spring(dice, lowest, highest));
    return name + rig.text + "\n" + shop(dice, cable_mm) + series + parallel;
}

}  // namespace fusee::random_profiles
