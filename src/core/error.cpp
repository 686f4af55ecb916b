#include "fusee/core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace fusee::core {

InvalidInput::InvalidInput(std::string field, std::string value, std::string allowed)
    : std::invalid_argument(fmt::format("{}: {} (allowed: {})", field, value, allowed)),
      field_(std::move(field)),
      value_(std::move(value)),
      allowed_(std::move(allowed)) {}

namespace {
std::string lines(const std::vector<InvalidInput>& all) {
    std::string text;
    for (const InvalidInput& one : all) text += fmt::format("{}{}", text.empty() ? "" : "\n", one.what());
    return text;
}
}  // namespace

InvalidInputs::InvalidInputs(std::vector<InvalidInput> all) : std::invalid_argument(lines(all)), all_(std::move(all)) {}

void Mistakes::throw_if_any() const {
    if (all_.size() == 1) throw all_.front();
    if (!all_.empty()) throw InvalidInputs(all_);
}

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
