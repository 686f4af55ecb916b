#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fusee/profile/profile.h"

/// Changes to a profile's text that leave everything else as its writer has it: comments, order, spacing.
namespace fusee::profile {

/// One key with its new value.
struct Edit {
    std::string key;          ///< "k_se.spring.rate_Nm_per_rad"
    std::string value;        ///< as TOML, in the key's unit
    std::string was;          ///< as TOML; of a key that the file leaves out, its default
    std::string why;          ///< one line; empty: the change is not commented
    std::string origin = {};  ///< "measured, case bench_3": takes the place of the comment behind the old value; empty: that comment stays
};

/// @throws InvalidInput naming `field` and the nearest key unless `key` is a key or a table of a profile
void require_key(const std::string& field, const std::string& key);
/// The value of a number's key [SI]. @pre `key` is a key of numbers
[[nodiscard]] double number_of(const Profile& profile, const std::string& key);
/// The key's value as TOML; none if there is no such key, or it has no meaning in this profile.
[[nodiscard]] std::optional<std::string> value_text(const Profile& profile, const std::string& key);
/// @pre as number_of; the value is not judged until the profile is read again
void set_number(Profile& profile, const std::string& key, double value);
/// `value` [SI] as the key's new value, in the key's unit with 6 significant digits. @pre as number_of
[[nodiscard]] Edit number_edit(const Profile& profile, const std::string& key, double value, std::string why);
/// @pre `key` is a key of text
[[nodiscard]] Edit text_edit(const Profile& profile, const std::string& key, const std::string& value, std::string why);
/// The CSV files that the profile names, named from another folder.
[[nodiscard]] std::vector<Edit> file_edits(const Profile& profile, const std::filesystem::path& folder);

/// `toml` with each edit made: the value alone is replaced; a key that is left out is added below its table's heading, or with its table at
/// the end. Above each a comment says what it was and why; the comment behind the old value, which spoke of it, gives way to the edit's
/// `origin`. A key that loses its meaning by an edit (a pitch, of a path that becomes planar) becomes a comment. `head`, a line of comment,
/// goes before everything.
/// @param toml the text that `profile` was read from
/// @throws core::InvalidInput naming a key that cannot be added or left out: its table stands in one line, or in dotted keys
[[nodiscard]] std::string with_edits(std::string toml, const Profile& profile, const std::vector<Edit>& edits,
                                     const std::string& head = {});

}  // namespace fusee::profile
