#include <algorithm>
#include <cmath>
#include <ostream>

#include "fusee/batch/batch.h"
#include "fusee/core/units.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "fusee/toolpath/read_back.h"
#include "pipeline/fixture.h"
#include "pipeline/soft_springs.h"

namespace fusee::pipeline {
namespace {

struct HandedHelix {
    const char* name;
    double turns;
    const char* path;
    double climb_mm;  ///< from the law's lowest load to its highest, a turn
    const char* formats;
    std::size_t readings;  ///< of K_PE's files; STL is read twice, G-code if rs274 is there
    bool pair;
};
void PrintTo(const HandedHelix& c, std::ostream* out) { *out << c.name; }

/// K_PE turns against the tension, so that psi rises with the cam's angle where torque_sign is 1 and a right-handed groove climbs with it.
class HelixOfEitherHand : public fixtures::TempFolder, public testing::WithParamInterface<HandedHelix> {
protected:
    batch::MakeResult made() const {
        const auto text = fixtures::with_keys(fixtures::soft_springs(GetParam().turns, std::string("pitch_mm = 4.0\n") + GetParam().path),
                                              {{"outputs.formats", GetParam().formats},
                                               {"outputs.pair", GetParam().pair ? "true" : "false"},
                                               {"machining.k_se", "\"wrap\""},
                                               {"machining.k_pe", "\"wrap\""},
                                               {"k_se.target_rows", "200"},
                                               {"k_pe.target_rows", "200"}});
        return batch::make(profile::read_profile(write("soft.toml", text)), {.out = folder_ / "out"});
    }
};
constexpr const char* kAll = R"(["stl", "step", "ngc"])";
INSTANTIATE_TEST_SUITE_P(Pipeline, HelixOfEitherHand,
                         testing::Values(HandedHelix{"right", 3.1, "hand = \"right\"\n", 4.0, kAll, 3, false},
                                         HandedHelix{"left", 3.1, "hand = \"left\"\n", -4.0, kAll, 3, false},
                                         HandedHelix{"left_the_other_way", 1.5, "hand = \"left\"\n[k_pe]\ntorque_sign = -1\n", 4.0,
                                                     R"(["stl"])", 2, true}),
                         [](const auto& one) { return std::string(one.param.name); });

// Law: solid, STL, STEP and G-code of a helix carry the law whichever way it climbs, and so does its mirror image.
TEST_P(HelixOfEitherHand, IsMadeAndReadBack) {
    const batch::MakeResult result = made();
    for (const core::Finding& f : result.findings) EXPECT_NE(f.severity, core::Severity::kError) << core::to_line(f);
    ASSERT_TRUE(result.made);
    const std::string formats = GetParam().formats;
    const std::size_t programs = formats.find("ngc") != std::string::npos && toolpath::can_interpret() ? 1 : 0;
    for (const std::string name : {"k_pe", "k_pe_mirrored"}) {
        if (name != "k_pe" && !GetParam().pair) continue;
        const exchange::PartFile part = exchange::read_part_file(result.folder / (name + ".json"));
        const double climb = part.target.back().contact_mm[2] - part.target.front().contact_mm[2];
        EXPECT_NEAR(climb, GetParam().climb_mm * GetParam().turns, 0.4) << "the contact wanders a little against the cam's angle";
        const auto errors = formats::read_back(result.folder, part);
        EXPECT_EQ(errors.size(), GetParam().readings + programs);
        for (const readback::ArmError& e : errors) EXPECT_TRUE(e.passed()) << e.file << " " << e.reader << " " << e.worst_relative;
    }
}

}  // namespace
}  // namespace fusee::pipeline
