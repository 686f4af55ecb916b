#include "fusee/effects/joint.h"

#include <gtest/gtest.h>

#include "gap_case/fixture.h"
#include "inference/fixture.h"

namespace fusee::effects {
namespace {

using namespace fixtures;

/// A setting for each effect and generic term at its first start, and in each another build parameter off by 2 sigma.
std::vector<inference::Setting> one_of_each(const Joint& joint) {
    std::vector<inference::Setting> settings;
    for (const inference::Effect& effect : joint.effects()) {
        inference::Setting& setting = settings.emplace_back();
        setting.build.resize(joint.build().size());
        const std::size_t off = settings.size() % setting.build.size();
        setting.build[off] = 2.0 * joint.build()[off].sigma;
        std::vector<double> values;
        for (const inference::EffectParameter& p : effect.parameters) values.push_back(p.at_first);
        values.front() = effect.starts.front() * effect.parameters.front().scale;
        setting.effects.push_back({{effect.id, effect.sides.front()}, values});
    }
    return settings;
}

// Not equal if lanes mix: one rig's hysteresis, stop, ripple or end of a push in another's, or a lane that moves on after it came to rest.
TEST(Joint, RigsThatAreLedTogetherReadWhatEachReadsAlone) {
    gap_case::Rows rows = measured(small_template());
    rows.log.resize(100);
    const gap_case::Case small = small_case(rows);
    const Joint joint(small);
    const std::vector<inference::Setting> settings = one_of_each(joint);
    ASSERT_GT(settings.size(), 40U);
    const std::vector<inference::Outputs> together = joint.predict_each(settings, inference::Extent::kOncePerSetPoint);
    ASSERT_EQ(together.size(), settings.size());
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const std::string& id = settings[i].effects.front().cause.id;
        const inference::Outputs alone = joint.predict(settings[i], inference::Extent::kOncePerSetPoint);
        for (std::size_t e = 0; e < alone.size(); ++e) EXPECT_EQ(together[i][e], alone[e]) << id << ", " << joint.experiments()[e].name;
    }
}

}  // namespace
}  // namespace fusee::effects
