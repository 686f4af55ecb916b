#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "fusee/core/file.h"
#include "fusee/effects/effect.h"
#include "fusee/joint_model/signals.h"
#include "joint_model/fixture.h"

// docs/guides/add-an-effect.md: its code compiles, its known answer holds, the files that it names exist.
namespace fusee::guide {

using namespace fixtures;
using joint_model::BuiltRig;
using joint_model::BuiltSide;

/// The library with the effect of the guide in it.
namespace effects {
using namespace fusee::effects;
const std::vector<Effect> kLibrary{
#include "effect.h"  // of the guide
};
const Effect& find_effect(const std::string&) { return kLibrary.front(); }
}  // namespace effects

const gap_case::NominalRig kRig = straight_rig();
constexpr gap_case::Protocol kSlow{.joint_stiffness_phase = 20.0};

std::vector<double> read(const BuiltRig& rig, const gap_case::Rows& rows, gap_case::Experiment experiment,
                         const gap_case::Protocol& protocol) {
    return joint_model::predict_experiment(rig, rows, protocol, experiment);
}

#include "known_answer.h"

TEST(Guide, NamesFilesThatExist) {
    const std::filesystem::path source = FUSEE_SOURCE_DIR;
    const std::string page = core::read_file(source / "docs/guides/add-an-effect.md");
    const std::regex path("`((?:src|include|tests)/[a-z_/]+(?:\\.cpp|\\.h)?)`");
    int files = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), path), end; at != end; ++at, ++files) {
        const std::string name = (*at)[1];
        EXPECT_TRUE(std::filesystem::exists(source / name)) << name;
    }
    EXPECT_GT(files, 5);
}

}  // namespace fusee::guide
