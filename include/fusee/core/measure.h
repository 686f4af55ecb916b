#pragma once
#include <span>
#include <string>
#include <string_view>

/// Units of measured data, as spreadsheets and instruments write them.
namespace fusee::core {

/// SI value = value * numerator / denominator: with integers and powers of ten "0.8 mm" becomes the double nearest to 8e-4.
struct MeasureUnit {
    const char* name;      ///< "mNm", "deg", "N/mm"
    const char* quantity;  ///< "torque": units of one quantity convert into each other
    double numerator = 1.0, denominator = 1.0;
    [[nodiscard]] bool converts_to(const MeasureUnit& other) const { return std::string_view(quantity) == other.quantity; }
    /// @pre converts_to(other)
    [[nodiscard]] double to(const MeasureUnit& other, double value) const {
        return value * (numerator * other.denominator) / (denominator * other.numerator);
    }
};

/// The unit in any spelling: "N·m", "N m", "[Nm]", "°", "degrees", "µm", "N/mm²", "Nm_per_rad"; capitals count only where they tell units
/// apart ("mN" and "MN"). Null: not known.
[[nodiscard]] const MeasureUnit* find_measure_unit(std::string_view text);

/// Every known unit of one quantity, the SI unit first.
[[nodiscard]] std::span<const MeasureUnit> measure_units(std::string_view quantity);

/// "rad, mrad, deg, turn"
[[nodiscard]] std::string measure_unit_names(std::string_view quantity);

/// A column's name in two: "motor_torque_Nm", "Torque [N·m]", "Torque / Nm", "torque in Nm", "angle_deg".
struct Measured {
    std::string stem;                   ///< "motortorque": lower-case letters and figures; other characters stay
    std::string unit_text;              ///< "Nm", as it stands; "": none
    const MeasureUnit* unit = nullptr;  ///< null: none, or not known
};
[[nodiscard]] Measured measured_name(std::string_view name);

}  // namespace fusee::core
