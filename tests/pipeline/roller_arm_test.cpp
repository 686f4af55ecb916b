#include <algorithm>
#include <cmath>
#include <vector>

#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/make.h"
#include "pipeline/fixture.h"
#include "second_reader.h"

// A second reader of a cam with a roller on an arm: the torque from the bytes of the STL file, the lengths of cam.json and the spring. It
// shares no code with the program: it slices the mesh, pushes the arm with it, and derives the spring's energy.
namespace fusee::pipeline {
namespace {

constexpr double kGravity = 0.5 * 9.80665 * 0.2;  // m g l [Nm]

using second_reader::Point, second_reader::rim_of, second_reader::slope_at, second_reader::swing;

class RollerArmReader : public fixtures::TempFolder {};

TEST_F(RollerArmReader, FindsTheTorqueOfGravityInTheStl) {
    constexpr double kFirst = -M_PI / 6.0, kRange = 5.0 * M_PI / 6.0, kHalf = 0.3;
    const std::string text = fixtures::with_key(core::read_file(fixtures::shipped("single/gravity_arm")), "outputs.formats", R"(["stl"])");
    core::OutputFolder out(folder_ / "out", {.command = "gravity_arm", .source = "gravity_arm.toml"});
    const auto made = make_parts(profile::read_profile(write("gravity_arm.toml", text)), out);
    ASSERT_TRUE(made) << core::to_line(made.refusal().front());
    for (const core::Finding& f : made->report.all_findings()) EXPECT_FALSE(core::is_broken(f)) << core::to_line(f);
    const nlohmann::json part = nlohmann::json::parse(core::read_file(out.path() / "cam.json"));
    ASSERT_EQ(part["guide"]["kind"], "arm");
    const std::vector<Point> rim = rim_of(core::read_file(out.path() / "cam.stl"), 15.0);
    ASSERT_GT(rim.size(), 200U);

    // The triangle of the pivot and the spring's two pins has a right angle at the arm's pin at cam angle 0.
    const double lever = part["guide"]["lever_mm"], spring = part["guide"]["spring_mm"];
    const double rate = part["spring"]["rate_N_per_m"], preload = part["spring"]["preload_m"];
    std::vector<double> angle, energy;
    for (double a = 0.0; a <= kRange + 1e-9; a += kRange / 1500.0) {
        const double turned = swing(rim, part, a);
        const Point pin{lever * std::cos(turned), lever * std::sin(turned)};
        const double compressed = preload + 1e-3 * (spring - std::hypot(lever - pin[0], spring - pin[1]));
        angle.push_back(a);
        energy.push_back(0.5 * rate * compressed * compressed);
    }
    double worst = 0.0, least = 0.0;
    for (std::size_t i = 0; i < angle.size(); i += 5) {
        const double found = slope_at(angle, energy, angle[i], kHalf), wanted = kGravity * std::sin(kFirst + angle[i]);
        worst = std::max(worst, std::abs(found - wanted));
        least = std::min(least, found);
    }
    EXPECT_LT(worst, 1e-3 * kGravity);
    EXPECT_NEAR(least, kGravity * std::sin(kFirst), 1e-3 * kGravity) << "it changes its sign within the range";
    RecordProperty("worst_relative", std::to_string(worst / kGravity));
}

// The spring is compressed most in the middle of the range, where the pins of a short lever cannot come so near: it has to give 9.293 mm by
// the energy m g l of a quarter turn, and 60 + 10 - hypot(60, 10) mm is all that the linkage gives.
TEST_F(RollerArmReader, AnArmThatIsStuckInTheMiddleOfTheRangeIsRefusedForThat) {
    std::string text = core::read_file(fixtures::shipped("single/gravity_arm"));
    for (const auto& [key, value] : {std::pair{"law.from_deg", "90.0"}, {"law.to_deg", "270.0"}, {"cam.roller.lever_mm", "10.0"}})
        text = fixtures::with_key(text, key, value);
    const Evaluation seen = evaluate(profile::read_profile(write("short.toml", text)), Depth::kOutline);
    const core::Findings all = seen.all();
    const auto stuck = std::find_if(all.begin(), all.end(), [](const core::Finding& f) { return f.rule == "cam.guide"; });
    ASSERT_NE(stuck, all.end());
    EXPECT_NEAR(stuck->measured, 70.0 - std::hypot(60.0, 10.0) - 9.2926, 1e-3) << core::to_line(*stuck);
    ASSERT_FALSE(stuck->suggestion.changes().empty()) << core::to_line(*stuck);
    const core::Change change = stuck->suggestion.changes().front().front();
    EXPECT_EQ(change.key, "cam.roller.lever_mm");
    text = fixtures::with_key(text, "cam.roller.lever_mm", change.value);
    EXPECT_TRUE(evaluate(profile::read_profile(write("longer.toml", text)), Depth::kCam).parts.front().cam.has_value());
}

}  // namespace
}  // namespace fusee::pipeline
