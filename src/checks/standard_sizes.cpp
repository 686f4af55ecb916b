#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/checks/thread.h"
#include "fusee/core/units.h"

namespace fusee::checks {

namespace {

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
    return *std::find_if(kStock.begin(), kStock.end(), [&known](const CableStock& stock) { return known == stock.construction; });
}

}  // namespace

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
