#include "fusee/checks/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/checks/thread.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"

namespace fusee::checks {

namespace {

constexpr std::array kCableTable = {
    CableLimits{"fibre", 4.0, 8.0, 0.05, "The Complete Rigger's Apprentice: fibre 4-6, better 6-8; Samson: at least 3"},
    CableLimits{"7x7", 28.0, 40.0, 0.1, "Sava: 40; Strandcore: desired 42, critical 28"},
    CableLimits{"7x19", 18.0, 25.0, 0.1, "Sava: 25; Strandcore: desired 24, critical 18"},
    CableLimits{"7x49", 15.0, 16.0, 0.1, "Sava: 15, low life below 16"},
};

struct Strength {
    double bend_ratio, left;
};
constexpr std::array kWireStrength = {Strength{1.0, 0.50},  Strength{2.0, 0.65},  Strength{6.0, 0.79},
                                      Strength{10.0, 0.86}, Strength{20.0, 0.91}, Strength{40.0, 0.95}};
constexpr std::array kFibreStrength = {Strength{1.0, 0.50}, Strength{2.0, 0.65}, Strength{4.0, 0.80}, Strength{8.0, 0.95}};

constexpr std::array kTerminations = {
    TerminationLimits{Termination::kKnot, true, 0.5, 3.0,
                      "Starzinger: 55-60 %; rund-ums-tauwerk: 25-50 %; an overhand knot is about 3 d wide"},
    TerminationLimits{Termination::kCrimp, true, 0.6, 3.0, "a sleeve on a slippery braid (practice)"},
    TerminationLimits{Termination::kSplice, true, 0.9, 2.5, "Starzinger: 90-100 %; the buried tail with a pin through the eye (practice)"},
    TerminationLimits{Termination::kKnot, false, 0.4, 4.0, "wire kinks in a knot (practice)"},
    TerminationLimits{Termination::kCrimp, false, 0.9, 2.5, "TM 5-3810: sleeve 92.5-95 %; cavinguk: 90-96 %"},
    TerminationLimits{Termination::kSplice, false, 0.76, 2.5, "TM 5-3810: tucked by hand, stainless 76 %"},
};

constexpr const char* kFilament = "3dservicesusa, cifproto, arti90, layerx3d; detail, layer and roughness (practice)";
constexpr const char* kPrinting = "3dservicesusa, cifproto, arti90, layerx3d; layer and roughness (practice)";
constexpr const char* kMilling = "zekes3d, procurabl, neptunelabs, super-ingenuity, Xometry; fit and roughness (practice)";
constexpr const char* kWire = "wire of 0.25 mm with a gap of 0.02 mm a side (practice)";
constexpr const char* kBeam = "steel sheet, kerf 0.2 mm (practice)";
constexpr double kSteepest = core::rad_from_deg(45.0);  // of a filament print
using Kind = ProcessKind;
constexpr std::array kProcesses = {
    ProcessLimits{
        Kind::kFdm, 0.8e-3, 1.2e-3, 2e-3, kSteepest, 0.0, 0.3e-3, 2e-3, 0.4e-3, {0.1e-3, 0.4e-3}, 0.2e-3, 12.5e-6, 12.5e-6, kFilament},
    ProcessLimits{
        Kind::kSla, 0.5e-3, 1.0e-3, 0.5e-3, 0.0, 0.0, 0.1e-3, 0.5e-3, 0.5e-3, {0.15e-3, 0.3e-3}, 0.05e-3, 3.2e-6, 3.2e-6, kPrinting},
    ProcessLimits{
        Kind::kSls, 0.7e-3, 0.8e-3, 1.0e-3, 0.0, 0.0, 0.2e-3, 0.5e-3, 0.5e-3, {0.2e-3, 0.5e-3}, 0.1e-3, 12.5e-6, 12.5e-6, kPrinting},
    ProcessLimits{
        Kind::kMill, 0.8e-3, 1.5e-3, 0.5e-3, 0.0, 0.25e-3, 0.127e-3, 2.5e-3, 0.5e-3, {0.0, 0.05e-3}, 0.0, 3.2e-6, 1.6e-6, kMilling},
    ProcessLimits{
        Kind::kMill4, 0.8e-3, 1.5e-3, 0.5e-3, 0.0, 0.25e-3, 0.127e-3, 2.5e-3, 0.5e-3, {0.0, 0.05e-3}, 0.0, 3.2e-6, 1.6e-6, kMilling},
    ProcessLimits{Kind::kEdm, 0.5e-3, 1.0e-3, 0.5e-3, 0.0, 0.145e-3, 0.01e-3, 0.5e-3, 0.0, {0.0, 0.03e-3}, 0.0, 3.2e-6, 1.6e-6, kWire},
    ProcessLimits{Kind::kLaser, 1.0e-3, 1.5e-3, 1.0e-3, 0.0, 0.1e-3, 0.1e-3, 1.0e-3, 0.0, {0.0, 0.2e-3}, 0.0, 12.5e-6, 6.3e-6, kBeam},
};

constexpr std::array kKeys = {
    KeySize{6e-3, 8e-3, 2e-3, 2e-3, 1.2e-3, 1.0e-3},   KeySize{8e-3, 10e-3, 3e-3, 3e-3, 1.8e-3, 1.4e-3},
    KeySize{10e-3, 12e-3, 4e-3, 4e-3, 2.5e-3, 1.8e-3}, KeySize{12e-3, 17e-3, 5e-3, 5e-3, 3.0e-3, 2.3e-3},
    KeySize{17e-3, 22e-3, 6e-3, 6e-3, 3.5e-3, 2.8e-3}, KeySize{22e-3, 30e-3, 8e-3, 7e-3, 4.0e-3, 3.3e-3},
};

constexpr double kSameLength = 1e-9;  // [m]: 8e-3 read from millimetres may miss 8e-3 by its last bit

double interpolated(std::span<const Strength> rows, double bend_ratio) {
    if (!(bend_ratio > rows.front().bend_ratio)) return rows.front().left;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const Strength &a = rows[i - 1], &b = rows[i];
        if (bend_ratio <= b.bend_ratio)
            return a.left + (b.left - a.left) * std::log(bend_ratio / a.bend_ratio) / std::log(b.bend_ratio / a.bend_ratio);
    }
    return rows.back().left;
}

constexpr double kSizeRounding = 1e-9;  // relative

constexpr std::array kShafts{2.0,  2.5,  3.0,  4.0,  5.0,  6.0,  7.0,  8.0,  9.0,  10.0, 11.0, 12.0, 14.0, 15.0, 16.0,
                             17.0, 18.0, 19.0, 20.0, 22.0, 24.0, 25.0, 28.0, 30.0, 32.0, 35.0, 38.0, 40.0, 45.0, 50.0};
constexpr std::array kWires{0.2, 0.22, 0.25, 0.28, 0.3, 0.32, 0.36, 0.4,  0.45, 0.5, 0.56, 0.6, 0.63, 0.7, 0.75, 0.8, 0.9, 1.0,
                            1.1, 1.2,  1.25, 1.3,  1.4, 1.5,  1.6,  1.7,  1.8,  1.9, 2.0,  2.1, 2.25, 2.4, 2.5,  2.6, 2.8, 3.0,
                            3.2, 3.4,  3.6,  3.8,  4.0, 4.25, 4.5,  4.75, 5.0,  5.6, 6.0,  6.5, 7.0,  8.0, 9.0,  10.0};
constexpr std::array kScrews{1.6, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0};
constexpr std::array kCableSizes_mm{0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};

/// The available cables of one construction.
struct CableStock {
    const char* construction;
    double thinnest_mm;
    double usual;     ///< breaking load over d^2 of an ordinary one [Pa]
    double strength;  ///< of the strongest: the same [Pa]
    const char* source;
};
constexpr std::array kStock{
    CableStock{"fibre", 0.2, 870e6, 2070e6,
               "metric sizes of braided cords (practice); UHMWPE braid: 130 lb at 0.032 in, strongest 138 lb at 0.545 mm"},
    CableStock{"7x7", 0.3, 740e6, 900e6, "metric sizes of wire rope (practice); strongest: MIL-DTL-83420, rounded up"},
    CableStock{"7x19", 0.8, 700e6, 900e6, "metric sizes of wire rope (practice); strongest: MIL-DTL-83420, 8.9 kN at 3.2 mm"},
    CableStock{"7x49", 0.6, 650e6, 900e6, "metric sizes of wire rope (practice); strongest: as 7x19"},
};

const CableStock& stock_of(const std::string& construction) {
    const std::string known = cable_limits(construction).construction;  // refuses an unknown one
    return *core::find_by(kStock, &CableStock::construction, known);
}

}  // namespace

