#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::exchange {

using Json = nlohmann::ordered_json;

/// The JSON in a file. @throws IoError naming it: unreadable, larger than 1 GB, nested more than 100 deep, no JSON
inline Json read_json(const std::filesystem::path& path) {
    constexpr std::size_t kLargest = std::size_t{1} << 30;
    constexpr std::size_t kDeepest = 100;
    const std::string text = core::read_file(path, kLargest);
    bool quoted = false;
    for (std::size_t i = 0, depth = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') quoted = !quoted;
        if (quoted) {
            i += c == '\\' ? 1 : 0;
            continue;
        }
        if ((c == '[' || c == '{') && ++depth > kDeepest)
            throw core::IoError(path.string(), fmt::format("byte {}: JSON nested more than {} deep", i, kDeepest));
        if ((c == ']' || c == '}') && depth > 0) --depth;
    }
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw core::IoError(path.string(), "is not JSON");
    return json;
}

/// A value in a JSON file that knows its own name, so that every error names file and key.
class Node {
public:
    Node(const std::filesystem::path& file, std::string key, const Json& json) : file_(file), key_(std::move(key)), json_(json) {}

    [[nodiscard]] Node at(const char* key) const {
        const std::string full = key_.empty() ? key : key_ + "." + key;
        if (!json_.is_object()) fail("must be an object");
        if (!json_.contains(key)) throw core::IoError(file_.string(), full + " is missing");
        return {file_, full, json_.at(key)};
    }
    [[nodiscard]] bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
    [[nodiscard]] std::vector<Node> rows(bool may_be_empty) const {
        if (!json_.is_array()) fail("must be an array");
        if (json_.empty() && !may_be_empty) fail("must not be empty");
        std::vector<Node> nodes;
        for (std::size_t i = 0; i < json_.size(); ++i) nodes.emplace_back(file_, fmt::format("{}[{}]", key_, i), json_.at(i));
        return nodes;
    }
    [[nodiscard]] double number(double least = -HUGE_VAL) const {
        if (!json_.is_number()) fail("must be a number");
        const double value = json_.get<double>();
        if (!std::isfinite(value) || value < least) fail(fmt::format("is {}, below {}", value, least));
        return value;
    }
    [[nodiscard]] int sign() const {
        const double value = number();
        if (std::abs(value) != 1.0) fail("must be 1 or -1");
        return static_cast<int>(value);
    }
    [[nodiscard]] std::size_t count() const {
        if (!json_.is_number_unsigned()) fail("must be a whole number, at least 0");
        return json_.get<std::size_t>();
    }
    [[nodiscard]] std::string text() const {
        if (!json_.is_string() || json_.get_ref<const std::string&>().empty()) fail("must be a text that is not empty");
        return json_.get<std::string>();
    }
    [[nodiscard]] std::string one_of(std::initializer_list<std::string_view> allowed) const {
        std::string value = text();
        if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
            fail(fmt::format("is \"{}\", not one of: {}", value, fmt::join(allowed, ", ")));
        return value;
    }
    template <std::size_t N>
    [[nodiscard]] std::array<double, N> vector() const {
        const std::vector<Node> parts = rows(false);
        if (parts.size() != N) fail(fmt::format("must hold {} numbers", N));
        std::array<double, N> value{};
        for (std::size_t i = 0; i < N; ++i) value[i] = parts[i].number();
        return value;
    }
    [[noreturn]] void fail(const std::string& why) const { throw core::IoError(file_.string(), fmt::format("{} {}", key_, why)); }

private:
    std::filesystem::path file_;
    std::string key_;
    const Json& json_;
};

}  // namespace fusee::exchange
