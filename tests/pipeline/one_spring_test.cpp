#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/simulate.h"
#include "pipeline/fixture.h"
#include "second_reader.h"

// The shipped profiles of one spring as a user makes them.
namespace fusee::pipeline {
namespace {

constexpr double kAllowed = 1e-3;  // of the largest torque: the arm error that a file may have

class OneSpring : public fixtures::TempFolder {
protected:
    /// The shipped profile with STL files only.
    profile::Profile shipped(const std::string& name, const std::map<std::string, std::string>& changes = {}) const {
        fs::copy_file(fixtures::shipped("single/exo_ankle").replace_extension(".csv"), folder_ / "exo_ankle.csv",
                      fs::copy_options::overwrite_existing);
        std::string text = fixtures::with_key(core::read_file(fixtures::shipped("single/" + name)), "outputs.formats", R"(["stl"])");
        for (const auto& [key, value] : changes) text = fixtures::with_key(text, key, value);
        return profile::read_profile(write(name + ".toml", text));
    }

    /// Makes it and compares the torque that a second reader finds from the STL file and the spring with the wanted one, sign included.
    /// @param torque over the angle from the first one [rad], up to `last` @param pulley_radius of a spool [m]
    void expect_torque(const std::string& name, double last, const std::function<double(double)>& torque, double pulley_radius = 0.0) {
        const batch::MakeResult result = batch::make(shipped(name), {.out = folder_ / "out"});
        for (const core::Finding& f : result.findings) EXPECT_FALSE(core::is_broken(f)) << core::to_line(f);
        ASSERT_TRUE(result.made);
        for (const char* file : {"cam.stl", "cam.json", "law.csv", "report.html"}) EXPECT_TRUE(fs::exists(result.folder / file)) << file;
        for (const char* file : {"simulation.json", "k_pe.stl", "cam_mirrored.stl"}) EXPECT_FALSE(fs::exists(result.folder / file)) << file;
        const Found found = pulley_radius > 0.0 ? spool(result.folder, last, pulley_radius) : cam(result.folder, last);
        ASSERT_GT(found.size(), 100U);
        EXPECT_NEAR(found.back().first, last, 0.01 * last) << "the whole range";
        double largest = 0.0, worst = 0.0;
        for (const auto& [angle, found_torque] : found) {
            largest = std::max(largest, std::abs(torque(angle)));
            worst = std::max(worst, std::abs(found_torque - torque(angle)));
        }
        RecordProperty("worst_relative", std::to_string(worst / largest));
        EXPECT_LT(worst, kAllowed * largest);
    }

private:
    using Found = std::vector<std::pair<double, double>>;  ///< angle [rad], torque [Nm]
    static constexpr double kBore = 8.0;                   ///< [mm]

