#pragma once
#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fusee/core/path.h"

namespace fusee::core {

inline constexpr std::size_t kDeepestJson = 64;  ///< nesting of arrays and objects

/// Parses a third-party JSON text. Every number is finite and nothing is nested deeper than kDeepestJson, so that code may recurse through
/// the result.
/// @param file the name used in messages
/// @throws InvalidInput "file:line:column: JSON"
[[nodiscard]] nlohmann::ordered_json parse_json(std::string_view bytes, const std::string& file);

/// The JSON of a file. @throws IoError if it cannot be read or has more than 1 GiB; InvalidInput as parse_json
[[nodiscard]] nlohmann::ordered_json read_json(const std::filesystem::path& path);

/// A value of a parsed JSON text with its path "d.json: effects[0].side", so that each refusal names the key.
class JsonNode {
public:
    /// @param json has to outlive it
    JsonNode(const nlohmann::ordered_json& json, std::string path) : json_(json), path_(std::move(path)) {}
    /// The whole text of a file: its keys are named "d.json: key".
    [[nodiscard]] static JsonNode of_file(const nlohmann::ordered_json& json, const std::string& file);

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] bool is_null() const;
    [[nodiscard]] bool is_text() const;
    /// @throws InvalidInput if it is no object or lacks the key
    [[nodiscard]] JsonNode operator[](const std::string& key) const;
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string one_of(const std::vector<std::string>& allowed) const;  ///< a text
    [[nodiscard]] double number() const;
    [[nodiscard]] double number_or_null() const;  ///< NaN for null, as NaN is written
    [[nodiscard]] double number_within(double low, double high) const;
    [[nodiscard]] double number_at_least(double low) const;
    [[nodiscard]] int sign() const;           ///< 1 or -1
    [[nodiscard]] std::size_t count() const;  ///< a whole number, at least 0
    template <std::size_t N>
    [[nodiscard]] std::array<double, N> vector() const {  ///< an array of N numbers
        std::array<double, N> numbers;
        copy_numbers(numbers.data(), N);
        return numbers;
    }
    [[nodiscard]] std::vector<JsonNode> cells(std::size_t least = 0) const;       ///< of an array of at least so many
    [[nodiscard]] std::vector<std::pair<std::string, JsonNode>> members() const;  ///< of an object
    /// @throws InvalidInput naming the first key of this object that is not in `known`
    void allow_keys(const std::vector<std::string>& known) const;
    /// @throws InvalidInput with this value, shortened, and the allowed ones
    [[noreturn]] void refuse(const std::string& allowed) const;

private:
    [[nodiscard]] std::string path_to(const std::string& key) const;
    void copy_numbers(double* numbers, std::size_t count) const;

    const nlohmann::ordered_json& json_;
    std::string path_;
    bool file_ = false;  ///< path_ is a file's name
};

/// For one version after a field was renamed: each object of `json` that holds a new name also holds the same value under the old name,
/// and the top object says so under "renamed_fields" (old name: new name). `json` stays as it is if it holds none of them.
/// @param renamed old name, new name
void keep_old_spelling(nlohmann::ordered_json& json, const std::vector<std::pair<std::string, std::string>>& renamed);

}  // namespace fusee::core
