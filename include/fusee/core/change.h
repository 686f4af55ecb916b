#pragma once
#include <string>
#include <vector>

namespace fusee::core {

/// A profile key and its new value, both as TOML: {"k_se.hub.bore_mm", "5.2"}; or an option of a command with its value.
struct Change {
    std::string key, value;
    std::string was = {};  ///< the old value; empty: not stated
};
/// Changes that are made together.
using Changes = std::vector<Change>;

/// A number as a change's value has it. @param digits significant ones
[[nodiscard]] std::string number(double value, int digits = 6);
/// A text as a change's value has it: "\"keyway\"".
[[nodiscard]] std::string quoted(const std::string& text);

/// One way to cure a finding: changes that are made together, between words for a person.
struct Alternative {
    std::string before;  ///< "a free cable of 80 mm there: "
    Changes changes;     ///< empty: advice in words alone, "a guide rod"
    std::string after;   ///< ": half height"
    [[nodiscard]] std::string text() const;
};

/// The nearest feasible changes, as alternatives, the best first. Rules state keys and values; their sentence is made here.
class Suggestion {
public:
    Suggestion() = default;
    Suggestion(std::string words);  // NOLINT(google-explicit-constructor): advice without a key
    Suggestion(const char* words) : Suggestion(std::string(words)) {}
    Suggestion(std::string key, std::string value) : alternatives_{{{}, {{std::move(key), std::move(value)}}, {}}} {}

    /// Adds a change to the last alternative. @pre not empty
    Suggestion& with(std::string key, std::string value);
    /// Words before or behind the last alternative. @pre not empty
    Suggestion& begun(std::string words);
    Suggestion& noted(std::string words);
    /// Adds all alternatives of the other one.
    Suggestion& or_else(const Suggestion& other);
    /// The same changes with "k_pe." before each key, for a finding that does not know its part.
    [[nodiscard]] Suggestion of_table(const std::string& table) const;

    [[nodiscard]] bool empty() const { return alternatives_.empty(); }
    void clear() { alternatives_.clear(); }
    [[nodiscard]] const std::vector<Alternative>& alternatives() const { return alternatives_; }
    /// The changes of each alternative that has some, without those to a value that is not finite.
    [[nodiscard]] std::vector<Changes> changes() const;
    /// "k_pe.hub.bore_mm = 5.2, or k_pe.spring.rate_N_per_m = 9e3 with k_pe.spring.preload_mm = 4.1 (every arm x 0.9)"
    [[nodiscard]] std::string text() const;

private:
    std::vector<Alternative> alternatives_;
};

/// The suggestion of one change.
[[nodiscard]] Suggestion change(std::string key, std::string value);

}  // namespace fusee::core
