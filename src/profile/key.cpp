#include "key.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::profile {

namespace {

constexpr int kMostDigits = 17;  // any double survives 17 significant digits
constexpr int kNeighbours = 8;   // two roundings each way: the value that was read is within a few units of the last place

/// The shortest number that is read as `si`.
std::string shortest(double si, const Unit& unit) {
    double value = 0.0;
    for (int digits = 1; digits <= kMostDigits; ++digits) {
        const std::string text = fmt::format("{:.{}g}", unit.from_si(si), digits);
        std::from_chars(text.data(), text.data() + text.size(), value);
        if (unit.to_si(value) == si) return fmt::format("{}", value);
    }
    double below = value, above = value;
    for (int i = 0; i < kNeighbours; ++i) {
        below = std::nextafter(below, -std::numeric_limits<double>::infinity());
        above = std::nextafter(above, std::numeric_limits<double>::infinity());
        if (unit.to_si(below) == si) return fmt::format("{}", below);
        if (unit.to_si(above) == si) return fmt::format("{}", above);
    }
    return fmt::format("{}", value);
}

std::vector<std::string> all_quoted(const std::vector<std::string>& texts) { return core::each<std::string>(texts, core::quoted); }

std::string range_text(const Limits& limits, const Unit& unit) {
    const std::string name = unit.name;
    return fmt::format("{}{}",
                       limits.zero_allowed  ? fmt::format("0, or {:g} to {:g}", limits.low, limits.high)
                       : limits.low_allowed ? fmt::format("{:g} to {:g}", limits.low, limits.high)
                                            : fmt::format("above {:g}, at most {:g}", limits.low, limits.high),
                       name.empty() ? "" : " " + name);
}

std::string count_text(const Key& key) {
    if (key.least_count == key.most_count) return fmt::format("{}", key.least_count);
    return fmt::format("{} to {}", key.least_count, key.most_count);
}

/// A number outside the limits: below them where that is not far, else above.
std::string outside(const Limits& limits) {
    if (limits.zero_allowed) return fmt::format("{:g}", 0.5 * limits.low);
    if (!limits.low_allowed) return fmt::format("{:g}", limits.low);
    return fmt::format("{:g}", limits.low > -1e6 ? limits.low - 1.0 : limits.high + 1.0);
}

std::string refused_example(const Key& key) {
    switch (key.kind) {
        case Kind::kNumber:
        case Kind::kInteger:
            return outside(key.limits);
        case Kind::kName:
            return "\"a b\"";
        case Kind::kChoice:
            return "\"other\"";
        case Kind::kSign:
            return "0";
        case Kind::kSwitch:
            return "\"yes\"";
        case Kind::kNumbers:
            return key.least_count > 0 ? "[]" : "[" + outside(key.limits) + "]";
        case Kind::kChoices:
            return "[\"other\"]";
        case Kind::kText:
        case Kind::kFile:
        case Kind::kFormula:
            break;  // a text is refused for its length or its content
    }
    return "";
}

std::string default_of(const Key& key) {
    if (key.required) return "";
    const Profile untouched = profile_for(key);
    return toml_text(key, untouched);
}

KeyInfo info_of(const Key& key) {
    KeyInfo info{key.path,        key.table(),          key.meaning, key.unit.name, allowed_text(key),
                 default_of(key), refused_example(key), {},          key.required};
    if (key.of == Key::Of::kSpring) info.when.push_back("only with kind = \"spring\"");
    for (const Condition& when : key.when) info.when.push_back(when.text("", "\""));
    return info;
}

bool begins(const KeyInfo& key, const std::string& word) { return core::lower(key.path).starts_with(word); }
bool has_word(const KeyInfo& key, const std::string& word) {
    return core::lower(key.path + " " + key.meaning).find(word) != std::string::npos;
}

/// A word that no key has.
[[noreturn]] void refuse_word(const std::string& word) {
    std::vector<std::string> names;
    for (const Key& key : keys())
        for (const std::string& name : {key.table(), key.path, key.leaf()}) names.push_back(name);
    throw core::InvalidInput("keys", word, "the beginning of a key, or a word in a key or its meaning" + core::did_you_mean(word, names));
}

Key plain(std::string path, Kind kind, std::string meaning) {
    Key key;
    key.path = std::move(path);
    key.kind = kind;
    key.meaning = std::move(meaning);
    return key;
}

/// The member as a value of the same type, or, of a path, as its text. `at` only finds it: the profile may be const.
template <class T, class Member>
Key of_member(std::string path, Kind kind, std::string meaning, At<Member> at) {
    Key key = plain(std::move(path), kind, std::move(meaning));
    key.get = [at](const Profile& p) { return Value(T(at(const_cast<Profile&>(p)))); };
    key.set = [at](Profile& p, const Value& v) { at(p) = std::get<T>(v); };
    return key;
}

template <class T>
Key limited(std::string path, Kind kind, Limits limits, std::string meaning, At<T> at) {
    Key key = of_member<T>(std::move(path), kind, std::move(meaning), std::move(at));
    key.unit = unit_of(key.path);
    key.limits = limits;
    return key;
}

}  // namespace

