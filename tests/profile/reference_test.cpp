#include "profile/fixture.h"

namespace fusee::profile {
namespace {

TEST(Reference, StandsInTheDocumentationWordForWord) {
    const std::string page = core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / "docs" / "profile.md");
    EXPECT_NE(page.find(profile_reference()), std::string::npos)
        << "docs/profile.md is out of date: replace everything below its heading \"Keys\" by\n"
        << profile_reference();
}

TEST(Reference, NamesDefaultsFromTheRooms) {
    const std::string text = profile_reference();
    expect_words(text, {"| `radius_ratio` | 0.5 to 2 | `0.53` |", "| `throat_deg` | 0 to 150 deg | `90` |",
                        "### `[k_se.guide]`, `[k_pe.guide]`", "(`kind` = `table`)", "As in `[k_se.spring]`: `rate_origin`"});
}

}  // namespace
}  // namespace fusee::profile
