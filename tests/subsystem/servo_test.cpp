#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "pipeline/fixture.h"
#include "subsystem/fixture.h"

// Habits of logs of servos: goals that are held, figures that nobody gave, files in any order, other units.
namespace fusee::subsystem {
namespace {

namespace fs = std::filesystem;
using fixtures::names_of;
using fixtures::says;

/// A faultless servo in steps of 0.1 ms, not by the model's code: what it is told, and when, is up to the case.
struct Bench {
    double duty = 0.2, kt = 2.5, resistance = 10.0, armature = 0.02, coulomb = 0.12, viscous = 0.02, supply = 12.0;
    double rate = 100.0, seconds = 5.0, step = 2.0 * 3.141592653589793 / 4096.0;
    std::function<double(double)> goal = {};
    bool held = false;  ///< the servo gets a goal with each row
};

double swing(double t) { return 0.9 * std::sin(2.4 * t) + 0.3 * std::sin(5.1 * t); }
double steps(double t) { return t < 0.5 ? 0.0 : t < 1.5 ? 0.8 : t < 2.5 ? -0.8 : t < 3.5 ? 1.1 : 0.2; }
double slow_steps(double t) { return t < 0.7 ? 0.0 : t < 2.2 ? -1.0 : t < 3.7 ? 0.6 : -0.3; }

Record log_of(const Bench& bench, double kp, double mass, const std::string& name) {
    Record record{"pendulum_log",
                  name + ".csv",
                  {{"mass_kg", mass}, {"length_m", 0.1}, {"kp", kp}, {"vin_V", bench.supply}},
                  {{"trajectory", name}},
                  {},
                  {}};
    const double weight = mass * 0.1 * 9.81, inertia = mass * 0.01 + bench.armature, h = 1e-4;
    const auto every = static_cast<int>(std::lround(1.0 / (bench.rate * h)));
    double q = 0.0, v = 0.0, told = bench.goal(0.0);
    for (int i = 0; i <= std::lround(bench.seconds / h); ++i) {
        const double t = i * h;
        if (!bench.held || i % every == 0) told = bench.goal(t);
        if (i % every == 0) {
            record.columns["t_s"].push_back(t);
            record.columns["q_rad"].push_back(bench.step * std::round(q / bench.step));
            record.columns["q_goal_rad"].push_back(bench.goal(t));
        }
        const double duty = std::clamp(bench.duty * kp * (told - q), -1.0, 1.0);
        const double torque = bench.kt * (duty * bench.supply - bench.kt * v) / bench.resistance - weight * std::sin(q) - bench.viscous * v;
        const double free = v + h * torque / inertia, stop = h * bench.coulomb / inertia;  // what friction can stop in a step
        v = std::abs(free) <= stop ? 0.0 : free - std::copysign(stop, free);
        q += h * v;
    }
    return record;
}

/// Two gains on each motion.
Case bench_case(Bench bench, const std::vector<std::function<double(double)>>& goals, const std::vector<double>& masses = {1.0}) {
    Case logs;
    logs.kind = Kind::kServoPendulum;
    logs.name = "servo";
    logs.parameters = {{"duty_per_kp_rad", bench.duty}, {"kt_Nm_per_A", bench.kt}, {"resistance_ohm", bench.resistance}};
    for (const double mass : masses)
        for (const double kp : {16.0, 32.0})
            for (std::size_t g = 0; g < goals.size(); ++g) {
                bench.goal = goals[g];
                logs.records.push_back(log_of(
                    bench, kp, mass, "k" + std::to_string(static_cast<int>(kp)) + "_t" + std::to_string(g) + (mass < 1.0 ? "_light" : "")));
                logs.records.back().parameters.insert(logs.parameters.begin(), logs.parameters.end());
            }
    return logs;
}

void tell_goals(Case& logs, const std::string& word) {
    for (Record& record : logs.records) record.words["goals"] = word;
}

diagnosis::Diagnosis answer(const Case& logs) { return diagnose(logs, {.jobs = 1, .progress = {}}); }

double figure_of(const diagnosis::Diagnosis& d, const std::string& name) {
    for (const auto& [figure, parameter] : d.build)
        if (figure == name) return parameter.value;
    return std::nan("");
}

bool doubts(const diagnosis::Diagnosis& d, const std::string& text) {
    return std::any_of(d.doubts.begin(), d.doubts.end(), [&](const std::string& doubt) { return doubt.find(text) != std::string::npos; });
}

TEST(DiagnoseServo, GoalsHeldBetweenRowsAreNoFault) {
    Case logs = bench_case({.rate = 50.0, .held = true}, {swing, steps});
    const diagnosis::Diagnosis open = answer(logs);
    EXPECT_EQ(open.verdict, diagnosis::VerdictKind::kNone) << names_of(open);
    EXPECT_TRUE(says(open, "bench.goals is not given: \"held\" until the next row is taken"));
    EXPECT_EQ(figure_of(open, "goals"), 1.0) << "a prediction needs it";
    tell_goals(logs, "straight");  // as the case says, be it wrong
    const diagnosis::Diagnosis wrong = answer(logs);
    EXPECT_GT(wrong.gap.before, 2.0 * open.gap.before);
    EXPECT_FALSE(says(wrong, "bench.goals"));
    tell_goals(logs, "held");
    EXPECT_EQ(answer(logs).verdict, diagnosis::VerdictKind::kNone);
}

TEST(DiagnoseServo, SmoothGoalsAreStraightAndJumpsComeWithTheirRow) {
    const diagnosis::Diagnosis d = answer(bench_case({}, {swing, steps}));
    EXPECT_EQ(d.verdict, diagnosis::VerdictKind::kNone) << names_of(d);
    EXPECT_TRUE(says(d, "\"jumps\": straight, a jump with its row is taken"));
    EXPECT_NEAR(figure_of(d, "armature"), 0.02, 0.0005);
}

// The loop's gain off by a factor of 5 is no effect of the servo: the search for it stops at an end.
TEST(DiagnoseServo, NamesNothingAtAnEndOfItsRange) {
    Case logs = bench_case({.held = true}, {steps, slow_steps});
    for (Record& record : logs.records) record.parameters["duty_per_kp_rad"] *= 5.0;
    const diagnosis::Diagnosis d = answer(logs);
    EXPECT_NE(d.verdict, diagnosis::VerdictKind::kIdentified) << names_of(d);
    EXPECT_NE(d.verdict, diagnosis::VerdictKind::kNone);
    EXPECT_EQ(names_of(d).find("loop.gain"), std::string::npos);
    EXPECT_TRUE(doubts(d, "loop.gain at -0.6, an end of its range (-0.6 to 2)"));
    EXPECT_TRUE(doubts(d, "check duty_per_kp_rad"));
}

TEST(DiagnoseServo, AnUnknownGainForbidsACertainAnswer) {
    Case logs = bench_case({.held = true}, {steps, slow_steps});
    for (Record& record : logs.records) record.parameters.erase("duty_per_kp_rad");
    logs.parameters.clear();
    const diagnosis::Diagnosis d = answer(logs);
    EXPECT_EQ(d.verdict, diagnosis::VerdictKind::kInconclusive) << names_of(d);
    EXPECT_TRUE(doubts(d, "bench.duty_per_kp_rad is not given"));
    EXPECT_TRUE(doubts(d, "XL330"));
    EXPECT_NE(diagnosis::diagnosis_json(d).find("\"doubts\""), std::string::npos);
    EXPECT_TRUE(says(d, "loop.gain cannot be seen here"));
    EXPECT_LT(d.gap.before, 1.0) << "the gain is fitted, and nothing is left";
}

class ServoFolder : public fixtures::TempFolder {
protected:
    /// The files of a case, and a case.toml that lists them in this order.
    void put(const Case& logs, const std::string& bench, std::vector<std::string> order = {}) const {
        write_rows(logs, folder_);
        std::string list;
        for (const Record& record : logs.records) {
            std::string words = "#";
            for (const auto& [name, value] : record.parameters) words += " " + name + "=" + std::to_string(value);
            write(record.file, words + "\n" + core::read_file(folder_ / record.file));
            if (order.size() < logs.records.size()) order.push_back(record.file);
        }
        for (const std::string& file : order) list += (list.empty() ? "\"" : ", \"") + file + "\"";
        write("case.toml", "[bench]\nkind = \"servo_pendulum\"\n" + bench + "[experiments]\npendulum_log = [" + list + "]\n");
    }
    [[nodiscard]] std::string refusal() const {
        try {
            (void)read_case(folder_);
        } catch (const core::InputError& e) {
            return e.what();
        }
        return "accepted";
    }
};

TEST_F(ServoFolder, AnyOrderOfFilesGivesTheSameBytes) {
    const Case logs = bench_case({.seconds = 3.0}, {steps, slow_steps}, {1.0, 0.1});
    std::vector<std::string> files;
    for (const Record& record : logs.records) files.push_back(record.file);
    const auto json = [&] {
        diagnosis::Diagnosis d = answer(read_case(folder_));
        EXPECT_EQ(d.verdict, diagnosis::VerdictKind::kNone) << names_of(d);
        EXPECT_NEAR(figure_of(d, "armature"), 0.02, 0.001) << "20 times the inertia of the light load";
        d.case_sha256.clear();  // of case.toml too, which lists the files
        return diagnosis::diagnosis_json(d);
    };
    put(logs, "", files);
    const std::string one = json();
    std::rotate(files.begin(), files.begin() + 3, files.end());
    std::swap(files[0], files[5]);
    put(logs, "", files);
    EXPECT_EQ(json(), one);
}

TEST_F(ServoFolder, AsksAboutOtherUnits) {
    const Case logs = bench_case({.rate = 100.0, .seconds = 2.0}, {swing}, {0.3});
    put(logs, "");
    ASSERT_EQ(refusal(), "accepted");
    const double degree = 57.29577951308232;
    struct Other {
        const char* figure;  ///< a column or a word
        double factor;
        const char* asked;
    };
    const std::vector<Other> others{
        {"angles", degree, "degrees"},     {"angles", 0.1 * degree, "degrees"},    {"q_goal_rad", degree, "degrees"},
        {"angles", 651.8986469, "counts"}, {"t_s", 1e3, "are these milliseconds"}, {"t_s", 1e6, "are these microseconds"},
        {"mass_kg", 1e3, "grams"},         {"length_m", 1e3, "millimetres"},       {"vin_V", 1e3, "millivolts"},
        {"kt_Nm_per_A", 1e3, "mNm/A"},     {"resistance_ohm", 1e3, "milliohms"}};
    for (const Other& other : others) {
        Case scaled = logs;
        for (Record& record : scaled.records) {
            for (auto& [name, column] : record.columns) {
                const bool angle = std::string(other.figure) == "angles" && name.starts_with("q_");
                if (name != other.figure && !angle) continue;
                const bool small = other.factor == 0.1 * degree;  // a motion of some degrees: the encoder's step tells
                for (double& value : column) value *= small ? degree : other.factor;
                if (small)
                    for (double& value : column) value = std::clamp(value, -8.0, 8.0);
            }
            if (const auto at = record.parameters.find(other.figure); at != record.parameters.end()) at->second *= other.factor;
        }
        put(scaled, "");
        EXPECT_NE(refusal().find(other.asked), std::string::npos) << other.figure << " times " << other.factor << ": " << refusal();
    }
    put(logs, "coulomb_Nm = 120\n");
    EXPECT_NE(refusal().find("mNm"), std::string::npos) << refusal();
    put(logs, "goals = \"ramped\"\n");
    EXPECT_NE(refusal().find("held, straight, jumps"), std::string::npos) << refusal();
}

class OtherElements : public fixtures::TempFolder {
protected:
    /// What a case says whose columns of these names are `factor` times as large.
    [[nodiscard]] std::string refusal(Case measured, const std::string& toml, const std::vector<std::string>& columns,
                                      double factor) const {
        std::string list;
        for (Record& record : measured.records) {
            for (const std::string& column : columns)
                for (double& value : record.columns[column]) value *= factor;
            list += (list.empty() ? "\"" : ", \"") + record.file + "\"";
        }
        write_rows(measured, folder_);
        write("case.toml", toml + "[" + list + "]\n");
        try {
            (void)read_case(folder_);
        } catch (const core::InputError& e) {
            return e.what();
        }
        return "accepted";
    }
};

TEST_F(OtherElements, AskAboutOtherUnits) {
    const std::string element = "[bench]\nkind = \"friction_element\"\n[sensors]\nforce_noise_N = 20\n[experiments]\nforce_loop = ";
    const Case loops = fixtures::measure(fixtures::Element{}, 1);
    EXPECT_EQ(refusal(loops, element, {"x_m"}, 1.0), "accepted");
    EXPECT_NE(refusal(loops, element, {"x_m"}, 1e3).find("millimetres"), std::string::npos);
    EXPECT_NE(refusal(loops, element, {"v_m_s"}, 1e2).find("mm/s"), std::string::npos);
    EXPECT_NE(refusal(loops, element, {"t_s"}, 1e3).find("milliseconds"), std::string::npos);
    EXPECT_NE(refusal(loops, element, {"F_N"}, 1e-3).find("kN"), std::string::npos);
    const std::string motor = "[bench]\nkind = \"motor_breakaway\"\n[sensors]\ntorque_noise_Nm = 0.0015\n[experiments]\nbreakaway = ";
    const Case breaks = fixtures::measure({{"agonist", fixtures::Motor{}}}, 1);
    EXPECT_EQ(refusal(breaks, motor, {"load_torque_Nm"}, 1.0), "accepted");
    EXPECT_NE(refusal(breaks, motor, {"load_torque_Nm"}, 1e2).find("Ncm"), std::string::npos);
    EXPECT_NE(refusal(breaks, motor, {"motor_torque_Nm", "load_torque_Nm"}, 1e3).find("mNm"), std::string::npos);
    EXPECT_NE(refusal(breaks, motor, {"motor_torque_Nm", "load_torque_Nm"}, 2e2).find("mNm"), std::string::npos) << "by the noise";
}

// A scatter of the friction that nobody measured: rows that have another one allow no certain answer.
TEST(DiagnoseSubsystem, ADefaultOfTheScatterIsADoubtUnlessTheRowsHaveIt) {
    for (const auto& [scatter, doubted] : {std::pair{0.03, false}, {0.003, true}, {0.12, true}}) {
        Case single = fixtures::measure({{"agonist", fixtures::Motor{.scatter = scatter}}}, 12);
        single.sensors.clear();
        Record& record = single.records.front();  // no repeats: each torque is its own
        for (std::size_t i = 0; i < record.rows(); ++i) record.columns["motor_torque_Nm"][i] *= 1.0 + 1e-9 * static_cast<double>(i);
        const diagnosis::Diagnosis d = answer(single);
        EXPECT_EQ(doubts(d, "sensors.breakaway_scatter is not given"), doubted) << scatter;
        if (doubted) {
            EXPECT_NE(d.verdict, diagnosis::VerdictKind::kNone) << scatter;
            EXPECT_NE(d.verdict, diagnosis::VerdictKind::kIdentified) << scatter;
        }
    }
}

/// Processor time of a living process, s.
double processor_time(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {}), field;
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    for (int i = 3; i < 14; ++i) fields >> field;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

// A signal ends a diagnosis within a second of processor time, in whatever step it is; house.stop measures the clock.
TEST_F(ServoFolder, EndsSoonAfterASignal) {
    const Case logs = bench_case({.rate = 500.0, .seconds = 30.0}, {swing, steps});
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        core::catch_interrupts();
        if (::write(ready[1], "r", 1) != 1) ::_exit(1);
        try {
            (void)answer(logs);
        } catch (const core::Stopped&) {
            ::_exit(130);
        }
        ::_exit(0);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ::close(ready[0]), ::close(ready[1]);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    const double before = processor_time(child);
    ::kill(child, SIGTERM);
    int status = 0;
    rusage used{};
    ASSERT_EQ(::wait4(child, &status, 0, &used), child);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    EXPECT_LT(seconds(used.ru_utime) + seconds(used.ru_stime) - before, 1.0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
}

}  // namespace
}  // namespace fusee::subsystem
