#include "convert.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::profile {

namespace {

// Smaller numbers measure nothing, and some underflow in SI or when squared. In the key's unit.
constexpr double kLeastAbove0 = 1e-9;  // where 0 itself is not allowed
constexpr double kLeastSize = 1e-30;   // elsewhere, of either sign

/// After a fault a value of the right kind replaces the refused one; the caller detects it by the count of faults.
class Converter {
public:
    Converter(const Key& key, core::TomlFaults& faults) : key_(key), faults_(faults) {}

    [[nodiscard]] Value convert(const toml::node& node) const {
        switch (key_.kind) {
            case Kind::kNumber:
                return key_.unit.to_si(number(node));
            case Kind::kInteger:
                return integer(node);
            case Kind::kSign:
                return sign(node);
            case Kind::kSwitch:
                return yes_or_no(node);
            case Kind::kName:
                return name(node);
            case Kind::kText:
                return line_of_text(node);
            case Kind::kFile:
            case Kind::kFormula:
                return name_or_formula(node);
            case Kind::kChoice:
                return choice(node);
            case Kind::kNumbers:
                return numbers(node);
            case Kind::kChoices:
                return choices(node);
        }
        return {};
    }

private:
    void refuse(const toml::node& node, const std::string& more = "") const {
        faults_.add(node.source(), key_.path, core::shown(node), allowed_text(key_) + more);
    }
    [[nodiscard]] double number(const toml::node& node) const {
        if (!node.is_number()) return refuse(node), 0.0;
        const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
        const double least = key_.limits.low == 0.0 && !key_.limits.low_allowed ? kLeastAbove0 : kLeastSize;
        if (!std::isfinite(value) || !key_.limits.hold(value))
            refuse(node);
        else if (value != 0.0 && std::abs(value) < least)
            refuse(node, fmt::format("; not so close to 0: at least {:g} in magnitude", least));
        return value;
    }
    [[nodiscard]] int integer(const toml::node& node) const {
        if (!node.is_integer()) return refuse(node), 0;
        const std::size_t before = faults_.count();
        const double value = number(node);
        return faults_.count() == before ? static_cast<int>(value) : 0;
    }
    [[nodiscard]] int sign(const toml::node& node) const {
        const auto* whole = node.as_integer();
        if (whole != nullptr && (whole->get() == 1 || whole->get() == -1)) return static_cast<int>(whole->get());
        return refuse(node), 1;
    }
    [[nodiscard]] bool yes_or_no(const toml::node& node) const {
        if (!node.is_boolean()) return refuse(node), false;
        return node.as_boolean()->get();
    }
    [[nodiscard]] std::string text(const toml::node& node) const {
        if (!node.is_string() || node.as_string()->get().empty()) return refuse(node), "";
        return node.as_string()->get();
    }
    /// Optional values may be empty.
    [[nodiscard]] std::string name_or_formula(const toml::node& node) const {
        const bool left_out = !key_.required && node.is_string() && node.as_string()->get().empty();
        return left_out ? "" : text(node);
    }
    [[nodiscard]] std::string line_of_text(const toml::node& node) const {
        std::string value = name_or_formula(node);
        const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
        if (core::letters(value) > kLongestLine || std::any_of(value.begin(), value.end(), control)) return refuse(node), "";
        return value;
    }
    [[nodiscard]] std::string name(const toml::node& node) const {
        std::string value = text(node);
        if (!value.empty() && !is_name(value)) refuse(node);
        return value;
    }
    [[nodiscard]] std::string choice(const toml::node& node) const {
        std::string value = text(node);
        if (!value.empty() && std::find(key_.choices.begin(), key_.choices.end(), value) == key_.choices.end())
            refuse(node, core::did_you_mean(value, key_.choices, "\""));
        return value;
    }
    /// Its cells; none if the array is refused.
    [[nodiscard]] const toml::array& array(const toml::node& node) const {
        static const toml::array kNone;
        const auto* array = node.as_array();
        if (array != nullptr && array->size() >= key_.least_count && array->size() <= key_.most_count) return *array;
        return refuse(node), kNone;
    }
    [[nodiscard]] std::vector<double> numbers(const toml::node& node) const {
        return core::each<double>(array(node), [&](const toml::node& cell) { return key_.unit.to_si(number(cell)); });
    }
    [[nodiscard]] std::vector<std::string> choices(const toml::node& node) const {
        std::vector<std::string> values;
        for (const toml::node& cell : array(node)) {
            std::string value = choice(cell);
            if (std::find(values.begin(), values.end(), value) != values.end()) refuse(cell);
            values.push_back(std::move(value));
        }
        return values;
    }

    const Key& key_;
    core::TomlFaults& faults_;
};

}  // namespace

std::optional<Value> convert(const Key& key, const toml::node& node, core::TomlFaults& faults) {
    const std::size_t before = faults.count();
    Value value = Converter(key, faults).convert(node);
    return faults.count() == before ? std::optional(std::move(value)) : std::nullopt;
}

}  // namespace fusee::profile