Key::Key() = default;
Key::Key(const Key&) = default;
Key::Key(Key&&) noexcept = default;
Key& Key::operator=(const Key&) = default;
Key& Key::operator=(Key&&) noexcept = default;
Key::~Key() = default;

Unit unit_of(std::string_view path) {
    static constexpr std::pair<std::string_view, Unit> kEndings[] = {// of two that fit, the longer one first
                                                                     {"_Nm_per_rad", {"Nm/rad"}},
                                                                     {"_per_Nm_rad", {"1/(Nm rad)"}},
                                                                     {"_rad_per_Nm", {"rad/Nm"}},
                                                                     {"_g_per_cm3", {"g/cm^3", 1e3, 1.0}},
                                                                     {"_mm_per_min", {"mm/min", 1.0, 60e3}},
                                                                     {"_N_per_m", {"N/m"}},
                                                                     {"_per_rad", {"1/rad"}},
                                                                     {"_percent", {"percent", 1.0, 100.0}},
                                                                     {"_kgm2", {"kg m^2"}},
                                                                     {"_Nm2s", {"(Nm)^2 s"}},
                                                                     {"_MPa", {"MPa", 1e6, 1.0}},
                                                                     {"_Nms", {"Nm s"}},
                                                                     {"_deg", {"deg", core::kPi, 180.0}},
                                                                     {"_rad", {"rad"}},
                                                                     {"_rpm", {"1/min"}},
                                                                     {"_Nm", {"Nm"}},
                                                                     {"_mm", {"mm", 1.0, 1e3}},
                                                                     {"_kg", {"kg"}},
                                                                     {"_Hz", {"Hz"}},
                                                                     {"_N", {"N"}}};
    for (const auto& [ending, unit] : kEndings)
        if (path.ends_with(ending)) return unit;
    return {};
}

std::string Key::table() const {
    const auto dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(0, dot);
}

std::string Key::leaf() const { return path.substr(path.rfind('.') + 1); }

bool Key::of_part() const {
    static constexpr std::array kTables{"cable",        "groove", "process", "material", "tolerances", "outputs", "machining",
                                        "compensation", "k_se",   "k_pe",    "assembly", "budget",     "drawing", "cam"};
    return std::find(kTables.begin(), kTables.end(), path.substr(0, path.find('.'))) != kTables.end();
}

std::string Condition::text(std::string_view key_quote, std::string_view value_quote) const {
    const std::string other = fmt::format("{0}{1}{0}", key_quote, key);
    if (std::find(values.begin(), values.end(), "") != values.end()) return "only without " + other;
    std::vector<std::string> named;
    for (const std::string& value : values) named.push_back(fmt::format("{0}{1}{0}", value_quote, value));
    return fmt::format("only with {} = {}", other, fmt::join(named, " or "));
}

bool is_name(std::string_view text) {
    const auto letter_or_digit = [](unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; };
    const auto plain = [&](unsigned char c) { return letter_or_digit(c) || c == '.' || c == '_' || c == '-'; };
    return !text.empty() && text.size() <= kLongestName && letter_or_digit(static_cast<unsigned char>(text.front())) &&
           std::all_of(text.begin(), text.end(), plain);
}

const Key* find_key(std::string_view path) {
    for (const Key& key : keys())
        if (key.path == path) return &key;
    return nullptr;
}

const Key* find_key(std::string_view path, const Profile& profile) {
    for (const Key& key : keys())
        if (key.path == path && is_of(key, profile)) return &key;
    return find_key(path);
}

bool is_table(std::string_view path) {
    const std::string prefix = std::string(path) + ".";
    return std::any_of(keys().begin(), keys().end(), [&](const Key& key) { return key.path.starts_with(prefix); });
}

bool is_of(const Key& key, const Profile& profile) {
    return key.of == Key::Of::kAny || (key.of == Key::Of::kSpring) == profile.is_spring();
}

Profile profile_for(const Key& key) {
    Profile profile;
    if (key.of == Key::Of::kSpring) profile.law.curves = OneSpring{};
    for (const Condition& when : key.when) find_key(when.key)->set(profile, when.values.front());
    return profile;
}

bool applies(const Key& key, const Profile& profile) {
    if (!is_of(key, profile)) return false;
    if (key.of_part() && !profile.has_parts) return false;
    return std::all_of(key.when.begin(), key.when.end(), [&profile](const Condition& when) {
        const std::string now = std::get<std::string>(find_key(when.key)->get(profile));
        return std::find(when.values.begin(), when.values.end(), now) != when.values.end();
    });
}

