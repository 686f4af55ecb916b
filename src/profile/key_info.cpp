#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "fusee/profile/keys.h"
#include "key.h"

namespace fusee::profile {

namespace {

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

}  // namespace

std::vector<KeyInfo> key_infos() {
    std::vector<KeyInfo> all;
    for (const Key& key : keys()) all.push_back(info_of(key));
    return all;
}

std::vector<KeyInfo> find_keys(const std::vector<std::string>& words) {
    return asked_for(key_infos(), words, begins, has_word, refuse_word);
}

}  // namespace fusee::profile
