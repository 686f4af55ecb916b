#pragma once
#include <stdexcept>
#include <string>

namespace fusee::core {

/// The caller's mistake: names the field, the value found and what is allowed. The app ends with exit code 2.
class InvalidInput : public std::invalid_argument {
public:
    /// @param field where the value stands, e.g. "rig.gear_friction" or "springs.csv:12: torque_Nm"
    InvalidInput(std::string field, std::string value, std::string allowed);

    [[nodiscard]] const std::string& field() const { return field_; }
    [[nodiscard]] const std::string& value() const { return value_; }
    [[nodiscard]] const std::string& allowed() const { return allowed_; }

private:
    std::string field_, value_, allowed_;
};

/// A file could not be read, written or understood. The app ends with exit code 2.
class IoError : public std::runtime_error {
public:
    IoError(const std::string& path, const std::string& why);
};

/// @throws InvalidInput unless `value` is finite and within [low, high]
double require_within(const std::string& field, double value, double low, double high, const std::string& unit = "");
/// @throws InvalidInput unless `value` is finite and above 0
double require_positive(const std::string& field, double value, const std::string& unit = "");

}  // namespace fusee::core
