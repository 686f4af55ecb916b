#include "fusee/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "fusee/core/text.h"

namespace fusee::core {

namespace {

// Characters repeated in a message. A path may have 4096; the allowed values are fusee's text and list at most some hundred names.
constexpr std::size_t kMostOfValue = 200, kMostOfField = 5000, kMostOfReason = 5000;
constexpr std::size_t kMostLines = 200;  // of mistakes; a reader that finds more counts them

std::string all_lines(const std::vector<InvalidInput>& all) {
    std::string text = fmt::format("{} mistakes:", all.size());
    for (std::size_t i = 0; i < std::min(all.size(), kMostLines); ++i) text += fmt::format("\n{}", all[i].what());
    return all.size() > kMostLines ? fmt::format("{}\nand {} more", text, all.size() - kMostLines) : text;
}

}  // namespace

InvalidInput::InvalidInput(std::string field, std::string value, std::string allowed)
    : InputError(fmt::format("{}: {}{}", printable(field, kMostOfField), printable(value, kMostOfValue),
                             allowed.empty() ? "" : fmt::format(" (allowed: {})", printable(allowed, kMostOfReason)))),
      field_(std::move(field)),
      value_(std::move(value)),
      allowed_(std::move(allowed)) {}

InvalidInputs::InvalidInputs(std::vector<InvalidInput> all) : InputError(all_lines(all)), all_(std::move(all)) {}

void Mistakes::throw_if_any() const {
    if (all_.size() == 1) throw all_.front();
    if (!all_.empty()) throw InvalidInputs(all_);
}

IoError::IoError(const std::string& path, const std::string& why)
    : InputError(fmt::format("{}: {}", printable(path, kMostOfField), printable_lines(why, kMostOfReason))), path_(path), why_(why) {}

Location location_of(const std::string& field) {
    static const std::regex kPlace(R"(^(.+?):([0-9]{1,9})(?::([0-9]{1,9}))?(?:: *([^]*))?$)"),
        kFileOnly(R"(^([^:]+\.(?:toml|csv|json|stl|obj|3mf|step|stp|sqlite)): ([^]+)$)");
    std::smatch found;
    if (field.size() <= kMostOfField && std::regex_match(field, found, kPlace))
        return {found[1], std::stoul(found[2]), found[3].matched ? std::stoul(found[3]) : 0, found[4]};
    if (field.size() <= kMostOfField && std::regex_match(field, found, kFileOnly)) return {found[1], 0, 0, found[2]};
    return {"", 0, 0, field};
}

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
