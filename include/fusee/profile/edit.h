#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/change.h"
#include "fusee/profile/profile.h"

/// Changes to a profile's text that keep everything else: comments, order, spacing.
namespace fusee::profile {

/// A change in the profile's text. An empty value: the key is left out. `was`: the default of a key that is not in the file.
struct Edit : core::Change {
    std::string why;          ///< one line; empty: the change is not commented
    std::string origin = {};  ///< "measured, case bench_3": replaces the comment behind the old value; empty: that comment stays
};

/// "k_se.guide.direction_deg" and every other key, in the order of the reference.
[[nodiscard]] std::vector<std::string> key_names();
/// @throws InvalidInput naming `field` and the nearest key unless `key` is a key or a table of a profile
void require_key(const std::string& field, const std::string& key);
/// Is `key` one whose value names a CSV file?
[[nodiscard]] bool names_file(const std::string& key);
/// What a key of the other kind of profile is called in this one, "cam.hub.bore_mm" for "k_pe.hub.bore_mm"; "" if it has none of that
/// meaning.
[[nodiscard]] std::string counterpart(const std::string& key, const Profile& profile);
/// The value of a number's key [SI]. @pre `key` is a key of numbers
[[nodiscard]] double number_of(const Profile& profile, const std::string& key);
/// The key's value as TOML; none if there is no such key, or it has no meaning in this profile.
[[nodiscard]] std::optional<std::string> value_text(const Profile& profile, const std::string& key);
/// @pre as number_of; the value is checked only when the profile is read again
void set_number(Profile& profile, const std::string& key, double value);
/// What follows from `process`, after a change of it: parts that are cut from sheet are stacks of plates.
void follow_process(Profile& profile);
/// `value` [SI] as the key's new value, in the key's unit with 6 significant digits. @pre as number_of
[[nodiscard]] Edit number_edit(const Profile& profile, const std::string& key, double value, std::string why);
/// @pre `key` is a key of text
[[nodiscard]] Edit text_edit(const Profile& profile, const std::string& key, const std::string& value, std::string why);
/// The name of a profile made from that of `name`: "x-fixed" for "x", "x-fixed-2" for "x-fixed", so that both can be made into one folder;
/// a long name is cut.
[[nodiscard]] std::string derived_name(const std::string& name, const std::string& ending);
/// The profile's new name, derived_name; without a comment.
[[nodiscard]] Edit name_edit(const Profile& profile, const std::string& ending);
/// The CSV files of the profile, with paths relative to another folder.
[[nodiscard]] std::vector<Edit> file_edits(const Profile& profile, const std::filesystem::path& folder);

/// Table [columns] as TOML, an empty line before it; "" if it is empty.
[[nodiscard]] std::string columns_toml(const core::CsvMapping& columns);

/// `toml` with each edit made: only the value is replaced; a missing key is added below its table's heading, or with its table at the end.
/// A comment above each states the old value and the reason; the edit's `origin` replaces the comment behind the old value. A key that no
/// longer applies after an edit (the pitch of a path that becomes planar) becomes a comment. `head`, a comment line, goes first.
/// @param toml the text that `profile` was read from
/// @throws core::InvalidInput naming a key that cannot be added or removed: its table is inline, or uses dotted keys
[[nodiscard]] std::string with_edits(std::string toml, const Profile& profile, const std::vector<Edit>& edits,
                                     const std::string& head = {});

}  // namespace fusee::profile
