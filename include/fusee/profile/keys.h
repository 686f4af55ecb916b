#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/checks/rule.h"
#include "fusee/core/text.h"

/// The keys of a profile, for a reader. `fusee keys`, `fusee explain` and docs/profile.md show them.
namespace fusee::profile {

/// One key. Values are TOML, numbers in the key's unit.
struct KeyInfo {
    std::string path;               ///< "k_se.guide.direction_deg"
    std::string table;              ///< "k_se.guide"; "" at the top
    std::string meaning;            ///< one line
    std::string unit;               ///< "mm"; "": none
    std::string allowed;            ///< "a number, 0 to 10 mm"
    std::string default_value;      ///< "" if it is required
    std::string refused;            ///< an example of a value that is refused; "" where none is short
    std::vector<std::string> when;  ///< all must hold: "only with law.kind = \"table\""
    bool required = false;
};

/// Lists every key, in the order of the reference.
[[nodiscard]] std::vector<KeyInfo> key_infos();

/// The keys that `words` ask for, in order. Each word asks for the tables and keys whose path begins with it; if there is none, for keys
/// with the word in path or meaning. Capitals do not count. No words: every key. @throws core::InvalidInput naming a word that no key has,
/// and near ones
[[nodiscard]] std::vector<KeyInfo> find_keys(const std::vector<std::string>& words);

/// Those of `all` that `words` ask for: each asks for the entries that begin with it; if there is none, for those that have it; small
/// letters. No words: all. @param refuse throws for a word that no entry has
template <class Info>
[[nodiscard]] std::vector<Info> asked_for(const std::vector<Info>& all, const std::vector<std::string>& words,
                                          bool (*begins)(const Info&, const std::string&), bool (*has)(const Info&, const std::string&),
                                          void (*refuse)(const std::string&)) {
    std::vector<bool> wanted(all.size(), words.empty());
    for (const std::string& asked : words) {
        const auto take = [&, word = core::lower(asked)](bool (*fits)(const Info&, const std::string&)) {
            bool any = false;
            for (std::size_t i = 0; i < all.size(); ++i)
                if (fits(all[i], word)) any = wanted[i] = true;
            return any;
        };
        if (!take(begins) && !take(has)) refuse(asked);
    }
    std::vector<Info> found;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (wanted[i]) found.push_back(all[i]);
    return found;
}

/// The Markdown tables of `fusee keys --markdown` with these keys only.
[[nodiscard]] std::string profile_reference(const std::vector<KeyInfo>& shown);

/// Rules that [[limits]] may name: ids, limits and units, in display order.
using RuleInfos = std::vector<const checks::RuleInfo*>;

/// Reads a file of [[limits]] only, of these rules: limits for a third-party mesh, which has no profile (docs/guides/check.md).
/// @throws core::IoError if it is missing, too large or not TOML
/// @throws core::InvalidInput(s) "file:line:column: KEY": any other key, and every fault of a profile's [[limits]]
[[nodiscard]] std::vector<checks::Override> read_limits(const std::filesystem::path& path, const RuleInfos& rules);

}  // namespace fusee::profile
