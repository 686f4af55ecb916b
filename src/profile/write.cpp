#include <fmt/format.h>

#include <charconv>

#include "fusee/profile/edit.h"
#include "fusee/spring/coil.h"
#include "key.h"
#include "overrides.h"

namespace fusee::profile {

namespace {

constexpr std::size_t kCommentColumn = 34;

/// Is the part of a single spring a roller's rim, so that nothing has a cable?
bool rolls(const Profile& profile) {
    const auto* one = std::get_if<OneSpring>(&profile.law.curves);
    return one != nullptr && one->family == OneSpring::Family::kRoller;
}

/// Every key at its default, of a law of the same kind.
Profile untouched_as(const Profile& profile) {
    Profile untouched;
    std::visit([&](const auto& curves) { untouched.law.curves = std::decay_t<decltype(curves)>{}; }, profile.law.curves);
    return untouched;
}

/// Does the key differ from its default? A required one has none. A roller's profile has a cable where its file has one.
bool is_stated(const Key& key, const Profile& profile, const Profile& untouched) {
    if (key.path == "kind") return profile.is_spring();
    if (key.table() == "cable" && rolls(profile) && !profile.places.contains(key.path)) return false;
    return key.required || toml_text(key, profile) != toml_text(key, untouched);
}

/// Does the value follow from others in the file's place? It would not if it were written: a margin that the file leaves out goes where
/// nothing is in the way of an anchor; turns that it leaves out are as many as the rate asks for, even too few to be stated.
bool follows(const Key& key, const Profile& profile) {
    if (profile.places.contains(key.path)) return false;
    if (key.leaf() == "margin_deg") return !is_stated(key, profile, {});
    if (key.leaf() != "active_coils") return false;
    const spring::BaseSpring& s = (key.of == Key::Of::kSpring      ? profile.part(profile.part_kinds().front())
                                   : key.path.starts_with("k_se.") ? profile.k_se
                                                                   : profile.k_pe)
                                      .spring;
    return spring::coil_known(s) && s.rate > 0.0 && s.active_coils == spring::turns_for_rate(s);
}

}  // namespace

std::string to_toml(const Profile& profile) {
    std::string toml, table;
    for (const Key& key : keys()) {
        if (!applies(key, profile) || follows(key, profile)) continue;
        if (key.table() != table) toml += fmt::format("\n[{}]\n", table = key.table());
        toml += fmt::format("{} = {}\n", key.leaf(), toml_text(key, profile));
    }
    return toml + columns_toml(profile.columns) + overrides_toml(profile.limits);
}

std::string to_commented_toml(const Profile& profile) {
    const Profile untouched = untouched_as(profile);
    std::string toml, table;
    for (const Key& key : keys()) {
        if (!applies(key, profile) || !is_stated(key, profile, untouched)) continue;
        if (key.table() != table) toml += fmt::format("\n[{}]\n", table = key.table());
        const std::string line = fmt::format("{} = {}", key.leaf(), toml_text(key, profile));
        const std::size_t gap = line.size() < kCommentColumn ? kCommentColumn - line.size() : 1;
        toml += fmt::format("{}{}# {}\n", line, std::string(gap, ' '), key.meaning);
    }
    return toml + columns_toml(profile.columns) + overrides_toml(profile.limits);
}

Profile rounded(Profile profile, int digits) {
    const Profile untouched = untouched_as(profile);
    for (const Key& key : keys()) {
        if (key.kind != Kind::kNumber || !applies(key, profile)) continue;
        const double now = std::get<double>(key.get(profile));  // a default of more digits would be stated by fewer
        if (now == std::get<double>(key.get(untouched))) continue;
        const std::string text = fmt::format("{:.{}g}", key.unit.from_si(now), digits);
        double value = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        key.set(profile, key.unit.to_si(value));
    }
    return profile;
}

}  // namespace fusee::profile
