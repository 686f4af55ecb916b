#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/make.h"
#include "pipeline/fixture.h"

// A second reader of a cam with a roller on an arm: the torque from the bytes of the STL file, the lengths of cam.json and the spring. It
// shares no code with the program: it slices the mesh, pushes the arm with it, and derives the spring's energy.
namespace fusee::pipeline {
namespace {

constexpr double kGravity = 0.5 * 9.80665 * 0.2;  // m g l [Nm]

using Vec = std::array<double, 2>;

/// Corners of the mesh half-way up, the bore left out [mm]: they lie on the rim.
std::vector<Vec> corners_of(const std::string& stl, double bore) {
    constexpr double kHalfWay = 1e-4;
    std::uint32_t count = 0;
    std::memcpy(&count, stl.data() + 80, sizeof count);
    std::set<std::pair<double, Vec>> corners;  // by azimuth
    for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(count); ++i) {
        std::array<float, 3> p{};
        std::memcpy(p.data(), stl.data() + 84 + 50 * (i / 3) + 12 + 12 * (i % 3), sizeof p);
        const Vec at{p[0], p[1]};
        if (std::abs(p[2]) < kHalfWay && std::hypot(at[0], at[1]) > bore) corners.insert({std::atan2(at[1], at[0]), at});
    }
    std::vector<Vec> all;
    for (const auto& corner : corners) all.push_back(corner.second);
    return all;
}

/// How far the rim turns the arm from its place at cam angle 0 [rad].
double swing(const std::vector<Vec>& rim, const nlohmann::json& part, double cam_angle) {
    const nlohmann::json& guide = part["guide"];
    const double turned = part["rotation_sign"].get<int>() * cam_angle, c = std::cos(turned), s = std::sin(turned);
    const double arm = guide["arm_mm"], roller = guide["radius_mm"], sense = guide["sense"];
    const double start = std::atan2(guide["direction"][1].get<double>(), guide["direction"][0].get<double>());
    std::vector<double> places;
    for (const Vec& p : rim) {
        const double x = c * p[0] - s * p[1] - guide["position_mm"][0].get<double>(),
                     y = s * p[0] + c * p[1] - guide["position_mm"][1].get<double>(), away = std::hypot(x, y);
        const double cosine = (arm * arm + away * away - roller * roller) / (2.0 * arm * away);
        places.push_back(std::abs(cosine) > 1.0 ? -9.0 : sense * std::remainder(std::atan2(y, x) - start, 2.0 * M_PI) + std::acos(cosine));
    }
    const auto i = static_cast<std::size_t>(std::max_element(places.begin(), places.end()) - places.begin()), n = places.size();
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    if (places[before] < -8.0 || places[after] < -8.0) return places[i];
    // Top of the parabola through the three places, by their distances along the rim.
    const auto apart = [&](std::size_t k) { return std::hypot(rim[k][0] - rim[i][0], rim[k][1] - rim[i][1]); };
    const double left = (places[i] - places[before]) / apart(before), right = (places[after] - places[i]) / apart(after);
    const double bend = (right - left) / (apart(before) + apart(after)), slope = left + bend * apart(before);
    return bend < 0.0 ? places[i] - slope * slope / (4.0 * bend) : places[i];
}

/// Slope at x of the cubic that is nearest to the values within `half` of it.
double slope_at(const std::vector<double>& x, const std::vector<double>& y, double at, double half) {
    std::array<std::array<double, 5>, 4> m{};  // normal equations
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = (x[i] - at) / half;
        if (std::abs(u) > 1.0) continue;
        for (std::size_t r = 0; r < 4; ++r) {
            for (std::size_t k = 0; k < 4; ++k) m[r][k] += std::pow(u, r + k);
            m[r][4] += std::pow(u, r) * y[i];
        }
    }
    for (std::size_t p = 0; p < 4; ++p)
        for (std::size_t r = 0; r < 4; ++r) {
            if (r == p) continue;
            const double factor = m[r][p] / m[p][p];
            for (std::size_t k = p; k < 5; ++k) m[r][k] -= factor * m[p][k];
        }
    return m[1][4] / m[1][1] / half;
}

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
    const std::vector<Vec> rim = corners_of(core::read_file(out.path() / "cam.stl"), 15.0);
    ASSERT_GT(rim.size(), 200U);

    // The triangle of the pivot and the spring's two pins has a right angle at the arm's pin at cam angle 0.
    const double lever = part["guide"]["lever_mm"], spring = part["guide"]["spring_mm"];
    const double rate = part["spring"]["rate_N_per_m"], preload = part["spring"]["preload_m"];
    std::vector<double> angle, energy;
    for (double a = 0.0; a <= kRange + 1e-9; a += kRange / 1500.0) {
        const double turned = swing(rim, part, a);
        const Vec pin{lever * std::cos(turned), lever * std::sin(turned)};
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