bool is_printed(const Process& process) { return !is_milled(process) && !is_stacked(process); }
bool is_milled(const Process& process) { return process.kind == ProcessKind::kMill || process.kind == ProcessKind::kMill4; }
bool is_stacked(const Process& process) { return process.kind == ProcessKind::kEdm || process.kind == ProcessKind::kLaser; }

const char* to_string(ProcessKind kind) {
    switch (kind) {
        case ProcessKind::kFdm:
            return "fdm";
        case ProcessKind::kSla:
            return "sla";
        case ProcessKind::kSls:
            return "sls";
        case ProcessKind::kMill:
            return "mill";
        case ProcessKind::kMill4:
            return "mill4";
        case ProcessKind::kEdm:
            return "edm";
        case ProcessKind::kLaser:
            return "laser";
    }
    return "";
}

std::span<const CableLimits> cable_table() { return kCableTable; }
std::span<const ProcessLimits> process_table() { return kProcesses; }
std::span<const KeySize> key_table() { return kKeys; }

const CableLimits& cable_limits(const std::string& construction) {
    if (const CableLimits* row = core::find_by(kCableTable, &CableLimits::construction, construction)) return *row;
    throw core::InvalidInput("cable.construction", construction, core::listed(kCableTable, &CableLimits::construction));
}

