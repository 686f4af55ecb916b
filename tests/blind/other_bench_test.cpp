#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnose.h"
#include "fusee/plant/case_files.h"

// The diagnosis on benches unlike the one on which it was developed: encoders of 12 bit, three times the noise, other set points, faster
// phases. The plant measures, so that the model is not its own judge. By default two rigs whose parts are measured alone on each bench, and
// whole cases on the bench that differs in everything; FUSEE_ALL_BENCHES=1 adds whole cases on the others, which take minutes.
namespace fusee::blind {
namespace {

struct Bench {
    const char* name;
    double encoder_step, noise;  ///< [rad]; times the usual
    bool other_set_points;
    double duration;  ///< of every phase, times the usual
};
void PrintTo(const Bench& bench, std::ostream* out) { *out << bench.name; }

constexpr double kTwelveBits = 2.0 * std::numbers::pi / 4096.0, kThirteenBits = kTwelveBits / 2.0;

plant::TestRig rig_on(const Bench& bench, std::uint64_t index) {
    plant::TestRig rig = plant::draw_test_rig(17, index);
    rig.sensors.encoder_step = bench.encoder_step;
    for (double* noise : {&rig.sensors.encoder_noise, &rig.sensors.torque_noise, &rig.sensors.torque_noise_relative}) *noise *= bench.noise;
    plant::Protocol& p = rig.protocol;
    for (double* phase :
         {&p.motor_ramp, &p.motor_settle, &p.dead_band_push, &p.dead_band_release, &p.joint_stiffness_phase, &p.cocontraction_phase})
        *phase *= bench.duration;
    return rig;
}

class OtherBenches : public testing::TestWithParam<Bench> {
protected:
    /// A whole case of a rig with one effect of this kind, or without.
    static gap_case::Case measured_case(const std::string& id, std::uint64_t index, std::string* side = nullptr) {
        plant::TestRig rig = rig_on(GetParam(), index);
        plant::Random drawn(17, index, 5), noise(17, index, 6);
        if (!id.empty()) {
            const plant::Effect effect = plant::draw_effect(id, rig.nominal, drawn);
            plant::apply(effect, rig.truth);
            *side = effect.side;
        }
        const double scale = plant::range_of(rig.nominal).scale;
        gap_case::CaseTexts texts =
            plant::experiment_files(plant::measure(rig, plant::set_points(GetParam().other_set_points, scale), noise));
        texts["case.toml"] = plant::case_toml(rig);
        texts["nominal_springs.csv"] = plant::springs_csv(rig.nominal);
        return gap_case::read_case({"bench", texts});
    }
    static void expect_named(const gap_case::Case& gap_case, const std::string& id, const std::string& side) {
        const diagnosis::Diagnosis found = diagnosis::diagnose(gap_case, {.jobs = 2, .progress = {}});
        ASSERT_EQ(found.verdict, diagnosis::VerdictKind::kIdentified) << id << ": " << diagnosis::diagnosis_json(found).substr(0, 600);
        ASSERT_EQ(found.effects.size(), 1U) << id << ": " << diagnosis::diagnosis_json(found).substr(0, 1200);
        EXPECT_EQ(found.effects[0].cause, (effects::Cause{id, side}));
    }
};

TEST_P(OtherBenches, NameTheEffectOfAPartThatIsMeasuredAlone) {
    std::uint64_t index = 0;
    for (const char* id : {"gear.coulomb", "se.rate"}) {
        std::string side;
        gap_case::Case parts = measured_case(id, index++, &side);
        gap_case::Rows measured;
        measured.breakaway = parts.rows.breakaway;
        measured.spring_pull = parts.rows.spring_pull;
        parts.rows = measured;
        expect_named(parts, id, side);
    }
}

TEST_P(OtherBenches, NameTheEffectOfAWholeCase) {
    const Bench& bench = GetParam();
    const bool differs_in_all = bench.other_set_points && bench.noise > 1.0;
    const bool all = std::getenv("FUSEE_ALL_BENCHES") != nullptr;
    if (!differs_in_all && !all) GTEST_SKIP() << "FUSEE_ALL_BENCHES is not set: whole cases on four benches take minutes";
    std::uint64_t index = 10;
    for (const std::string& id :
         std::vector<std::string>{"gear.coulomb", "joint.coulomb", "se.rate", "pe.preload", "joint.gravity", "sensor.torque_scale"}) {
        const std::uint64_t own = index++;
        if (!all && id != "joint.coulomb") continue;
        std::string side;
        const gap_case::Case whole = measured_case(id, own, &side);
        expect_named(whole, id, side);
    }
    const diagnosis::Diagnosis none = diagnosis::diagnose(measured_case("", index), {.jobs = 2, .progress = {}});
    EXPECT_TRUE(none.effects.empty()) << none.effects.front().cause.id;
}

INSTANTIATE_TEST_SUITE_P(All, OtherBenches,
                         testing::Values(Bench{"encoders of 12 bit", kTwelveBits, 1.0, false, 1.0},
                                         Bench{"three times the noise", kThirteenBits, 3.0, false, 1.0},
                                         Bench{"other set points, faster", kThirteenBits, 1.0, true, 0.7},
                                         Bench{"all of these", kTwelveBits, 3.0, true, 0.7}),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
                             return name;
                         });

}  // namespace
}  // namespace fusee::blind
