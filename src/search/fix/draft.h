#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "fusee/core/change.h"
#include "fusee/core/finding.h"
#include "fusee/profile/edit.h"

namespace fusee::search::fix {

/// Another value for one key, and the finding that suggests it.
struct Choice {
    std::string value;  ///< as TOML
    core::Finding because;
    int move = 0;         ///< changes of one suggestion have the same
    std::string follows;  ///< the key that this one follows: cable.breaking_load_N follows cable.diameter_mm; empty: none
};

/// The differences of a draft from its original profile, by key.
using Choices = std::map<std::string, Choice>;
/// Names, by key, the other key that it follows.
using Follows = std::map<std::string, std::string>;

/// The number in a TOML value; none if it is not a number.
[[nodiscard]] std::optional<double> number_in(const std::string& toml);

/// Drafts of one profile, exactly as they would be written.
class Drafts {
public:
    /// @param toml the text that `original` was read from @param file of the new profile
    /// @param kept keys and tables that are not changed
    Drafts(const profile::Profile& original, const std::string& toml, std::filesystem::path file, std::vector<std::string> kept)
        : original_(original), toml_(toml), file_(std::move(file)), kept_(std::move(kept)) {}

    [[nodiscard]] const profile::Profile& original() const { return original_; }
    /// Does the user keep the key or its table?
    [[nodiscard]] bool keeps(const std::string& key) const;
    /// Gives none if a value is not allowed, if values are inconsistent, or if a thinner cable claims the old strength.
    [[nodiscard]] std::optional<profile::Profile> read(const Choices& choices) const;
    /// The new profile with a comment on each change. @pre read(choices) is a profile
    [[nodiscard]] std::string text(const Choices& choices) const;
    /// TOML of a key of the original; "not there" if the key has no meaning in it.
    [[nodiscard]] std::string was(const std::string& key) const;

    /// `choices` with `changes` added; a key that gets its old value back is removed.
    [[nodiscard]] Choices with(Choices choices, const core::Changes& changes, const core::Finding& because, int move,
                               const Follows& follows = {}) const;
    /// Distance from the original: for each key the weight of its kind (docs/guides/fix.md) and the size of its change.
    [[nodiscard]] double cost(const Choices& choices) const;

private:
    [[nodiscard]] std::vector<profile::Edit> edits(const Choices& choices) const;

    const profile::Profile& original_;
    const std::string& toml_;
    std::filesystem::path file_;
    std::vector<std::string> kept_;
};

/// The meaning of a change of a key for the builder of the joint.
struct Policy {
    std::string_view key;  ///< without its part ("k_se.", "k_pe.", "cam."); ends in '.' for a whole table
    double weight;         ///< a change costs this and ln of its factor
    const char* asks_for;
    bool graded = false;  ///< its suggestions come in coarse steps: the nearest value is searched
};

/// nullptr for facts: what the rig is, what a machine can do, what a material bears.
[[nodiscard]] const Policy* policy_of(std::string_view key);

}  // namespace fusee::search::fix
