#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "fusee/core/text.h"

namespace fusee::app {

/// Checks an argument: a number in decimal digits from `low` to `high`. CLI11 alone accepts nan, and reads 0x10 as 16, 010 as 8 and -1 as
/// 2^64 - 1.
template <class Number>
CLI::Validator number_within(Number low, Number high) {
    const auto check = [low, high](const std::string& text) -> std::string {
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        bool good = error == std::errc() && end == text.data() + text.size() && value >= low && value <= high;  // false for NaN
        if constexpr (std::is_integral_v<Number>) good = good && (text.size() == 1 || (text[0] != '0' && !text.starts_with("-0")));
        const char* kind = std::is_integral_v<Number>            ? "a whole number"
                           : text.find(',') == std::string::npos ? "a number"
                                                                 : "a number with a decimal point";
        return good ? "" : fmt::format("{} (allowed: {}, {} to {})", text, kind, low, high);
    };
    return CLI::Validator(check, fmt::format("{} to {}", low, high));
}

/// Checks an argument: one of these words.
inline CLI::Validator one_of(std::vector<std::string> words) {
    const std::string all = fmt::format("{{{}}}", fmt::join(words, ","));
    const auto check = [words = std::move(words)](const std::string& text) -> std::string {
        if (std::find(words.begin(), words.end(), text) != words.end()) return "";
        return fmt::format("{} (allowed: {}{})", text, fmt::join(words, ", "), core::did_you_mean(text, words));
    };
    return CLI::Validator(check, all);
}

}  // namespace fusee::app
