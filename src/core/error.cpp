#include "fusee/core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace fusee::core {

InvalidInput::InvalidInput(std::string field, std::string value, std::string allowed)
    : std::invalid_argument(fmt::format("{}: {} (allowed: {})", field, value, allowed)),
      field_(std::move(field)),
      value_(std::move(value)),
      allowed_(std::move(allowed)) {}

IoError::IoError(const std::string& path, const std::string& why) : std::runtime_error(fmt::format("{}: {}", path, why)) {}

namespace {
std::string with_unit(const std::string& unit) { return unit.empty() ? "" : " " + unit; }
}  // namespace

double require_within(const std::string& field, double value, double low, double high, const std::string& unit) {
    if (!std::isfinite(value) || value < low || value > high)
        throw InvalidInput(field, fmt::format("{:g}", value), fmt::format("{:g} to {:g}{}", low, high, with_unit(unit)));
    return value;
}

double require_positive(const std::string& field, double value, const std::string& unit) {
    if (!std::isfinite(value) || value <= 0.0)
        throw InvalidInput(field, fmt::format("{:g}", value), fmt::format("a finite number above 0{}", with_unit(unit)));
    return value;
}

}  // namespace fusee::core