    /// A part that turns with the angle and moves a compression spring: by a cable, or by a roller on a slide.
    static Found cam(const fs::path& folder, double last) {
        constexpr int kSteps = 800, kShown = 8;
        constexpr double kHalf = 0.2;  // [rad]
        const nlohmann::json part = nlohmann::json::parse(core::read_file(folder / "cam.json"));
        const std::string stl = core::read_file(folder / "cam.stl");
        const bool rolls = part["guide"]["kind"] == "roller";
        const std::vector<second_reader::Point> points = rolls ? second_reader::rim_of(stl, kBore) : second_reader::floor_of(stl);
        const double rate = part["spring"]["rate_N_per_m"], preload = part["spring"]["preload_m"];
        std::vector<double> angles, energies;
        double moved = 0.0, before = 0.0;  // [m]
        Found found;
        for (int i = 0; i <= kSteps; ++i) {
            const double angle = last * i / kSteps;
            if (rolls) {
                moved = 1e-3 * second_reader::lift(points, part, angle);
                angles.push_back(angle);
                energies.push_back(0.5 * rate * (preload + moved) * (preload + moved));
            } else {
                const double arm = 1e-3 * second_reader::cable_arm(points, part, angle);
                if (i > 0) moved += 0.5 * (arm + before) * last / kSteps;
                before = arm;
                found.emplace_back(angle, rate * (preload + moved) * arm);
            }
        }
        for (std::size_t i = 0; i < angles.size(); i += kShown)
            found.emplace_back(angles[i], second_reader::slope_at(angles, energies, angles[i], kHalf));
        return found;
    }
    /// A spool on a torsion spring, whose cable turns a pulley.
    static Found spool(const fs::path& folder, double last, double pulley_radius) {
        constexpr double kStep = 0.004;  // of the spool [rad]
        const nlohmann::json part = nlohmann::json::parse(core::read_file(folder / "cam.json"));
        const std::vector<second_reader::Point> floor = second_reader::floor_of(core::read_file(folder / "cam.stl"));
        double paid = 0.0, before = 0.0;  // [m]
        Found found;
        for (double turn = 0.0; paid / pulley_radius < last; turn += kStep) {
            const double arm = 1e-3 * second_reader::cable_arm(floor, part, turn);
            if (turn > 0.0) paid += 0.5 * kStep * (arm + before);
            before = arm;
            const double load = part["spring"]["rate_Nm_per_rad"].get<double>() * (part["spring"]["preload_rad"].get<double>() + turn);
            if (paid / pulley_radius <= last) found.emplace_back(paid / pulley_radius, pulley_radius * load / arm);
        }
        return found;
    }
};

TEST_F(OneSpring, BalancesALinkOverItsUprightPosition) {
    constexpr double kFirst = core::rad_from_deg(-30.0);
    expect_torque("gravity_balance", core::rad_from_deg(150.0), [](double x) { return 0.5 * 9.80665 * 0.2 * std::sin(kFirst + x); });
}

TEST_F(OneSpring, HardensToBothSidesOfZero) {
    constexpr double kFirst = core::rad_from_deg(-35.0);
    expect_torque("hardening", core::rad_from_deg(70.0), [](double x) { return 0.8 * (kFirst + x) + 5.0 * std::pow(kFirst + x, 3); });
}

TEST_F(OneSpring, HasACubicStiffnessOverAZero) {
    constexpr double kFirst = core::rad_from_deg(-15.0);
    const auto integral = [](double x) { return 3.0 * x + x * x + 20.0 / 3.0 * std::pow(x, 3) + 7.5 * std::pow(x, 4); };
    expect_torque("cubic_stiffness", core::rad_from_deg(40.0), [&](double x) { return -0.8013 + integral(kFirst + x) - integral(kFirst); });
}

/// The recipe by which such modules are drawn, in steps of a quarter degree: stiffness to torque to lift by trapezoids, the lift around
/// the axis, and its offset by the roller along normals by differences.
TEST_F(OneSpring, HasTheContourOfAPeersRecipe) {
    constexpr int kSteps = 160;
    constexpr double kFirst = core::rad_from_deg(-15.0), kStep = core::rad_from_deg(0.25), kRate = 10.7, kPreload = 20.0, kRim = 51.0,
                     kRoller = 6.5;  // [N/mm], [mm]
    const batch::MakeResult result = batch::make(shipped("cubic_stiffness"), {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    const nlohmann::json part = nlohmann::json::parse(core::read_file(result.folder / "cam.json"));
    const std::vector<second_reader::Point> rim = second_reader::rim_of(core::read_file(result.folder / "cam.stl"), 8.0);

    std::vector<second_reader::Point> centres;
    double torque = -801.3, energy = 0.5 * kRate * kPreload * kPreload;  // [Nmm], [mJ]
    const auto stiffness = [](double x) { return 1e3 * (3.0 + 2.0 * x + 20.0 * x * x + 30.0 * x * x * x); };
    for (int i = 0; i <= kSteps; ++i) {
        const double before = torque, x = kFirst + i * kStep, turned = -part["rotation_sign"].get<int>() * i * kStep;
        if (i > 0) torque += 0.5 * kStep * (stiffness(x) + stiffness(x - kStep)), energy += 0.5 * kStep * (torque + before);
        const double away = kRim + kRoller + std::sqrt(2.0 * energy / kRate) - kPreload;
        centres.push_back({-away * std::sin(turned), away * std::cos(turned)});
    }
    double worst = 0.0;
    for (std::size_t i = 1; i + 1 < centres.size(); ++i) {
        const double dx = centres[i + 1][0] - centres[i - 1][0], dy = centres[i + 1][1] - centres[i - 1][1], length = std::hypot(dx, dy);
        const double inwards = centres[i][0] * dy - centres[i][1] * dx > 0.0 ? -1.0 : 1.0;
        const double x = centres[i][0] + inwards * kRoller * dy / length, y = centres[i][1] - inwards * kRoller * dx / length;
        double nearest = 1e9;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const auto &a = rim[k], &b = rim[(k + 1) % rim.size()];
            const double bx = b[0] - a[0], by = b[1] - a[1];
            const double t = std::clamp(((x - a[0]) * bx + (y - a[1]) * by) / (bx * bx + by * by), 0.0, 1.0);
            nearest = std::min(nearest, std::hypot(x - a[0] - t * bx, y - a[1] - t * by));
        }
        worst = std::max(worst, nearest);
    }
    RecordProperty("worst_mm", std::to_string(worst));
    EXPECT_LT(worst, 0.005) << "mm: mesh and steps of a quarter degree";
}

TEST_F(OneSpring, PullsAPulleyWithAConstantTorque) {
    expect_torque(
        "constant_torque", core::rad_from_deg(200.0), [](double) { return 0.15; }, 0.03);
}

TEST_F(OneSpring, FollowsATableOfDegreesAndNewtonMetres) {
    expect_torque("exo_ankle", core::rad_from_deg(30.0), [](double x) { return 0.8 + 0.5 * x + 3.2 * x * x; });
}

TEST_F(OneSpring, SaysWhichFamilyFollowsATorqueOfBothSigns) {
    std::string text = core::read_file(fixtures::shipped("single/exo_ankle"));
    const std::size_t table = text.find("kind = \"table\""), end = text.find("[cable]");
    text.replace(table, end - table, "kind = \"formula\"\nformula_Nm = \"2*x\"\nfrom_deg = -20.0\nto_deg = 20.0\n\n");
    const Evaluation seen = evaluate(profile::read_profile(write("both.toml", text)), Depth::kOutline);
    ASSERT_EQ(seen.parts.size(), 1U);
    const core::Finding& f = seen.parts.front().findings.front();
    EXPECT_EQ(f.rule, "cam.arm");
    EXPECT_NE(f.what.find("cannot push"), std::string::npos) << f.what;
    EXPECT_NE(f.suggestion.text().find("cam.family = \"roller\""), std::string::npos) << f.suggestion.text();
    for (const auto& [key, value] : {std::pair{"2*x", "1e-16+2*x"}, {"-20.0", "0.0"}})
        text.replace(text.find(key), std::strlen(key), value);
    const Evaluation from_0 = evaluate(profile::read_profile(write("none.toml", text)), Depth::kOutline);
    EXPECT_NE(from_0.parts.front().findings.front().what.find("cannot push"), std::string::npos) << "a 0 of a formula is seldom exact";
}

TEST_F(OneSpring, AsksForThePreloadThatTheLawTakesOut) {
    const Evaluation seen = evaluate(shipped("gravity_balance", {{"cam.spring.preload_mm", "2"}}), Depth::kOutline);
    ASSERT_EQ(seen.findings.size(), 1U);
    const core::Finding& f = seen.findings.front();
    EXPECT_EQ(f.rule, "law.energy");
    EXPECT_NEAR(f.measured, 0.5 * 7460.0 * 4e-6 * 1e3, 1e-9);                                     // [mJ]
    EXPECT_NEAR(f.allowed, 0.5 * 9.80665 * 0.2 * (1.0 - std::cos(core::kPi / 6.0)) * 1e3, 1e-3);  // from -30 deg up to 0
    EXPECT_TRUE(f.suggestion.text().starts_with("cam.spring.preload_mm = ")) << f.suggestion.text();
}

// A step of 0.4 Nm is rounded to a slope: no row beside it is within half of the step. Noise of 0.01 Nm on 2,001 rows is no such thing.
TEST_F(OneSpring, WarnsWhereTheSmoothedTorqueLeavesItsRows) {
    const auto judged = [&](const char* name, const std::function<double(int)>& torque) {
        std::string rows = "angle_deg,torque_Nm\n";
        for (int i = 0; i <= 2000; ++i) rows += fmt::format("{},{}\n", 0.02 * i, torque(i));
        (void)write("rows.csv", rows);
        std::string text = core::read_file(fixtures::shipped("single/exo_ankle"));
        const std::size_t at = text.find("exo_ankle.csv");
        text.replace(at, std::string("exo_ankle.csv").size(), "rows.csv");
        const core::Findings all = evaluate(profile::read_profile(write(name, text)), Depth::kLaw).findings;
        return *std::find_if(all.begin(), all.end(), [](const core::Finding& f) { return f.rule == "law.rows"; });
    };
    const core::Finding step = judged("step.toml", [](int i) { return i < 1000 ? 0.2 : 0.6; });
    EXPECT_EQ(step.severity, core::Severity::kWarning);
    EXPECT_NEAR(step.measured, 0.2, 0.05);
    EXPECT_TRUE(step.where == "law at 19.98 deg" || step.where == "law at 20 deg") << step.where;  // the rows beside the step
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, 0.01);
    EXPECT_EQ(judged("noisy.toml", [&](int i) { return 0.8 + 1e-4 * i + normal(random); }).severity, core::Severity::kPass);
}

TEST_F(OneSpring, RefusesACableThatWouldPush) {
    const Evaluation seen = evaluate(shipped("constant_torque", {{"law.torque_Nm", "-0.15"}}), Depth::kOutline);
    EXPECT_TRUE(seen.findings.empty());
    ASSERT_EQ(seen.parts.size(), 1U);
    EXPECT_NE(seen.parts.front().findings.front().what.find("cannot push"), std::string::npos);
}

TEST_F(OneSpring, IsNoJoint) {
    try {
        (void)simulate(shipped("hardening"));
        FAIL() << "a single spring was simulated as a joint";
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "kind");
        EXPECT_NE(std::string(e.allowed()).find("\"joint\""), std::string::npos) << e.allowed();
    }
}

/// Rules speak of the table that the profile has.
TEST_F(OneSpring, IsJudgedInItsOwnWords) {
    for (const EvaluatedPart& part : evaluate(shipped("constant_torque", {{"cam.hub.bore_mm", "60"}}), Depth::kOutline).parts) {
        EXPECT_TRUE(core::any_error(part.findings));
        for (const core::Finding& f : part.findings) {
            const std::string line = core::to_line(f);
            for (const char* word : {"k_se", "k_pe", "end_torque_Nm"}) EXPECT_EQ(line.find(word), std::string::npos) << line;
        }
    }
}

}  // namespace
}  // namespace fusee::pipeline