bool CableLimits::is_fibre() const { return construction == std::string_view("fibre"); }

double strength_left(const std::string& construction, double bend_ratio) {
    return cable_limits(construction).is_fibre() ? interpolated(kFibreStrength, bend_ratio) : interpolated(kWireStrength, bend_ratio);
}

std::span<const TerminationLimits> termination_table() { return kTerminations; }

const TerminationLimits& termination_limits(const Cable& cable) {
    const bool fibre = cable_limits(cable.construction).is_fibre();
    return *std::find_if(kTerminations.begin(), kTerminations.end(),
                         [&](const TerminationLimits& t) { return t.kind == cable.termination && t.fibre == fibre; });
}

const char* to_string(Termination kind) {
    switch (kind) {
        case Termination::kKnot:
            return "knot";
        case Termination::kCrimp:
            return "crimp";
        case Termination::kSplice:
            return "splice";
    }
    return "";
}

ProcessLimits process_limits(const Process& process) {
    ProcessLimits limits = kProcesses.front();
    for (const ProcessLimits& row : kProcesses)
        if (row.kind == process.kind) limits = row;
    if (process.min_wall > 0.0) limits.wall = limits.loaded_wall = process.min_wall;
    if (process.min_hole > 0.0) limits.hole = process.min_hole;
    if (process.max_overhang > 0.0) limits.overhang = process.max_overhang;
    if (process.cutter_radius > 0.0) limits.cutter_radius = process.cutter_radius;
    if (process.layer > 0.0) limits.layer = process.layer;
    if (process.tolerance > 0.0) limits.tolerance = process.tolerance;
    return limits;
}

const KeySize* key_size(double shaft_diameter) {
    if (shaft_diameter < kKeys.front().above - kSameLength) return nullptr;
    for (const KeySize& key : kKeys)
        if (shaft_diameter <= key.up_to + kSameLength) return &key;
    return nullptr;
}

std::optional<double> StandardSizes::at_most(double limit_mm) const {
    const auto above = std::upper_bound(mm.begin(), mm.end(), limit_mm * (1.0 + kSizeRounding));
    return above == mm.begin() ? std::nullopt : std::optional(*std::prev(above));
}

std::optional<double> StandardSizes::at_least(double limit_mm) const {
    const auto from = std::lower_bound(mm.begin(), mm.end(), limit_mm * (1.0 - kSizeRounding));
    return from == mm.end() ? std::nullopt : std::optional(*from);
}

StandardSizes shaft_sizes() { return {"shaft", kShafts, "shaft ends of DIN 748-1, below 6 mm bearing bores of ISO 15"}; }
StandardSizes wire_sizes() { return {"spring wire", kWires, "EN 10270-1, as DIN 2076"}; }
StandardSizes screw_sizes() { return {"set screw", kScrews, "ISO 4026"}; }

StandardSizes cable_sizes(const std::string& construction) {
    const CableStock& stock = stock_of(construction);
    const auto first = std::lower_bound(kCableSizes_mm.begin(), kCableSizes_mm.end(), stock.thinnest_mm);
    return {"cable", std::span(first, kCableSizes_mm.end()), stock.source};
}

double usual_cable(const std::string& construction, double d) { return stock_of(construction).usual * d * d; }
double strongest_cable(const std::string& construction, double d) { return stock_of(construction).strength * d * d; }

double thread_strength(double diameter, double length, const Material& material) {
    return 0.875 * core::kPi * diameter * length * 0.5 * material.strength;
}
double torsion_stress(double torque, double diameter) { return 16.0 * torque / (core::kPi * std::pow(diameter, 3)); }
double shaft_shear_limit(bool keyway) { return keyway ? 41e6 : 55e6; }

}  // namespace fusee::checks
