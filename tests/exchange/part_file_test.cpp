#include "fusee/exchange/part_file.h"

#include <optional>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"

namespace fusee::exchange {
namespace {

class PartFileTest : public fixtures::FolderTest {
protected:
    static PartFile sample(const std::string& kind) {
        PartFile part = fixtures::disc_part({}, {kind, {0.0, 1.0}, {60.0, 40.0}, 6.0, -1, 2.5}, 1, -1);
        part.files = {{"k_pe.stl", "ab12", 40000, 0.002}, {"k_pe.scad", "cd34", 0, 0.002}};
        return part;
    }
};

TEST_F(PartFileTest, RoundtripIsExactForEveryGuide) {
    for (const char* kind : {"parallel", "point", "idler"}) {
        const PartFile part = sample(kind);
        write_part_file(folder_ / "p.json", part);
        const PartFile back = read_part_file(folder_ / "p.json");
        EXPECT_EQ(back.part, part.part);
        EXPECT_EQ(back.cable_diameter_mm, part.cable_diameter_mm);
        EXPECT_EQ(back.rotation_sign, -1);
        EXPECT_EQ(back.torque_sign, 1);
        EXPECT_EQ(back.guide.kind, kind);
        const bool parallel = back.guide.kind == "parallel";
        EXPECT_EQ(back.guide.direction, parallel ? part.guide.direction : PartGuide{}.direction);
        EXPECT_EQ(back.guide.position_mm, parallel ? PartGuide{}.position_mm : part.guide.position_mm);
        EXPECT_EQ(back.guide.z_mm, parallel ? 0.0 : 2.5);
        EXPECT_EQ(back.guide.sense, back.guide.kind == "idler" ? -1 : 1);
        EXPECT_EQ(back.spring_rate, part.spring_rate);
        EXPECT_EQ(back.spring_preload, part.spring_preload);
        EXPECT_EQ(back.provenance, part.provenance);
        ASSERT_EQ(back.target.size(), part.target.size());
        for (std::size_t i = 0; i < part.target.size(); ++i) {
            EXPECT_EQ(back.target[i].angle_rad, part.target[i].angle_rad);
            EXPECT_EQ(back.target[i].arm_mm, part.target[i].arm_mm);
            EXPECT_EQ(back.target[i].contact_mm, part.target[i].contact_mm);
        }
        ASSERT_EQ(back.files.size(), 2u);
        EXPECT_EQ(back.files[0].triangles, 40000u);
        EXPECT_EQ(back.files[0].sha256, "ab12");
    }
}

TEST_F(PartFileTest, KeepsThePlaceOfOneOfTwoPartsOnTheirShaft) {
    PartFile part = sample("point");
    write_part_file(folder_ / "p.json", part);
    EXPECT_FALSE(read_part_file(folder_ / "p.json").shaft);
    part.shaft = OnShaft{2.1, -1, 13.75};
    write_part_file(folder_ / "p.json", part);
    const std::optional<OnShaft> back = read_part_file(folder_ / "p.json").shaft;
    ASSERT_TRUE(back);
    EXPECT_EQ(back->first_rad, 2.1);
    EXPECT_EQ(back->sense, -1);
    EXPECT_EQ(back->height_mm, 13.75);
}

TEST_F(PartFileTest, SameBytesTwice) {
    write_part_file(folder_ / "a.json", sample("idler"));
    write_part_file(folder_ / "b.json", sample("idler"));
    EXPECT_EQ(core::read_file(folder_ / "a.json"), core::read_file(folder_ / "b.json"));
}

TEST_F(PartFileTest, DescribesAPartInMillimetresAndBodyFrame) {
    solid::Part part;
    part.cam.kind = cam::PartKind::kParallel;
    part.cam.rotation_sign = -1;
    part.cam.options.guide = {cam::GuideKind::kPoint, core::kPi / 2.0, 0.08, 0.0, 1, 0.0};
    cam::Contact contact;
    contact.arm.angle = 0.3;
    contact.arm.arm = 0.02;
    contact.arm.tension = 7.0;
    contact.path = {core::kPi / 2.0, 0.02, 0.003, 0.02, 0.004};  // n = (0, 1), t = (-1, 0)
    part.cam.working = {contact};
    spring::BaseSpring base;
    base.kind = spring::BaseKind::kCompression;
    base.rate = 7460.0;
    base.preload = 0.0148;
    const PartFile file = describe_part(part, base, {}, {"pnrvsa", "1a2b3c4d5e6f77", ""});
    EXPECT_EQ(file.part, "k_pe");
    EXPECT_EQ(file.spring_kind, "compression");
    EXPECT_NEAR(file.guide.position_mm[1], 80.0, 1e-12);
    ASSERT_EQ(file.target.size(), 1u);
    EXPECT_NEAR(file.target[0].arm_mm, 20.0, 1e-12);
    const std::array<double, 3> wanted{-3.0, 20.0, 4.0};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(file.target[0].contact_mm[i], wanted[i], 1e-12);
    write_part_file(folder_ / "p.json", file);
    EXPECT_EQ(read_part_file(folder_ / "p.json").spring_preload, 0.0148);
    EXPECT_NE(core::read_file(folder_ / "p.json").find("\"rate_N_per_m\""), std::string::npos);
}

struct Broken {
    const char *pattern, *replacement, *key;
};

TEST_F(PartFileTest, RefusesBrokenFilesByFileAndKey) {
    write_part_file(folder_ / "whole.json", sample("idler"));
    const std::string bytes = core::read_file(folder_ / "whole.json");
    const std::vector<Broken> cases{{R"("rotation_sign": -1,)", "", "rotation_sign: missing"},
                                    {R"("torque_sign": 1)", R"("torque_sign": 2)", "torque_sign: 2 (allowed: 1 or -1)"},
                                    {R"("kind": "idler")", R"("kind": "belt")", "guide.kind"},
                                    {R"("radius_mm": 6.0)", R"("radius_mm": "6")", "guide.radius_mm: \"6\" (allowed: a number)"},
                                    {R"("preload_rad": 4.0)", R"("preload_rad": null)", "spring.preload_rad"},
                                    {R"("angle_rad": 0.0)", R"("angle_red": 0.0)", "target[0].angle_rad: missing"},
                                    {R"("name": "k_pe.stl")", R"("name": "../k_pe.stl")", "files[0].name"},
                                    {R"("triangles": 40000)", R"("triangles": -1)", "files[0].triangles"}};
    for (const Broken& c : cases) {
        std::string text = bytes;
        const std::size_t at = text.find(c.pattern);
        ASSERT_NE(at, std::string::npos) << c.pattern;
        text.replace(at, std::string(c.pattern).size(), c.replacement);
        core::write_file(folder_ / "broken.json", text);
        fixtures::expect_refusal([&] { (void)read_part_file(folder_ / "broken.json"); }, {"broken.json", c.key});
    }
    core::write_file(folder_ / "cut.json", bytes.substr(0, bytes.size() / 2));
    fixtures::expect_refusal([&] { (void)read_part_file(folder_ / "cut.json"); }, {"cut.json"});
    fixtures::expect_refusal([&] { (void)read_part_file(folder_ / "missing.json"); }, {"missing.json"});
}

}  // namespace
}  // namespace fusee::exchange
