#include <cmath>
#include <map>

#include "fixture.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {
namespace {

using namespace fixtures;

class Cover : public TempFolder {
protected:
    /// The finding of a rule on the paper's law between two loads.
    core::Finding finding(const std::string& rule, double start, double end) const {
        const auto changed = with_keys(core::read_file(shipped("pnrvsa")),
                                       {{"law.start_torque_Nm", std::to_string(start)}, {"law.end_torque_Nm", std::to_string(end)}});
        const auto design = resolve(profile::read_profile(write("p.toml", changed)));
        EXPECT_TRUE(design);
        for (const core::Finding& f : design->findings)
            if (f.rule == rule) return f;
        ADD_FAILURE() << rule << " was not reported";
        return {};
    }
};

TEST_F(Cover, IsCompleteForTheShippedLaw) { EXPECT_EQ(finding("law.covers_greatest", 0.6, 2.21).severity, core::Severity::kPass); }

TEST_F(Cover, NamesTheGreatestCoveredTorqueAndItsCureWorks) {
    const core::Finding f = finding("law.covers_greatest", 0.6, 1.9);
    EXPECT_EQ(f.severity, core::Severity::kWarning);
    EXPECT_GT(f.measured, 1.0);
    EXPECT_LT(f.measured, 1.5);
    const std::string key = "law.end_torque_Nm = ";
    const double cure = std::strtod(f.suggestion.text().c_str() + f.suggestion.text().find(key) + key.size(), nullptr);
    EXPECT_EQ(finding("law.covers_greatest", 0.6, cure).severity, core::Severity::kPass) << cure;
}

// A law too narrow for any dead-band has no covered torque to name: the loads are compared instead, and no figure is "not a number".
TEST_F(Cover, OfANarrowLawIsToldInLoads) {
    for (const char* rule : {"law.covers_least", "law.covers_greatest"}) {
        const core::Finding f = finding(rule, 0.9, 1.0);
        EXPECT_EQ(f.severity, core::Severity::kWarning) << rule;
        EXPECT_TRUE(std::isfinite(f.measured) && std::isfinite(f.allowed)) << rule;
        EXPECT_EQ(f.suggestion.text().find("nan"), std::string::npos) << f.suggestion.text();
    }
}

/// A jump in the rows of one spring is a warning at that column, and none at the other.
TEST(MeasuredRows, AJumpOfOneSpringIsNamedByItsColumn) {
    profile::Profile measured = profile::read_profile(fixtures::shipped("measured_table"));
    auto& series = std::get<profile::TablePair>(measured.law.curves).series;
    for (std::size_t i = series.size() / 2; i < series.size(); ++i) series[i] += 0.06;
    const auto design = resolve(measured);
    ASSERT_TRUE(design);
    std::map<std::string, core::Severity> found;
    for (const core::Finding& f : design->findings)
        if (f.rule == "law.rows") found[f.where.substr(0, f.where.find(" at "))] = f.severity;
    EXPECT_EQ(found, (std::map<std::string, core::Severity>{{"law, parallel_Nm", core::Severity::kPass},
                                                            {"law, series_Nm", core::Severity::kWarning}}));
}

}  // namespace
}  // namespace fusee::pipeline
