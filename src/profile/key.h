#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "fusee/core/lists.h"
#include "fusee/core/units.h"
#include "fusee/profile/keys.h"
#include "fusee/profile/profile.h"

/// The list of keys: the only schema of a profile. Reading, refusing, writing, `fusee keys` and docs/profile.md all use it.
namespace fusee::profile {

/// SI = value * numerator / denominator: with integers of one digit or ten's powers, "0.8 mm" becomes the double nearest to 8e-4.
struct Unit {
    const char* name = "";
    double numerator = 1.0, denominator = 1.0;
    [[nodiscard]] double to_si(double value) const { return value * numerator / denominator; }
    [[nodiscard]] double from_si(double si) const { return si * denominator / numerator; }
};
/// That of the ending of a key's name: "k_se.hub.bore_mm" is in mm; a pure number without one.
[[nodiscard]] Unit unit_of(std::string_view path);

/// Allowed numbers, in the key's unit; always finite.
struct Limits {
    double low = 0.0, high = 0.0;
    bool low_allowed = true, zero_allowed = false;
    [[nodiscard]] bool hold(double value) const {  // false for NaN
        return (zero_allowed && value == 0.0) || ((low_allowed ? value >= low : value > low) && value <= high);
    }
};
constexpr Limits within(double low, double high) { return {low, high, true}; }
constexpr Limits above(double low, double high) { return {low, high, false}; }
/// 0 has a meaning of its own, such as unknown. `low` is the least that anybody builds or buys: a smaller figure, such as 1e-9 load cycles,
/// would only make a rule pass.
constexpr Limits or_zero(double low, double high) { return {low, high, true, true}; }

/// Letters of a Kind::kText: the longest that a field of a title block holds in letters of 1.8 mm.
inline constexpr std::size_t kLongestLine = 40;

enum class Kind { kNumber, kInteger, kName, kText, kFile, kFormula, kChoice, kSign, kSwitch, kNumbers, kChoices };

/// Numbers in SI.
using Value = std::variant<double, int, bool, std::string, std::vector<double>, std::vector<std::string>>;

/// The key applies only if another one, earlier in the list, has one of these values; "" among them: if that one is missing.
struct Condition {
    std::string key;
    std::vector<std::string> values;
    /// "only with law.kind = "table"", "only without law.file"; with the given quotes around the key and each value.
    [[nodiscard]] std::string text(std::string_view key_quote, std::string_view value_quote) const;
};

struct Key {
    // Not inline: lists of keys copy and destroy hundreds.
    Key();
    Key(const Key&);
    Key(Key&&) noexcept;
    Key& operator=(const Key&);
    Key& operator=(Key&&) noexcept;
    ~Key();

    std::string path;  ///< "k_se.guide.direction_deg"
    Kind kind = Kind::kNumber;
    std::string meaning;  ///< one line
    Unit unit;            ///< of numbers: unit_of(path)
    Limits limits{};
    std::size_t least_count = 1, most_count = 1;  ///< of an array
    std::vector<std::string> choices;
    bool required = false;
    enum class Of { kAny, kJoint, kSpring };
    Of of = Of::kAny;             ///< the kind of profile that has the key; two keys of different kinds may have one path
    std::vector<Condition> when;  ///< all must hold; asked in this order
    std::function<Value(const Profile&)> get;
    std::function<void(Profile&, const Value&)> set;

