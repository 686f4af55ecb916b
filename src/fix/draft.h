#pragma once
#include <map>
#include <optional>
#include <string>

#include "fusee/core/change.h"
#include "fusee/core/finding.h"
#include "fusee/profile/edit.h"

namespace fusee::fix {

/// Another value for one key, and what asked for it.
struct Choice {
    std::string value;  ///< as TOML
    core::Finding because;
    int move = 0;         ///< changes that a suggestion joins have the same
    std::string follows;  ///< the key that this one follows: cable.breaking_load_N follows cable.diameter_mm; empty: none
};
/// What a draft has in another way than the profile that it is made from, by key.
using Choices = std::map<std::string, Choice>;
/// Of keys that are changed beside another one: that other key.
using Follows = std::map<std::string, std::string>;

/// The number that a TOML value is; none if it is no number.
[[nodiscard]] std::optional<double> number_in(const std::string& toml);

/// Drafts of one profile: judged is what would be written.
class Drafts {
public:
    /// @param toml the text that `original` was read from @param file which the new profile is going to be
    /// @param kept keys and tables that are not changed
    Drafts(const profile::Profile& original, const std::string& toml, std::filesystem::path file, std::vector<std::string> kept)
        : original_(original), toml_(toml), file_(std::move(file)), kept_(std::move(kept)) {}

    [[nodiscard]] const profile::Profile& original() const { return original_; }
    /// Is the key, or its table, one that the user keeps?
    [[nodiscard]] bool keeps(const std::string& key) const;
    /// None where a profile cannot hold the choices, each value allowed and all of them together, and where a cable was made thinner
    /// without losing strength.
    [[nodiscard]] std::optional<profile::Profile> read(const Choices& choices) const;
    /// As it is to be written, with a comment on each change. @pre read(choices) is a profile
    [[nodiscard]] std::string text(const Choices& choices) const;
    /// TOML of a key of the original; "not there" of one that has no meaning in it.
    [[nodiscard]] std::string was(const std::string& key) const;

    /// `choices` with `changes` made on top; a key that gets its old value back is no choice any more.
    [[nodiscard]] Choices with(Choices choices, const core::Changes& changes, const core::Finding& because, int move,
                               const Follows& follows = {}) const;
    /// How far they are from the original: for each key what its kind weighs (docs/guides/fix.md), and by how much it is changed.
    [[nodiscard]] double cost(const Choices& choices) const;

private:
    [[nodiscard]] std::vector<profile::Edit> edits(const Choices& choices) const;

    const profile::Profile& original_;
    const std::string& toml_;
    std::filesystem::path file_;
    std::vector<std::string> kept_;
};

}  // namespace fusee::fix
