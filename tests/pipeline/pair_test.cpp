#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/batch/batch.h"
#include "fusee/checks/check.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/export.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

using exchange::PartFile;

/// The two sides of the shipped joint.
class BothSides : public fixtures::TempFolder {
protected:
    [[nodiscard]] batch::MakeResult made(const fixtures::Changes& changes) const {
        const auto text = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")), changes);
        return batch::make(profile::read_profile(write("pnrvsa.toml", text)), {.out = folder_ / "out"});
    }
    [[nodiscard]] static PartFile part(const batch::MakeResult& result, const std::string& name) {
        return exchange::read_part_file(result.folder / (name + ".json"));
    }
};

/// Known: y -> -y. Same arms and loads at the same cam angles, contacts on the other side, every sense the other way.
void expect_mirrored(const PartFile& left, const PartFile& right) {
    EXPECT_EQ(left.part, right.part);
    EXPECT_EQ(left.torque_sign, -right.torque_sign);
    EXPECT_EQ(left.rotation_sign, -right.rotation_sign);
    EXPECT_NEAR(left.guide.direction[0], right.guide.direction[0], 1e-15);
    EXPECT_DOUBLE_EQ(left.guide.direction[1], -right.guide.direction[1]);
    EXPECT_DOUBLE_EQ(left.spring_rate, right.spring_rate);
    EXPECT_NE(left.provenance.find("mirrored"), std::string::npos);
    ASSERT_EQ(left.target.size(), right.target.size());
    for (std::size_t i = 0; i < right.target.size(); ++i) {
        EXPECT_DOUBLE_EQ(left.target[i].angle_rad, right.target[i].angle_rad);
        EXPECT_DOUBLE_EQ(left.target[i].arm_mm, right.target[i].arm_mm);
        EXPECT_DOUBLE_EQ(left.target[i].load, right.target[i].load);
        EXPECT_DOUBLE_EQ(left.target[i].contact_mm[0], right.target[i].contact_mm[0]);
        EXPECT_DOUBLE_EQ(left.target[i].contact_mm[1], -right.target[i].contact_mm[1]);
    }
    const std::string name = right.part;
    ASSERT_EQ(left.files.size(), right.files.size());
    for (std::size_t i = 0; i < right.files.size(); ++i)
        EXPECT_EQ(left.files[i].name, name + "_mirrored" + right.files[i].name.substr(name.size()));
}

// Every format of the image is read back by its own PART.json alone, and the report lists it after the agonist's.
TEST_F(BothSides, HaveTheSameLawInEveryFile) {
    const batch::MakeResult result =
        made({{"outputs.formats", R"(["stl", "dxf", "step", "ngc"])"}, {"k_se.target_rows", "200"}, {"k_pe.target_rows", "200"}});
    ASSERT_TRUE(result.made);
    for (const std::string name : {"k_se", "k_pe"}) expect_mirrored(part(result, name + "_mirrored"), part(result, name));
    const auto report = nlohmann::json::parse(core::read_file(result.folder / "report.json"));
    ASSERT_EQ(report["parts"].size(), 2u);
    ASSERT_EQ(report["mirrored"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto &right = report["parts"][i], &left = report["mirrored"][i];
        EXPECT_EQ(left["part"], right["part"]);
        EXPECT_EQ(left["cam"]["torque_sign"], -right["cam"]["torque_sign"].get<int>());
        EXPECT_EQ(left["certificate"]["convex"], "proven");
        EXPECT_NEAR(left["mesh"]["volume_mm3"].get<double>(), right["mesh"]["volume_mm3"].get<double>(), 1e-6);
        EXPECT_GE(left["read_back"].size(), 5u);  // STL and DXF twice, STEP; G-code if rs274 is there
        EXPECT_EQ(left["read_back"].size(), right["read_back"].size());
        for (const auto& reading : left["read_back"]) {
            EXPECT_EQ(reading["passed"], true) << reading["file"];
            const std::string file = reading["file"];  // only an STL proves itself the image of the other
            EXPECT_EQ(reading.value("mirror_of", ""), file.ends_with(".stl") ? right["part"].get<std::string>() + ".stl" : "") << file;
        }
        for (const auto& reading : right["read_back"]) EXPECT_FALSE(reading.contains("mirror_of"));
        EXPECT_EQ(left["mesh"]["smallest_angle_deg"], right["mesh"]["smallest_angle_deg"]);
    }
    EXPECT_NE(core::read_file(result.folder / "report.html").find("k_se_mirrored.step"), std::string::npos);
}

// A part that is not mirrored does not carry its image's law: else the read-back would see nothing.
TEST_F(BothSides, IsNotTakenForTheOtherSide) {
    const batch::MakeResult result = made({{"outputs.formats", R"(["stl"])"}});
    ASSERT_TRUE(result.made);
    PartFile left = part(result, "k_se_mirrored");
    left.files = part(result, "k_se").files;
    for (const readback::ArmError& e : formats::read_back(result.folder, left)) EXPECT_FALSE(e.passed()) << e.reader;
}

TEST_F(BothSides, IsLeftOutWhereTheProfileWantsOneSide) {
    const batch::MakeResult result = made({{"outputs.formats", R"(["stl"])"}, {"outputs.pair", "false"}});
    ASSERT_TRUE(result.made);
    for (const auto& [name, bytes] : fixtures::contents(result.folder)) EXPECT_EQ(name.find("mirrored"), std::string::npos) << name;
}

// Why the image is not judged again: no rule tells left from right once the spring's coil has the other hand too.
class EveryRule : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Pipeline, EveryRule, testing::Values("pnrvsa", "first_prototype"),
                         [](const auto& one) { return std::string(one.param); });

TEST_P(EveryRule, SaysTheSameOfTheMirrorImage) {
    const profile::Profile profile = profile::read_profile(fixtures::shipped(GetParam()));
    const auto design = resolve(profile);
    ASSERT_TRUE(design);
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const Pair pair = pair_of(design_part(kind, *design).value(), true);
        const profile::PartSpec& spec = kind == cam::PartKind::kSeries ? profile.k_se : profile.k_pe;
        const spring::BaseSpring spring = mirrored(spec.spring);
        const core::Findings image = checks::check({pair.antagonist->part, spring, profile.cable, profile.process, profile.limits});
        const core::Findings& known = pair.agonist->findings;
        ASSERT_EQ(image.size(), known.size());
        for (std::size_t i = 0; i < known.size(); ++i) {
            EXPECT_EQ(image[i].rule, known[i].rule);
            EXPECT_EQ(image[i].severity, known[i].severity) << known[i].rule;
            if (known[i].severity == core::Severity::kNotJudged) continue;  // measures nothing
            EXPECT_NEAR(image[i].measured, known[i].measured, 1e-6 * std::abs(known[i].measured) + 1e-9) << known[i].rule;
        }
    }
}

TEST(MirroredSpring, HasItsCoilOfTheOtherHand) {
    spring::BaseSpring spring;
    EXPECT_EQ(mirrored(spring).hand, spring::Hand::kUnknown);
    spring.hand = spring::Hand::kRight;
    EXPECT_EQ(mirrored(spring).hand, spring::Hand::kLeft);
    EXPECT_EQ(mirrored(mirrored(spring)).hand, spring::Hand::kRight);
}

}  // namespace
}  // namespace fusee::pipeline
