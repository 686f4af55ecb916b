#include <set>
#include <sstream>

#include "fusee/checks/check.h"
#include "profile/fixture.h"

// Every key that a rule asks for when it is not judged is one that a profile may state.
namespace fusee::profile {
namespace {

/// "k_se.spring.wire_mm": table and key of each row of the reference.
std::set<std::string> known_keys() {
    std::set<std::string> keys;
    std::vector<std::string> tables;
    std::istringstream lines(profile_reference());
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("### ")) {
            tables.clear();
            for (std::size_t at = line.find('['); at != std::string::npos; at = line.find('[', at + 1))
                tables.push_back(line.substr(at + 1, line.find(']', at) - at - 1));
        }
        if (!line.starts_with("| `")) continue;
        for (const std::string& table : tables) keys.insert(table + "." + line.substr(3, line.find('`', 3) - 3));
    }
    return keys;
}

TEST(Needs, AreKeysOfAProfile) {
    const std::set<std::string> known = known_keys();
    ASSERT_TRUE(known.count("k_pe.spring.rate_N_per_m") && known.count("cable.diameter_mm")) << "the reference is read";
    for (const checks::Rule& rule : checks::rules())
        for (const checks::Need& need : rule.needs) {
            std::vector<const char*> keys{need.key};
            for (const char* other : need.or_else)
                if (other != nullptr) keys.push_back(other);
            for (const char* key : keys)
                EXPECT_TRUE(known.count(checks::Need::in_profile(key, "k_se")) || known.count(checks::Need::in_profile(key, "k_pe")))
                    << rule.id << ": " << key;
        }
}

}  // namespace
}  // namespace fusee::profile
