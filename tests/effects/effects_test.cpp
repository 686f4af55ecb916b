#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "fusee/core/file.h"
#include "fusee/effects/term.h"
#include "fusee/joint_model/signals.h"
#include "inference/fixture.h"
#include "joint_model/fixture.h"
#include "refused.h"

// What every effect of the library has to keep, and that docs/gap.md tells all of them.
namespace fusee::effects {

void PrintTo(const Effect& effect, std::ostream* out) { *out << effect.id; }

namespace {

using namespace fixtures;

/// id -> its parameter's unit as the tables of docs/gap.md give it in their last column, its size in the one before.
std::map<std::string, std::string> documented(std::size_t column_from_end = 1) {
    const std::string page = core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / "docs/gap.md");
    std::istringstream lines(page.substr(page.find("\n## Effects"), page.find("\n## diagnosis.json") - page.find("\n## Effects")));
    const auto split = [](const std::string& text, const std::string& by) {
        std::vector<std::string> parts;
        std::size_t from = 0;
        for (std::size_t at = text.find(by); at != std::string::npos; from = at + by.size(), at = text.find(by, from))
            parts.push_back(text.substr(from, at - from));
        parts.push_back(text.substr(from));
        return parts;
    };
    std::map<std::string, std::string> units;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| `", 0) != 0) continue;
        const std::vector<std::string> cells = split(line.substr(2, line.size() - 4), " | ");
        const std::vector<std::string> ids = split(cells.front(), ", "), of = split(cells.at(cells.size() - column_from_end), ", ");
        for (std::size_t i = 0; i < ids.size(); ++i)
            units[ids[i].substr(1, ids[i].size() - 2)] = of.size() == ids.size() ? of[i] : of.front();
    }
    return units;
}

/// Few rows of every experiment, in which every effect leaves its mark.
gap_case::Rows thin_rows() {
    const gap_case::Rows all = set_points(small_template());
    gap_case::Rows rows;
    rows.breakaway = break_aways({0.3, 0.9, 1.4}, 1, true).breakaway;
    rows.spring_pull = pulls(6).spring_pull;
    for (const gap_case::DeadBandRow& row : all.dead_band)
        if (row.repeat == 1 && row.cocontraction < 1.2) rows.dead_band.push_back(row);
    for (const gap_case::StiffnessRow& row : all.joint_stiffness)
        if (row.cocontraction < 1.0) rows.joint_stiffness.push_back(row);
    rows.cocontraction = all.cocontraction;
    for (std::size_t i = 0; i < all.log.size(); i += 3) rows.log.push_back(all.log[i]);
    return rows;
}

/// Experiments that differ from those of a faultless rig.
class Marks {
public:
    Marks() : rows_(thin_rows()), cams_(small_template().rig), faultless_(signals({}, {})) {}
    [[nodiscard]] std::set<gap_case::Experiment> of(const Effect& effect, const std::string& side,
                                                    const std::vector<double>& values) const {
        const joint_model::Signals changed = signals({{effect.id, side}}, values);
        std::set<gap_case::Experiment> marks;
        for (const gap_case::Experiment e : gap_case::kAllExperiments)
            if (farthest(changed[e], faultless_[e]) > kRounding) marks.insert(e);
        return marks;
    }

private:
    static constexpr double kRounding = 1e-9;
    [[nodiscard]] joint_model::Signals signals(const std::vector<Cause>& causes, const std::vector<double>& values) const {
        joint_model::BuiltRig rig(small_template().rig);
        for (const Cause& cause : causes) apply_effect(find_effect_or_term(cause.id), cause, values, rig);
        rig.assemble(cams_);
        return joint_model::predict_signals(rig, rows_, small_template().protocol);
    }
    gap_case::Rows rows_;
    joint_model::NominalCams cams_;
    joint_model::Signals faultless_;
};

/// The size that is no effect at all: 0, or of a limit what nothing reaches.
double no_effect(const Effect& effect) { return effect.parameters[0].allowed.low > 0.0 ? joint_model::kNever : 0.0; }

std::vector<double> values_at(const Effect& effect, double size) {
    std::vector<double> values{size};
    for (std::size_t k = 1; k < effect.parameters.size(); ++k) values.push_back(effect.parameters[k].at_first);
    return values;
}

class Library : public ::testing::TestWithParam<Effect> {
protected:
    static const Marks& marks() {
        static const Marks all;
        return all;
    }
    [[nodiscard]] static std::vector<std::string> sides() {
        return GetParam().sided ? std::vector<std::string>{"agonist", "antagonist", "both"} : std::vector<std::string>{"none"};
    }
};

TEST_P(Library, IsDocumentedWithItsUnit) {
    if (term_or_none(GetParam().id) != nullptr) {
        const std::string page = core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / "docs/theory/unknown.md");
        EXPECT_NE(page.find("| `" + GetParam().id + "` |"), std::string::npos) << GetParam().id;
        return;
    }
    const std::map<std::string, std::string> page = documented();
    const auto row = page.find(GetParam().id);
    ASSERT_NE(row, page.end()) << "docs/gap.md lacks " << GetParam().id;
    const EffectParameter& size = GetParam().parameters[0];
    const std::string told = row->second.substr(0, row->second.find(' '));
    const bool plain = size.unit == "1" && (told == "relative" || told == size.name);
    EXPECT_TRUE(plain || told == size.unit) << "docs/gap.md: " << row->second << "; the library: " << size.unit;
}

TEST_P(Library, HasALawParametersWithRangesAndStartsInsideThem) {
    const Effect& effect = GetParam();
    ASSERT_FALSE(effect.parameters.empty());
    for (const std::string& sentence : {effect.law, effect.meaning}) EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    for (const EffectParameter& p : effect.parameters) {
        EXPECT_LT(p.allowed.low, p.allowed.high) << p.name;
        EXPECT_GT(p.scale, 0.0) << p.name;
        for (const double value : p.tries) EXPECT_TRUE(p.allowed.holds(value)) << p.name << value;
        EXPECT_TRUE(&p == &effect.parameters.front() || p.allowed.holds(p.at_first)) << p.name;
    }
    ASSERT_FALSE(effect.starts.empty());
    for (const double start : effect.starts) EXPECT_TRUE(effect.parameters[0].allowed.holds(start * effect.parameters[0].scale)) << start;
    ASSERT_FALSE(effect.seen_by.empty());
    for (const std::string& other : effect.confused_with) {
        EXPECT_NE(other, effect.id);
        EXPECT_NO_THROW((void)find_effect(other)) << other;
    }
}

TEST_P(Library, OfNoSizeChangesNothing) {
    for (const std::string& side : sides()) EXPECT_TRUE(marks().of(GetParam(), side, values_at(GetParam(), no_effect(GetParam()))).empty());
}

TEST_P(Library, ChangesOnlyWhatItIsSeenByAndEachStartSomeOfIt) {
    const Effect& effect = GetParam();
    const std::set<gap_case::Experiment> allowed(effect.seen_by.begin(), effect.seen_by.end());
    for (const double start : effect.starts) {
        const std::set<gap_case::Experiment> seen =
            marks().of(effect, sides().front(), values_at(effect, start * effect.parameters[0].scale));
        for (const gap_case::Experiment e : seen) EXPECT_TRUE(allowed.contains(e)) << to_string(e) << " shows it too, at " << start;
        // A limit that this rig does not reach is none.
        const bool reached = no_effect(effect) == 0.0 || start == effect.starts.front();
        EXPECT_FALSE(reached && seen.empty()) << start;
    }
}

TEST_P(Library, RefusesASideThatItDoesNotHave) {
    const Effect& effect = GetParam();
    const std::vector<double> values = values_at(effect, effect.starts[0] * effect.parameters[0].scale);
    for (const char* side : {"agonist", "antagonist", "both", "none", "left", ""}) {
        joint_model::BuiltRig rig(small_template().rig);
        const bool known =
            std::string(side) == "none" ? !effect.sided : effect.sided && std::string("leftagonist antagonist both").find(side) > 3;
        EXPECT_EQ(field_refused([&] {
                      return apply_effect(effect, {effect.id, side}, values, rig), 0;
                  }),
                  known ? "accepted" : "effects: side of " + effect.id)
            << side;
    }
}

const auto name_of = [](const auto& test) {
    std::string name = test.param.id;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
};
INSTANTIATE_TEST_SUITE_P(All, Library, ::testing::ValuesIn(effect_library()), name_of);
INSTANTIATE_TEST_SUITE_P(Terms, Library, ::testing::ValuesIn(terms_on({})), name_of);

TEST(TermLibrary, EachTellsItsPlaceItsVariableAndItsValues) {
    std::set<std::string> ids;
    for (const Term& term : term_library()) {
        EXPECT_TRUE(ids.insert(term.effect.id).second) << term.effect.id;
        EXPECT_EQ(effect_or_none(term.effect.id), nullptr) << term.effect.id;
        EXPECT_FALSE(term.port.empty() || term.depends_on.empty() || term.over.empty() || term.gives.empty()) << term.effect.id;
        const std::vector<double> values = values_at(term.effect, term.effect.parameters[0].scale);
        EXPECT_TRUE(std::isfinite(term.curve(values, 0.5))) << term.effect.id;
        const std::string sentence = sentence_of(term, "agonist", values);
        EXPECT_TRUE(sentence.ends_with('.') && sentence.find('{') == std::string::npos) << sentence;
    }
}

TEST(TermLibrary, TheSentenceOfARippleCountsTurns) {
    const Term& term = *term_or_none("term.motor.ripple");
    EXPECT_EQ(sentence_of(term, "antagonist", {0.04, 12.0 / (2.0 * core::kPi), 0.3}),
              "The torque of the antagonist's motor ripples 12 times a turn of its capstan, by 0.04 Nm.");
}

TEST(TermLibrary, ASentenceHasTwoDigitsAndNoExponent) {
    EXPECT_EQ(sentence_of(*term_or_none("term.gear.drift"), "agonist", {-0.573, 337.0}),
              "The friction of the agonist's gear changes by -57 % over the session, with a time constant of 340 s.");
}

TEST(EffectLibrary, HasEachIdOnceAndNoMoreThanThePageTells) {
    std::set<std::string> ids;
    for (const Effect& effect : effect_library()) EXPECT_TRUE(ids.insert(effect.id).second) << effect.id << " twice";
    const std::map<std::string, std::string> sizes = documented(2);
    for (const Effect& effect : effect_library()) {
        const core::Range& allowed = effect.parameters.front().allowed;
        EXPECT_EQ(sizes.at(effect.id), fmt::format("{:g} to {:g}", allowed.low, allowed.high)) << effect.id;
    }
    for (const auto& [id, unit] : documented()) EXPECT_TRUE(ids.contains(id)) << "docs/gap.md tells " << id;
    EXPECT_EQ(documented().size(), ids.size());
}

TEST(EffectLibrary, IsThatOfTheReferenceRigAndScalesWithAnother) {
    const gap_case::Reference other{.torque = 8.0, .radius = 2.0, .time = 0.5};
    const std::vector<Effect> scaled = effects_on(other), same = effects_on({});
    for (std::size_t i = 0; i < effect_library().size(); ++i)
        for (std::size_t k = 0; k < effect_library()[i].parameters.size(); ++k) {
            const EffectParameter &of_library = effect_library()[i].parameters[k], &on_rig = scaled[i].parameters[k];
            const double factor = other.of(of_library.unit);
            EXPECT_EQ(on_rig.scale, factor * of_library.scale) << effect_library()[i].id;
            EXPECT_EQ(on_rig.allowed.low, factor * of_library.allowed.low);
            EXPECT_EQ(on_rig.allowed.high, factor * of_library.allowed.high);
            EXPECT_EQ(on_rig.at_first, factor * of_library.at_first);
            for (std::size_t t = 0; t < of_library.tries.size(); ++t) EXPECT_EQ(on_rig.tries[t], factor * of_library.tries[t]);
            EXPECT_EQ(same[i].parameters[k].scale, of_library.scale);
        }
}

TEST(EffectLibrary, AnUnknownIdIsRefusedWithThoseThatThereAre) {
    try {
        (void)find_effect("gear.magic");
        FAIL();
    } catch (const core::InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("gear.magic"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("gear.coulomb"), std::string::npos);
    }
}

TEST(EffectLibrary, AnEffectOfBothSidesIsThatOfEach) {
    for (const Effect& effect : effect_library()) {
        if (!effect.sided) continue;
        const std::vector<double> values = values_at(effect, effect.starts[0] * effect.parameters[0].scale);
        const joint_model::NominalCams cams(small_template().rig);
        const auto rig = [&](std::initializer_list<const char*> sides) {
            joint_model::BuiltRig r(small_template().rig);
            for (const char* side : sides) apply_effect(effect, {effect.id, side}, values, r);
            r.assemble(cams);
            return r;
        };
        gap_case::Rows rows = pulls(10);
        rows.breakaway = break_aways({0.3, 1.4}, 1, true).breakaway;
        const joint_model::BuiltRig both = rig({"both"}), one_by_one = rig({"agonist", "antagonist"});
        for (const gap_case::Experiment e : {gap_case::Experiment::kBreakAway, gap_case::Experiment::kSpringPull})
            EXPECT_EQ(joint_model::predict_experiment(both, rows, {}, e), joint_model::predict_experiment(one_by_one, rows, {}, e))
                << effect.id;
    }
}

}  // namespace
}  // namespace fusee::effects
