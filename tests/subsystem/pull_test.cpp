#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "fusee/core/file.h"
#include "gap_case/fixture.h"
#include "refused.h"
#include "subsystem/fixture.h"

namespace fs = std::filesystem;

namespace fusee::subsystem {
namespace {

using diagnosis::VerdictKind;
using fixtures::names_of;
using fixtures::says;

constexpr double kRate = 145.4;  // Nm/rad

/// What one pull of a joint does: torque over angle, in the files' sign `torque_sign` and `angle_sign`.
struct Twin {
    std::function<double(double)> law = [](double q) { return kRate * q; };
    double scale = 0.0, series = 0.0, preload = 0.0, hysteresis = 0.0, coulomb = 0.0, zero = 0.1;
    double angle_sign = 1.0, torque_sign = 1.0, torque_unit = 1.0, angle_unit = 1.0;
};

std::vector<double> one_way(double from, double to, int rows) {
    std::vector<double> q;
    for (int i = 0; i < rows; ++i) q.push_back(from + (to - from) * i / (rows - 1));
    return q;
}

std::vector<double> loops(double amplitude, int rows) {
    std::vector<double> q;
    for (int i = 0; i < rows; ++i) q.push_back(amplitude * std::sin(4.0 * 3.14159265358979 * i / rows));
    return q;
}

double hardening(double q) { return 30.0 * q + 3.0 * std::sinh(16.0 * q); }

Record pull_of(const Twin& twin, const std::vector<double>& angles, const std::string& name, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 0.05);
    Record record{"pull", "pull_" + name + ".csv", {}, {}, {}, {}, {"law_" + name + ".csv", {}, {}}};
    for (int i = -40; i <= 40; ++i) {
        const double q = 0.005 * i * twin.angle_sign;
        record.law.q_rad.push_back(0.005 * i);
        record.law.torque_Nm.push_back(twin.torque_sign * twin.law(q));
    }
    double before = angles.front(), turn = 0.0, t = 0.0;
    for (const double q : angles) {
        double torque = 0.0;
        for (int k = 0; k < 60; ++k) torque = 0.5 * (torque + (1.0 + twin.scale) * twin.law(q - twin.series * torque + twin.preload));
        turn = std::clamp(turn + (q - before) / 0.001, -1.0, 1.0);
        before = q;
        record.columns["t_s"].push_back(t += 0.05);
        record.columns["q_rad"].push_back(twin.angle_sign * twin.angle_unit * q);
        record.columns["torque_Nm"].push_back(
            twin.torque_sign * twin.torque_unit *
            (torque + (twin.coulomb + twin.hysteresis * std::abs(torque)) * turn + twin.zero + noise(random)));
    }
    return record;
}

Case case_of(std::vector<Record> records) {
    Case subsystem_case;
    subsystem_case.kind = Kind::kCamJoint;
    subsystem_case.name = "pull";
    subsystem_case.sensors["torque_noise_Nm"] = 0.05;
    subsystem_case.records = std::move(records);
    return subsystem_case;
}

diagnosis::Diagnosis diagnosed(const Case& subsystem_case) { return diagnose(subsystem_case, {.jobs = 1, .progress = {}}); }

/// Every set of the answer and its alternatives, "a+b", "" for no effect.
std::vector<std::string> sets_of(const diagnosis::Diagnosis& d) {
    std::vector<std::string> sets;
    for (const diagnosis::Hypothesis& h : d.ranking) {
        std::string name;
        for (const effects::Cause& cause : h.effects) name += (name.empty() ? "" : "+") + cause.id;
        if (h.probability >= 0.01) sets.push_back(name);
    }
    return sets;
}

bool holds(const std::vector<std::string>& sets, const std::string& set) { return std::find(sets.begin(), sets.end(), set) != sets.end(); }

/// No friction is named where the joint was turned in one direction.
void expect_no_friction(const diagnosis::Diagnosis& d) {
    for (const std::string& set : sets_of(d)) {
        EXPECT_EQ(set.find("law.hysteresis"), std::string::npos) << set;
        EXPECT_EQ(set.find("law.coulomb"), std::string::npos) << set;
    }
    EXPECT_TRUE(says(d, "law.hysteresis cannot be seen here: no file turns back"));
    EXPECT_NE(d.next_experiment.find("turns back"), std::string::npos);
}

// Known: a stiffer spring through its rest, one way: no set of preload, hysteresis and a zero of 12 Nm.
TEST(OneWayPull, NamesAnotherRate) {
    const diagnosis::Diagnosis d = diagnosed(case_of({pull_of({.scale = 0.1}, one_way(-0.09, 0.09, 18), "a", 1)}));
    EXPECT_EQ(names_of(d), "law.scale");
    EXPECT_EQ(d.verdict, VerdictKind::kIdentified);
    EXPECT_NEAR(d.effects.at(0).parameter.value, 0.1, 0.01);
    EXPECT_NEAR(d.build.at(0).second.value, 0.1, 0.1);
    expect_no_friction(d);
}

// A straight law that is softer, and one with a compliance in series, are the same line.
TEST(OneWayPull, LeavesRateAndComplianceOfAStraightLawOpen) {
    for (const Twin& twin : {Twin{.scale = -0.05}, Twin{.series = 4e-4}}) {
        const diagnosis::Diagnosis d = diagnosed(case_of({pull_of(twin, one_way(0.0, 0.15, 16), "a", 2)}));
        EXPECT_EQ(d.verdict, VerdictKind::kAmbiguous);
        EXPECT_TRUE(holds(sets_of(d), "law.scale"));
        EXPECT_TRUE(holds(sets_of(d), "law.series"));
        EXPECT_TRUE(says(d, "equal in these rows"));
        EXPECT_NE(d.next_experiment.find("the cam's own angle under torque"), std::string::npos) << d.next_experiment;
        expect_no_friction(d);
    }
}

// A straight law at another angle, and a sensor's zero, are the same line: a large offset is no zero without a word.
TEST(Pull, LeavesPreloadAndALargeZeroOpen) {
    for (const std::vector<double>& angles : {one_way(-0.09, 0.09, 40), loops(0.09, 200), one_way(0.08, 0.12, 30)}) {
        const diagnosis::Diagnosis d = diagnosed(case_of({pull_of({.preload = 0.02}, angles, "a", 3)}));
        EXPECT_EQ(d.verdict, VerdictKind::kAmbiguous);
        EXPECT_TRUE(holds(sets_of(d), "law.preload"));
        EXPECT_TRUE(holds(sets_of(d), ""));
        EXPECT_NE(d.next_experiment.find("with the drive uncoupled"), std::string::npos) << d.next_experiment;
    }
    const diagnosis::Diagnosis small = diagnosed(case_of({pull_of({.zero = 0.4}, loops(0.09, 200), "a", 4)}));
    EXPECT_EQ(small.verdict, VerdictKind::kNone);
    EXPECT_NEAR(small.build.at(0).second.value, 0.4, 0.05);
}

// A law that is not straight tells zero and preload apart: a large zero is told then.
TEST(Pull, SaysThatAZeroIsNotPlausible) {
    const diagnosis::Diagnosis d = diagnosed(case_of({pull_of({.law = hardening, .zero = 4.0}, loops(0.14, 300), "a", 5)}));
    EXPECT_EQ(d.verdict, VerdictKind::kNone);
    EXPECT_TRUE(says(d, "not plausible: no effect, with sensor.torque_offset pull_a.csv at "));
}

struct Flip {
    double angle, torque;
};

// Law: the joint does not change with the sign convention of its files.
TEST(Pull, IsTheSameWithAnySigns) {
    const Twin twins[] = {{.law = hardening, .series = 5e-4}, {.scale = 0.1, .coulomb = 0.5}, {.law = hardening, .preload = 0.01}};
    for (const Twin& twin : twins) {
        const auto flipped = [&](Flip flip) {
            Twin other = twin;
            other.angle_sign = flip.angle;
            other.torque_sign = flip.torque;
            return diagnosed(case_of({pull_of(other, loops(0.12, 240), "a", 6)}));
        };
        const diagnosis::Diagnosis one = flipped({1.0, 1.0});
        EXPECT_EQ(one.verdict, VerdictKind::kIdentified) << names_of(one);
        for (const Flip flip : {Flip{1.0, -1.0}, Flip{-1.0, 1.0}, Flip{-1.0, -1.0}}) {
            SCOPED_TRACE(names_of(one) + (flip.angle < 0.0 ? ", angle" : "") + (flip.torque < 0.0 ? ", torque" : ""));
            const diagnosis::Diagnosis d = flipped(flip);
            EXPECT_EQ(d.verdict, one.verdict);
            ASSERT_EQ(names_of(d), names_of(one));
            for (std::size_t e = 0; e < d.effects.size(); ++e) {
                const bool turns = d.effects[e].cause.id == "law.preload" && flip.angle < 0.0;
                EXPECT_NEAR(d.effects[e].parameter.value, (turns ? -1.0 : 1.0) * one.effects[e].parameter.value,
                            1e-3 * std::abs(one.effects[e].parameter.value));
            }
            EXPECT_NEAR(d.build.at(0).second.value, flip.torque * one.build.at(0).second.value, 1e-3);
            EXPECT_NEAR(d.gap.heldout_after, one.gap.heldout_after, 1e-3);
        }
    }
}

double error_of(const Case& predicted, const Case& measured) {
    double squares = 0.0;
    const auto &a = predicted.records[0].columns.at("torque_Nm"), &b = measured.records[0].columns.at("torque_Nm");
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(a[i] - b[i], 2) / static_cast<double>(a.size());
    return std::sqrt(squares);
}

// What a case was found to have predicts another pull, with the signs of the case.
TEST(Pull, PredictsWithAnySigns) {
    for (const Flip flip : {Flip{1.0, 1.0}, Flip{1.0, -1.0}, Flip{-1.0, 1.0}, Flip{-1.0, -1.0}}) {
        const Twin twin{.law = hardening, .series = 5e-4, .coulomb = 0.5, .angle_sign = flip.angle, .torque_sign = flip.torque};
        const Case known = case_of({pull_of(twin, loops(0.12, 240), "a", 6)}), other = case_of({pull_of(twin, loops(0.09, 100), "b", 7)});
        const diagnosis::Diagnosis found = diagnosed(known);
        EXPECT_EQ(names_of(found), "law.coulomb, law.series");
        EXPECT_LT(error_of(predict(known, found, other), other), 0.08) << flip.angle << flip.torque;
        EXPECT_GT(error_of(predict(known, {}, other), other), 0.3);
    }
}

TEST(Pull, IsTheSameInAnyOrderOfFiles) {
    const Record a = pull_of({.scale = 0.1}, loops(0.09, 120), "a", 7),
                 b = pull_of({.scale = 0.1, .zero = -0.2}, one_way(-0.1, 0.1, 40), "b", 8),
                 c = pull_of({.law = hardening, .scale = 0.1}, loops(0.14, 120), "c", 9);
    const diagnosis::Diagnosis one = diagnosed(case_of({a, b, c})), other = diagnosed(case_of({c, a, b}));
    EXPECT_EQ(names_of(one), "law.scale");
    EXPECT_EQ(one.verdict, other.verdict);
    ASSERT_EQ(names_of(other), names_of(one));
    EXPECT_NEAR(one.effects.at(0).parameter.value, other.effects.at(0).parameter.value, 1e-6);
}

// Friction that one-way files cannot show makes no other effect sure.
TEST(OneWayPull, SaysWhatAnUnseenHysteresisWouldExplain) {
    const diagnosis::Diagnosis d = diagnosed(case_of({pull_of({.hysteresis = 0.06}, one_way(-0.14, 0.14, 60), "a", 11)}));
    EXPECT_NE(d.verdict, VerdictKind::kIdentified) << names_of(d);
    EXPECT_TRUE(says(d, "law.hysteresis would explain the rows better than"));
    expect_no_friction(d);
}

/// The question with which a case is refused; "" if it is not.
std::string question_of(const Twin& twin, const std::vector<double>& angles) {
    try {
        (void)diagnosed(case_of({pull_of(twin, angles, "a", 10)}));
        return "";
    } catch (const core::InvalidInput& e) {
        return e.field() + ": " + e.allowed();
    }
}

TEST(Pull, AsksForUnitsAndSigns) {
    const std::vector<double> angles = loops(0.09, 100);
    const auto asks = [&](const Twin& twin, const std::string& question, const std::vector<double>& q) {
        const std::string asked = question_of(twin, q);
        EXPECT_NE(asked.find(question), std::string::npos) << asked;
    };
    asks({.torque_unit = 1000.0}, "torque_Nm: torque and angle in the units and with the signs of the law; are these mNm or Nmm?", angles);
    asks({.law = hardening, .torque_unit = 1000.0}, "are these mNm or Nmm?", angles);
    asks({.torque_unit = 1e-3}, "is torque_Nm of the law in mNm or Nmm?", angles);
    asks({.torque_unit = -1.0}, "is the sign of torque_Nm, or of q_rad, that of the law?", angles);
    asks({.torque_unit = -1000.0}, "are these mNm or Nmm? is the sign of torque_Nm", angles);
    asks({.angle_unit = 57.29578}, "are these degrees?", angles);
    asks({.law = hardening, .angle_unit = -1.0}, "is the sign of torque_Nm, or of q_rad, that of the law?", angles);
    EXPECT_EQ(question_of({.scale = -0.6}, angles), "");
    EXPECT_EQ(question_of({.law = [](double) { return 0.001; }, .zero = 0.0}, angles), "") << "no torque follows nothing";
}

/// The table's cases of the kind that README.md beside them states.
class SharedCase : public testing::Test {
protected:
    [[nodiscard]] static diagnosis::Diagnosis of(const char* name) { return diagnosed(read_case(folder() / name)); }
    void SetUp() override {
        if (!fs::exists(folder())) GTEST_SKIP() << folder() << " does not exist";
    }
    static fs::path folder() { return fs::path(FUSEE_SOURCE_DIR) / "../shared/cases"; }
};

TEST_F(SharedCase, OneWayPulls) {
    for (const char* name : {"pull_one_way/asym1_up18", "pull_one_way/lin_loop_scale"}) {
        const diagnosis::Diagnosis d = of(name);
        EXPECT_EQ(names_of(d), "law.scale") << name;
        EXPECT_EQ(d.verdict, VerdictKind::kIdentified) << name;
        EXPECT_NEAR(d.effects.at(0).parameter.value, 0.1, 0.01) << name;
    }
    const diagnosis::Diagnosis soft = of("pull_one_way/one_lin_soft5");
    EXPECT_EQ(soft.verdict, VerdictKind::kAmbiguous);
    EXPECT_TRUE(holds(sets_of(soft), "law.scale"));
    EXPECT_NEAR(soft.build.at(0).second.value, 0.0, 0.5);
    expect_no_friction(soft);
}

TEST_F(SharedCase, SignsOfTheLaw) {
    for (const char* name : {"law_sign/pos_series_sinh", "law_sign/neg_series_sinh"}) {
        const diagnosis::Diagnosis d = of(name);
        EXPECT_EQ(names_of(d), "law.series") << name;
        EXPECT_EQ(d.verdict, VerdictKind::kIdentified) << name;
        EXPECT_NEAR(d.effects.at(0).parameter.value, 3e-4, 2e-5) << name;
    }
    EXPECT_EQ(names_of(of("law_sign/neg_both")), "law.scale");
    EXPECT_EQ(field_refused([&] { return of("law_sign/mNm"); }), "pull_a.csv: torque_Nm");
}

/// Known weights on a series elastic drive, its stated stiffness as the law (README.md beside the files).
Case weights(const fs::path& file, double stiffness) {
    Record record{"pull", "pull_a.csv", {}, {}, {}, {}, {"law_a.csv", {-0.12, 0.12}, {-0.12 * stiffness, 0.12 * stiffness}}};
    std::istringstream lines(core::read_file(file));
    for (std::string line; std::getline(lines, line);) {
        std::vector<double> numbers;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::strtod(cell.c_str(), nullptr));
        if (numbers.size() != 6 || line.front() == '#' || line.front() == 'd') continue;
        record.columns["t_s"].push_back(static_cast<double>(record.columns["t_s"].size()));
        record.columns["q_rad"].push_back(numbers[5]);
        record.columns["torque_Nm"].push_back(numbers[3]);
    }
    Case subsystem_case = case_of({std::move(record)});
    subsystem_case.sensors.clear();
    return subsystem_case;
}

TEST(RealPull, AnydriveHadAnotherRateBeforeItsMakersSetIt) {
    const fs::path files = fixtures::real_measurements("series_elastic_anydrive");
    if (!fs::exists(files)) GTEST_SKIP() << files << " does not exist";
    const diagnosis::Diagnosis before = diagnosed(weights(files / "before.csv", 145.4)),
                               after = diagnosed(weights(files / "after.csv", 160.8));
    EXPECT_EQ(names_of(before), "law.scale");
    EXPECT_EQ(before.verdict, VerdictKind::kIdentified);
    EXPECT_NEAR(before.effects.at(0).parameter.value, 0.106, 0.002);
    EXPECT_EQ(after.verdict, VerdictKind::kNone);
    expect_no_friction(before);
}

}  // namespace
}  // namespace fusee::subsystem
