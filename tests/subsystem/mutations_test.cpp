#include <fmt/format.h>

#include <array>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/joint_model/signals.h"
#include "gap_case/fixture.h"
#include "subsystem/fixture.h"
#include "subsystem/mutate.h"

// Files that somebody has broken, by accident or on purpose: each is read, or refused with a sentence. FUSEE_MUTATIONS=4000 makes more.
namespace fusee::subsystem {
namespace {

namespace fs = std::filesystem;
using fixtures::Mutator;

/// What became of a mutated case: "read", or the refusal. Anything else that is thrown goes on and fails the test.
template <class Work>
std::string outcome(const Work& work) {
    try {
        work();
        return "read";
    } catch (const core::InputError& e) {
        return e.what();
    }
}

/// A refusal is a sentence with a place and a figure, not a "nan" of ours.
void expect_said(const std::string& said, const std::string& done) {
    EXPECT_GT(said.size(), 3u) << done;
    EXPECT_EQ(said.find("(allowed: )"), std::string::npos) << said << "\n" << done;
}

class Mutated : public fusee::fixtures::TempFolder {
protected:
    /// Lays a fresh copy of `good` and changes it by `seed`.
    std::string mutate(const std::map<std::string, std::string>& good, unsigned seed) const {
        std::vector<std::string> files;
        for (const auto& [file, text] : good) {
            core::write_file(folder_ / file, text);
            files.push_back(file);
        }
        return Mutator(seed).change(folder_, files);
    }
};

class MutatedCase : public fixtures::CaseFolder {};

TEST_F(MutatedCase, IsReadOrRefused) {
    gap_case::Rows few = fixtures::measured(template_);
    few.log.resize(120);
    few.joint_stiffness.resize(100);
    put(few);
    std::map<std::string, std::string> good;
    for (const fs::directory_entry& file : fs::directory_iterator(folder_)) {
        const std::string name = file.path().filename().string();
        if (name != "BENCH.md") good[name] = text(name);
    }
    std::size_t read = 0;
    const unsigned count = fixtures::mutations(300);
    for (unsigned seed = 0; seed < count; ++seed) {
        for (const auto& [file, bytes] : good) write(file, bytes);
        std::vector<std::string> files;
        for (const auto& [file, bytes] : good) files.push_back(file);
        const std::string done = Mutator(seed).change(folder_, files);
        SCOPED_TRACE(fmt::format("{}: {}", seed, done));
        const std::string said = outcome([&] {
            const gap_case::Case subsystem_case = gap_case::read_case(folder_);
            if (++read % 8 != 0) return;
            gap_case::Rows inputs = gap_case::read_inputs(subsystem_case, folder_);
            inputs.log.clear();
            inputs.parts.clear();
            const joint_model::Signals signals = joint_model::measured(diagnosis::predict(subsystem_case, {}, inputs));
            for (const double figure : signals[gap_case::Experiment::kDeadBand]) EXPECT_TRUE(std::isfinite(figure));
        });
        expect_said(said, done);
    }
    EXPECT_GT(read, count / 20);
    EXPECT_LT(read, count);
}

std::string record_csv(const Case& subsystem_case, const Record& record, const fs::path& folder) {
    Case one = subsystem_case;
    one.records = {record};
    one.records[0].file = "one.csv";
    write_rows(one, folder);
    return core::read_file(folder / "one.csv");
}

TEST_F(Mutated, SubsystemCasesAreDiagnosedOrRefused) {
    const Case motor = fixtures::measure({{"agonist", fixtures::Motor{}}}, 1, {0.2, 0.5, 1.0});
    Case element = fixtures::measure(fixtures::Element{.rows = 60}, 1), servo = fixtures::measure(fixtures::Servo{}, 1);
    const auto thinned = [](Record record, std::size_t most) {
        for (auto& [name, column] : record.columns) column.resize(std::min(most, column.size()));
        return record;
    };
    const std::map<std::string, std::string> motors{
        {"case.toml",
         "[bench]\nkind = \"motor_breakaway\"\ngear_load_friction = 0.25\n[sensors]\nbreakaway_scatter = 0.02\n"
         "[experiments]\nbreakaway = \"breakaway.csv\"\n"},
        {"breakaway.csv", record_csv(motor, motor.records[0], folder_)}};
    const std::map<std::string, std::string> elements{
        {"case.toml",
         "[bench]\nkind = \"friction_element\"\ncoulomb_N = 900\n[sensors]\nforce_noise_N = 20\n[experiments]\nforce_loop = "
         "[\"a.csv\", \"b.csv\"]\n"},
        {"a.csv", "# preload_N=100\n" + record_csv(element, element.records[0], folder_)},
        {"b.csv", "# preload_N=200\n" + record_csv(element, element.records[4], folder_)}};
    const std::map<std::string, std::string> servos{
        {"case.toml",
         "[bench]\nkind = \"servo_pendulum\"\nmass_kg = 0.49\nlength_m = 0.1\nvin_V = 7.4\n[sensors]\nencoder_step_rad = "
         "0.0015\n[experiments]\npendulum_log = [\"a.csv\", \"b.csv\"]\n"},
        {"a.csv", "# kp=100 trajectory=swing\n" + record_csv(servo, thinned(servo.records[0], 40), folder_)},
        {"b.csv", "# kp=300 trajectory=drop\n" + record_csv(servo, thinned(servo.records[3], 40), folder_)}};
    const Case cam = fixtures::measure(fixtures::CamRig{.rows = 40}, 1);
    const std::map<std::string, std::string> cams{
        {"case.toml",
         "[bench]\nkind = \"cam_joint\"\ndynamometer_Nm_per_rad = 12500\n[sensors]\ntorque_noise_Nm = 0.3\n"
         "[experiments]\npull = [\"a.csv\", \"b.csv\"]\nlaw = \"law.csv\"\n"},
        {"a.csv", record_csv(cam, cam.records[0], folder_)},
        {"b.csv", "# law=law.csv\n" + record_csv(cam, cam.records[1], folder_)},
        {"law.csv", "q_rad,torque_Nm\n-0.26,-40\n-0.1,-15\n0.0,0\n0.1,16\n0.26,100\n"}};
    std::size_t read = 0;
    const unsigned count = fixtures::mutations(120);
    for (unsigned seed = 0; seed < count; ++seed) {
        const auto& good = *std::array{&motors, &elements, &servos, &cams}[seed % 4];
        const std::string done = mutate(good, seed);
        SCOPED_TRACE(fmt::format("{}: {}", seed, done));
        const std::string said = outcome([&] {
            const Case subsystem_case = read_case(folder_);
            ++read;
            const diagnosis::Diagnosis found = diagnose(subsystem_case, {1, {}});
            EXPECT_FALSE(diagnosis::diagnosis_json(found).empty());
            (void)predict(subsystem_case, found, subsystem_case);
        });
        expect_said(said, done);
    }
    EXPECT_GT(read, count / 20);
}

}  // namespace
}  // namespace fusee::subsystem
