#include "fusee/profile/keys.h"
#include "profile/fixture.h"

namespace fusee::profile {
namespace {

TEST(Reference, HasARowOfEveryKey) {
    const std::string text = profile_reference();
    for (const KeyInfo& key : key_infos()) {
        const std::string begin = "| `" + key.path.substr(key.path.rfind('.') + 1) + "` | ";
        expect_words(text, {begin.c_str(), ("| " + key.meaning).c_str(), key.unit.c_str()});
    }
    expect_words(text, {"### `[columns]`", "### `[[limits]]`"});
}

TEST(Reference, NamesDefaultsFromTheRooms) {
    const std::string text = profile_reference();
    expect_words(text, {"| `radius_ratio` | 0.5 to 2 | `0.53` |", "| `throat_deg` | 0 to 150 deg | `90` |",
                        "### `[k_se.guide]`, `[k_pe.guide]`", "(`kind` = `table`)", "As in `[k_se.spring]`: `rate_origin`"});
}

}  // namespace
}  // namespace fusee::profile