std::string allowed_text(const Key& key) {
    switch (key.kind) {
        case Kind::kNumber:
            return "a number, " + range_text(key.limits, key.unit);
        case Kind::kInteger:
            return "a whole number, " + range_text(key.limits, key.unit);
        case Kind::kName:
            return kAllowedName;
        case Kind::kText:
            return fmt::format("a text of one line, at most {} letters, \"\" = not stated", kLongestLine);
        case Kind::kFile:
            return key.required ? "a file name as text" : "a file name as text, \"\" = none";
        case Kind::kFormula:
            return key.required ? "a formula as text" : "a formula as text, \"\" = none";
        case Kind::kChoice:
            return fmt::format("{}", fmt::join(all_quoted(key.choices), " or "));
        case Kind::kSign:
            return "1 or -1";
        case Kind::kSwitch:
            return "true or false";
        case Kind::kNumbers:
            return fmt::format("an array of {} numbers, each {}", count_text(key), range_text(key.limits, key.unit));
        case Kind::kChoices:
            return fmt::format("an array of {} different ones of {}", count_text(key), fmt::join(all_quoted(key.choices), ", "));
    }
    return "";
}

std::string toml_text(const Key& key, const Profile& profile) {
    const Value value = key.get(profile);
    if (const auto* number = std::get_if<double>(&value)) return shortest(*number, key.unit);
    if (const auto* whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
    if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
    if (const auto* text = std::get_if<std::string>(&value)) return core::quoted(*text);
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) return fmt::format("[{}]", fmt::join(all_quoted(*texts), ", "));
    std::vector<std::string> cells;
    for (const double number : std::get<std::vector<double>>(value)) cells.push_back(shortest(number, key.unit));
    return fmt::format("[{}]", fmt::join(cells, ", "));
}

std::vector<KeyInfo> key_infos() {
    return core::each<KeyInfo>(keys(), [&](const Key& key) { return info_of(key); });
}

std::vector<KeyInfo> find_keys(const std::vector<std::string>& words) {
    return asked_for(key_infos(), words, begins, has_word, refuse_word);
}

Key name_key(std::string path, std::string meaning, At<std::string> at) {
    return of_member<std::string>(std::move(path), Kind::kName, std::move(meaning), std::move(at));
}

Key file(std::string path, std::string meaning, At<std::filesystem::path> at) {
    return of_member<std::string>(std::move(path), Kind::kFile, std::move(meaning), std::move(at));
}

Key formula(std::string path, std::string meaning, At<std::string> at) {
    return of_member<std::string>(std::move(path), Kind::kFormula, std::move(meaning), std::move(at));
}

Key text_line(std::string path, std::string meaning, At<std::string> at) {
    return of_member<std::string>(std::move(path), Kind::kText, std::move(meaning), std::move(at));
}

Key number(std::string path, Limits limits, std::string meaning, At<double> at) {
    return limited(std::move(path), Kind::kNumber, limits, std::move(meaning), std::move(at));
}

Key integer(std::string path, Limits limits, std::string meaning, At<int> at) {
    return limited(std::move(path), Kind::kInteger, limits, std::move(meaning), std::move(at));
}

Key sign(std::string path, std::string meaning, At<int> at) {
    return of_member<int>(std::move(path), Kind::kSign, std::move(meaning), std::move(at));
}

Key yes_or_no(std::string path, std::string meaning, At<bool> at) {
    return of_member<bool>(std::move(path), Kind::kSwitch, std::move(meaning), std::move(at));
}

Key numbers(std::string path, Limits limits, std::size_t least, std::size_t most, std::string meaning, At<std::vector<double>> at) {
    Key key = limited(std::move(path), Kind::kNumbers, limits, std::move(meaning), std::move(at));
    key.least_count = least;
    key.most_count = most;
    return key;
}

Key range(std::string path, Limits limits, std::string meaning, At<core::Range> at) {
    Key key = plain(std::move(path), Kind::kNumbers, std::move(meaning));
    key.unit = unit_of(key.path);
    key.limits = limits;
    key.least_count = key.most_count = 2;
    key.get = [at](const Profile& p) {
        const core::Range& ends = at(const_cast<Profile&>(p));
        return Value(std::vector<double>{ends.low, ends.high});
    };
    key.set = [at](Profile& p, const Value& v) {
        const auto& ends = std::get<std::vector<double>>(v);
        at(p) = {ends[0], ends[1]};
    };
    return key;
}

Key choice(std::string path, std::vector<std::string> names, std::string meaning, At<std::string> at) {
    Key key = of_member<std::string>(std::move(path), Kind::kChoice, std::move(meaning), std::move(at));
    key.choices = std::move(names);
    return key;
}

Key choice(std::string path, std::vector<std::string> names, std::string meaning, std::function<std::size_t(Profile&)> get,
           std::function<void(Profile&, std::size_t)> set) {
    Key key = plain(std::move(path), Kind::kChoice, std::move(meaning));
    key.get = [names, get](const Profile& p) { return Value(names.at(get(const_cast<Profile&>(p)))); };
    key.set = [names, set](Profile& p, const Value& v) {
        set(p, static_cast<std::size_t>(std::find(names.begin(), names.end(), std::get<std::string>(v)) - names.begin()));
    };
    key.choices = std::move(names);
    return key;
}

}  // namespace fusee::profile
