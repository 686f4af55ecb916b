#include "convert.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/toml.h"

namespace fusee::profile {

namespace {

class Converter {
public:
    Converter(const Key& key, const std::string& file) : key_(key), file_(file) {}

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
        refuse(node);
    }

private:
    [[noreturn]] void refuse(const toml::node& node) const {
        throw core::InvalidInput(place(file_, node.source(), key_.path), core::shown(node), allowed_text(key_));
    }
    [[nodiscard]] double number(const toml::node& node) const {
        if (!node.is_number()) refuse(node);
        const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
        const bool high_enough = key_.limits.low_allowed ? value >= key_.limits.low : value > key_.limits.low;
        if (!std::isfinite(value) || !high_enough || value > key_.limits.high) refuse(node);
        return value;
    }
    [[nodiscard]] int integer(const toml::node& node) const {
        if (!node.is_integer()) refuse(node);
        return static_cast<int>(number(node));
    }
    [[nodiscard]] int sign(const toml::node& node) const {
        if (!node.is_integer()) refuse(node);
        const auto value = node.as_integer()->get();
        if (value != 1 && value != -1) refuse(node);
        return static_cast<int>(value);
    }
    [[nodiscard]] bool yes_or_no(const toml::node& node) const {
        if (!node.is_boolean()) refuse(node);
        return node.as_boolean()->get();
    }
    [[nodiscard]] std::string text(const toml::node& node) const {
        if (!node.is_string() || node.as_string()->get().empty()) refuse(node);
        return node.as_string()->get();
    }
    /// What may be left out may also be empty.
    [[nodiscard]] std::string name_or_formula(const toml::node& node) const {
        const bool left_out = !key_.required && node.is_string() && node.as_string()->get().empty();
        return left_out ? "" : text(node);
    }
    [[nodiscard]] std::string name(const toml::node& node) const {
        static constexpr std::size_t kLongest = 64;
        const std::string value = text(node);
        const bool plain = std::all_of(value.begin(), value.end(), [](unsigned char c) {
            return c < 0x80 && (std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-');
        });
        if (!plain || std::isalnum(static_cast<unsigned char>(value.front())) == 0 || value.size() > kLongest) refuse(node);
        return value;
    }
    [[nodiscard]] std::string choice(const toml::node& node) const {
        const std::string value = text(node);
        if (std::find(key_.choices.begin(), key_.choices.end(), value) == key_.choices.end()) refuse(node);
        return value;
    }
    [[nodiscard]] const toml::array& array(const toml::node& node) const {
        if (!node.is_array() || node.as_array()->size() < key_.least_count || node.as_array()->size() > key_.most_count) refuse(node);
        return *node.as_array();
    }
    [[nodiscard]] std::vector<double> numbers(const toml::node& node) const {
        std::vector<double> values;
        for (const toml::node& cell : array(node)) values.push_back(key_.unit.to_si(number(cell)));
        return values;
    }
    [[nodiscard]] std::vector<std::string> choices(const toml::node& node) const {
        std::vector<std::string> values;
        for (const toml::node& cell : array(node)) {
            if (std::find(values.begin(), values.end(), choice(cell)) != values.end()) refuse(cell);
            values.push_back(choice(cell));
        }
        return values;
    }

    const Key& key_;
    const std::string& file_;
};

}  // namespace

std::string place(const std::string& file, const toml::source_region& at, std::string_view path) {
    return fmt::format("{}:{}:{}: {}", file, at.begin.line, at.begin.column, path);
}

Value convert(const Key& key, const toml::node& node, const std::string& file) { return Converter(key, file).convert(node); }

}  // namespace fusee::profile
