#include "fusee/gap_case/reference.h"

#include <array>
#include <cmath>

#include "fields.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"

namespace fusee::gap_case {

namespace {

constexpr double kReferenceTorque = 2.6;     ///< greatest load of a capstan [Nm]
constexpr double kReferenceRadius = 0.015;   ///< of a capstan [m]
constexpr double kReferenceInertia = 0.002;  ///< of a motor [kg m^2]
constexpr int kBits = 40;                    ///< of a factor: to 1e-12

/// A unit as powers of torque, radius and time.
struct Powers {
    std::string_view unit;
    int torque, radius, time;
};
constexpr std::array kUnits{Powers{"", 0, 0, 0},       Powers{"1", 0, 0, 0},       Powers{"rad", 0, 0, 0},    Powers{"Nm", 1, 0, 0},
                            Powers{"Nms", 1, 0, 1},    Powers{"Nms/rad", 1, 0, 1}, Powers{"Nm/rad", 1, 0, 0}, Powers{"1/Nm", -1, 0, 0},
                            Powers{"m", 0, 1, 0},      Powers{"N/m", 1, -2, 0},    Powers{"s", 0, 0, 1},      Powers{"rad/s", 0, 0, -1},
                            Powers{"kg m^2", 1, 0, 2}, Powers{"Hz", 0, 0, -1}};

double without_last_bits(double factor) {
    int exponent = 0;
    const double mantissa = std::frexp(factor, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, kBits)), exponent - kBits);
}

/// Products, not std::pow: powers of two stay exact.
double power(double base, int exponent) {
    double product = 1.0;
    for (int i = 0; i < std::abs(exponent); ++i) product *= base;
    return exponent < 0 ? 1.0 / product : product;
}

double over(double value, double reference) { return value > 0.0 ? without_last_bits(value / reference) : 1.0; }

double with_digits(double value, int digits) {
    if (value == 0.0 || digits >= 17) return value;
    const double step = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * step) / step;
}

/// Values of torque and length in units of the rig. The rate of a log is not the rig's.
void scale(const std::vector<NumberKey>& keys, const NominalRig& rig, int digits) {
    Reference reference = reference_of(rig);
    reference.time = 1.0;
    for (const NumberKey& key : keys) *key.to = with_digits(*key.to * reference.of(key.unit), digits);
}

}  // namespace

double Reference::of(std::string_view unit) const {
    const Powers* known = core::find_by(kUnits, &Powers::unit, unit);
    if (known == nullptr) throw core::InvalidInput("unit", std::string(unit), "1, rad, Nm, Nms, Nm/rad, 1/Nm, m, N/m, s, rad/s or kg m^2");
    return power(torque, known->torque) * power(radius, known->radius) * power(time, known->time);
}

double Reference::decade() const { return std::pow(10.0, std::round(std::log10(torque))); }

Reference reference_of(const NominalRig& rig) {
    Reference reference;
    if (!rig.springs.empty()) reference.torque = over(rig.springs.back().se_torque + rig.springs.back().pe_torque, kReferenceTorque);
    reference.radius = over(rig.capstan_radius, kReferenceRadius);
    reference.time = without_last_bits(std::sqrt(over(rig.motor_inertia, kReferenceInertia) / reference.torque));
    return reference;
}

Tolerance usual_tolerance(const NominalRig& rig, int digits) {
    Tolerance tolerance;
    scale(tolerance_keys(tolerance), rig, digits);
    return tolerance;
}

Sensors usual_sensors(const NominalRig& rig, int digits) {
    Sensors sensors;
    scale(sensor_keys(sensors), rig, digits);
    return sensors;
}

}  // namespace fusee::gap_case
