#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "fusee/diagnosis/diagnose.h"
#include "fusee/gap_case/reference.h"
#include "inference/fixture.h"
#include "similar_case.h"

// A diagnosis does not depend on the size of a rig (docs/theory/diagnosis.md, eq. 18).
namespace fusee::diagnosis {
namespace {

using namespace fixtures;

struct Similarity {
    double torque, radius;
    double tolerance;  ///< relative: powers of two change no bit, other factors round
};
void PrintTo(const Similarity& s, std::ostream* out) { *out << s.torque << " times the torque, " << s.radius << " the radius"; }

class SimilarRigs : public testing::TestWithParam<Similarity> {
protected:
    [[nodiscard]] double factor(const std::string& unit) const {
        return gap_case::Reference{.torque = GetParam().torque, .radius = GetParam().radius}.of(unit);
    }
    void expect_equal(double wanted, double found, const std::string& what) const {
        if (std::isnan(wanted) && std::isnan(found)) return;
        EXPECT_LE(std::abs(found - wanted), GetParam().tolerance * std::abs(wanted)) << what << ": " << wanted << ", " << found;
    }
    void expect_similar(const Parameter& wanted, const Parameter& found, const std::string& what) const {
        EXPECT_EQ(wanted.unit, found.unit);
        const double f = factor(wanted.unit), size = std::abs(wanted.value);
        for (const auto& [a, b] :
             {std::pair{wanted.value, found.value}, {wanted.ci95.low, found.ci95.low}, {wanted.ci95.high, found.ci95.high}})
            EXPECT_LE(std::abs(b / f - a), GetParam().tolerance * std::max(size, std::abs(a))) << what << ": " << a << ", " << b / f;
    }
    void expect_same_answer(const gap_case::Case& reference) const {
        const Diagnosis wanted = diagnose(reference, {.jobs = 2, .progress = {}});
        const Diagnosis found = diagnose(similar_case(reference, GetParam().torque, GetParam().radius), {.jobs = 2, .progress = {}});
        ASSERT_EQ(wanted.verdict, found.verdict) << diagnosis_json(found);
        ASSERT_EQ(wanted.effects.size(), found.effects.size());
        for (std::size_t i = 0; i < wanted.effects.size(); ++i) {
            EXPECT_EQ(wanted.effects[i].cause, found.effects[i].cause);
            expect_equal(wanted.effects[i].probability, found.effects[i].probability, "probability");
            expect_similar(wanted.effects[i].parameter, found.effects[i].parameter, wanted.effects[i].cause.id);
        }
        expect_equal(wanted.gap.before, found.gap.before, "gap before");
        expect_equal(wanted.gap.after, found.gap.after, "gap after");
        expect_equal(wanted.gap.heldout_after, found.gap.heldout_after, "held-out gap after");
        ASSERT_EQ(wanted.ranking.size(), found.ranking.size());
        for (std::size_t i = 0; i < wanted.ranking.size(); ++i) EXPECT_EQ(wanted.ranking[i].effects, found.ranking[i].effects);
        for (std::size_t i = 0; i < wanted.isolability.causes.size(); ++i)
            expect_equal(wanted.isolability.detectable[i] * factor(wanted.isolability.units[i]), found.isolability.detectable[i],
                         "detectable " + wanted.isolability.causes[i].id);
    }
};

/// All experiments, of each a part: the joint moves for 12 s.
gap_case::Rows some_of_all() {
    const gap_case::Rows all = set_points(small_template());
    gap_case::Rows rows = pulls(5);
    rows.breakaway = break_aways({0.2, 0.6, 1.0, 1.4}, 3, true).breakaway;
    for (std::size_t i = 3; i < all.dead_band.size(); i += 9) rows.dead_band.push_back(all.dead_band[i]);
    for (std::size_t i = 0; i < all.joint_stiffness.size() / 3; i += 2) rows.joint_stiffness.push_back(all.joint_stiffness[i]);
    for (std::size_t i = 0; i < all.cocontraction.size(); i += 6) rows.cocontraction.push_back(all.cocontraction[i]);
    rows.log = short_log(1.0).log;
    return rows;
}

TEST_P(SimilarRigs, HaveTheSameDiagnosis) { expect_same_answer(measured_case(some_of_all(), {kCoulomb}, {0.05}, 1.0, 4)); }

TEST_P(SimilarRigs, HaveTheSameDiagnosisInAnOpenCase) {
    const char* const folder = std::getenv("FUSEE_GAP_CASES");
    if (folder == nullptr) GTEST_SKIP() << "FUSEE_GAP_CASES names no folder of open cases";
    gap_case::Case part = gap_case::read_case(std::filesystem::path(folder) / "case07");
    part.rows.joint_stiffness.clear();  // their motion takes most of the time
    part.rows.log.clear();
    expect_same_answer(part);
}

INSTANTIATE_TEST_SUITE_P(All, SimilarRigs,
                         testing::Values(Similarity{8.0, 2.0, 0.0}, Similarity{1.0 / 64.0, 0.25, 0.0}, Similarity{0.02, 0.2, 1e-6},
                                         Similarity{1000.0, 2.0, 1e-6}));

}  // namespace
}  // namespace fusee::diagnosis
