#include "companions.h"

#include "key.h"

namespace fusee::profile {

namespace {

/// All companions of one part.
std::vector<Companions> asked_of(const std::string& part) {
    const std::string hub = part + ".hub.", path = part + ".path.", guide = part + ".guide.";
    return {{guide + "kind", "point", {guide + "distance_mm"}},
            {guide + "kind", "idler", {guide + "distance_mm"}},
            {hub + "kind", "overhung", {hub + "boss_mm", hub + "boss_height_mm"}},
            {hub + "lock", "set_screw", {hub + "screw_mm", hub + "boss_mm", hub + "boss_height_mm"}},
            {path + "lead", "constant_pitch", {path + "pitch_mm"}}};
}

bool is_set(const std::string& path, const Profile& profile) { return std::get<double>(find_key(path)->get(profile)) > 0.0; }

}  // namespace

std::vector<Companions> missing_companions(const Profile& profile) {
    std::vector<Companions> missing;
    if (!profile.has_parts) return missing;
    for (const char* part : {"k_se", "k_pe", "cam"})
        for (Companions& asked : asked_of(part)) {
            const Key& key = *find_key(asked.key);
            if (!applies(key, profile) || std::get<std::string>(key.get(profile)) != asked.value) continue;
            std::erase_if(asked.needs, [&profile](const std::string& path) { return is_set(path, profile); });
            if (!asked.needs.empty()) missing.push_back(std::move(asked));
        }
    return missing;
}

}  // namespace fusee::profile
