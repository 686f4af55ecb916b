#include "fixture.h"
#include "refused.h"

namespace fusee::study {
namespace {

class Reading : public StudyFolder {
protected:
    std::string refused(const std::string& tail) const {
        const std::string field = field_refused([&] { return study(tail); });
        const std::size_t file = field.find("s.toml");
        return file == std::string::npos ? field : field.substr(file);
    }
};

constexpr const char* kOneKey = "[vary]\ncable.diameter_mm = [0.6, 0.8]\n";

TEST_F(Reading, DefaultsAreAGridOfEverything) {
    const Study study = this->study(kOneKey);
    EXPECT_EQ(study.name, "s");
    EXPECT_EQ(study.method, Method::kGrid);
    EXPECT_EQ(study.outputs, Outputs::kAll);
    ASSERT_EQ(study.vary.size(), 1U);
    EXPECT_EQ(study.vary[0].values, (std::vector<std::string>{"0.6", "0.8"}));
}

TEST_F(Reading, KeysKeepTheOrderOfTheFile) {
    const Study study = this->study("[vary]\nrig.peak_torque_Nm = [1.0]\ncable.diameter_mm = [0.6]\n\"rig.gear_friction\" = [0.2]\n");
    std::vector<std::string> keys;
    for (const Variation& v : study.vary) keys.push_back(v.key);
    EXPECT_EQ(keys, (std::vector<std::string>{"rig.peak_torque_Nm", "cable.diameter_mm", "rig.gear_friction"}));
}

TEST_F(Reading, MistakesAreNamedWithLineAndKey) {
    EXPECT_EQ(refused(std::string("kind = 1\n") + kOneKey), "s.toml:3:1: study.kind");
    EXPECT_EQ(refused(std::string("method = \"all\"\n") + kOneKey), "s.toml:3:10: method");
    EXPECT_EQ(refused(std::string("method = \"random\"\n") + kOneKey), "s.toml:1:1: study.count");
    EXPECT_EQ(refused(std::string("count = 5\n") + kOneKey), "s.toml:1:1: study.count");
    EXPECT_EQ(refused("[vary]\ncable.diameter_mm = 3\n"), "s.toml:4:21: vary.cable.diameter_mm");
    EXPECT_EQ(refused("[vary]\ncable.diameter_mm = []\n"), "s.toml:4:21: vary.cable.diameter_mm");
    EXPECT_EQ(refused("[vary]\ncable.diameter_mm = {from = 1, to = 2, step = 2}\n"), "s.toml:4:40: vary.cable.diameter_mm.step");
    EXPECT_EQ(refused("[vary]\ncable.diameter_mm = {from = 0.5, to = 2.0}\n"), "s.toml:1:1: vary.cable.diameter_mm");
    EXPECT_EQ(refused("[vary]\ncable.diameter_mm = {from = 0.0, to = 2.0, steps = 2, scale = \"logarithmic\"}\n"),
              "s.toml:4:21: vary.cable.diameter_mm");
    EXPECT_EQ(refused("name = \"a/b\"\n" + std::string(kOneKey)), "s.toml: study.name");
    EXPECT_EQ(refused(""), "s.toml:1:1: vary");
}

TEST_F(Reading, AStudyIsTakenForAProfileByNobody) {
    EXPECT_TRUE(is_study(write("a.toml", "[study]\nbase = \"b.toml\"\n")));
    EXPECT_FALSE(is_study(FUSEE_SOURCE_DIR "/profiles/pnrvsa.toml"));
}

TEST_F(Reading, TheShippedStudyIsRead) {
    const Plan plan(read_study(FUSEE_SOURCE_DIR "/profiles/studies/pnrvsa.toml"));
    EXPECT_EQ(plan.size(), 2000U);
    EXPECT_EQ(plan.profile(plan.at(1999)).name, "pnrvsa-1999");
}

}  // namespace
}  // namespace fusee::study