    [[nodiscard]] std::string table() const;  ///< "k_se.guide"; "" at the top
    [[nodiscard]] std::string leaf() const;   ///< "direction_deg"
    [[nodiscard]] bool of_part() const;       ///< in the tables that only make needs: a profile has all of them or none
};

[[nodiscard]] const std::vector<Key>& keys();
/// nullptr if there is none.
[[nodiscard]] const Key* find_key(std::string_view path);
/// The key of this kind of profile, if both kinds have one of that path.
[[nodiscard]] const Key* find_key(std::string_view path, const Profile& profile);
[[nodiscard]] bool is_table(std::string_view path);
/// The known key that is most similar to `path`, of this kind of profile; without a profile of any kind.
[[nodiscard]] const Key& nearest_key(std::string_view path, const Profile* profile = nullptr);
[[nodiscard]] std::string nearest_table(std::string_view path, const Profile& profile);
[[nodiscard]] const checks::RuleInfo& nearest_rule(std::string_view id, const RuleInfos& rules);

/// Is the key one of this kind of profile?
[[nodiscard]] bool is_of(const Key& key, const Profile& profile);
/// A profile of the key's kind with the first values of its conditions.
[[nodiscard]] Profile profile_for(const Key& key);
/// Does the key apply in this profile, as far as it is read?
[[nodiscard]] bool applies(const Key& key, const Profile& profile);
/// "a number above 0, at most 95", "\"planar\" or \"helix\"".
[[nodiscard]] std::string allowed_text(const Key& key);
/// The key's value as TOML, numbers in the key's unit with the fewest digits that give the same SI number.
[[nodiscard]] std::string toml_text(const Key& key, const Profile& profile);

/// The keys of each table, in its file.
[[nodiscard]] std::vector<Key> rig_keys();
[[nodiscard]] std::vector<Key> law_keys();
[[nodiscard]] std::vector<Key> one_spring_keys();
[[nodiscard]] std::vector<Key> simulation_keys();
[[nodiscard]] std::vector<Key> design_keys();
[[nodiscard]] std::vector<Key> codesign_keys();
[[nodiscard]] std::vector<Key> assembly_keys();
[[nodiscard]] std::vector<Key> budget_keys();
[[nodiscard]] std::vector<Key> drawing_keys();
[[nodiscard]] std::vector<Key> machining_keys();
[[nodiscard]] std::vector<Key> compensation_keys();
[[nodiscard]] std::vector<Key> part_keys(const std::string& part);

// Makers of keys: `at` finds the member in a profile, FIELD one of the profile itself.
#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }
template <class T>
using At = std::function<T&(Profile&)>;
/// The profile's own name.
[[nodiscard]] Key name_key(std::string path, std::string meaning, At<std::string> at);
/// Missing or "": none.
[[nodiscard]] Key file(std::string path, std::string meaning, At<std::filesystem::path> at);
[[nodiscard]] Key formula(std::string path, std::string meaning, At<std::string> at);
/// One line of text; missing or "": not stated.
[[nodiscard]] Key text_line(std::string path, std::string meaning, At<std::string> at);
[[nodiscard]] Key number(std::string path, Limits limits, std::string meaning, At<double> at);
[[nodiscard]] Key integer(std::string path, Limits limits, std::string meaning, At<int> at);
[[nodiscard]] Key sign(std::string path, std::string meaning, At<int> at);
[[nodiscard]] Key yes_or_no(std::string path, std::string meaning, At<bool> at);
[[nodiscard]] Key numbers(std::string path, Limits limits, std::size_t least, std::size_t most, std::string meaning,
                          At<std::vector<double>> at);
/// Two numbers, the lower first (the module that uses it refuses another order).
[[nodiscard]] Key range(std::string path, Limits limits, std::string meaning, At<core::Range> at);

/// A text from a list.
[[nodiscard]] Key choice(std::string path, std::vector<std::string> names, std::string meaning, At<std::string> at);
/// The same of a number that counts along the list.
[[nodiscard]] Key choice(std::string path, std::vector<std::string> names, std::string meaning, std::function<std::size_t(Profile&)> get,
                         std::function<void(Profile&, std::size_t)> set);
/// The same of an enum: the list names its values in order.
template <class Find, class Member = std::remove_reference_t<std::invoke_result_t<Find, Profile&>>>
requires std::is_enum_v<Member> Key choice(std::string path, std::vector<std::string> names, std::string meaning, Find at) {
    return choice(
        std::move(path), std::move(names), std::move(meaning), [at](Profile& p) { return static_cast<std::size_t>(at(p)); },
        [at](Profile& p, std::size_t place) { at(p) = static_cast<Member>(place); });
}

inline std::vector<Key> all_of(Key::Of of, std::vector<Key> keys) {
    for (Key& key : keys) key.of = of;
    return keys;
}
inline Key required(Key key) {
    key.required = true;
    return key;
}
inline Key when(std::string other, std::vector<std::string> values, Key key) {
    key.when.insert(key.when.begin(), {std::move(other), std::move(values)});
    return key;
}

}  // namespace fusee::profile
