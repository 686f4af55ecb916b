#include "common/mill_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <regex>

#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "fusee/toolpath/program.h"
#include "pipeline/fixture.h"

// The simulation's comparison with the drawn groove, on programs of shipped parts and on the same programs with a planted fault.
namespace fusee::formats {
namespace {

/// The programs of one part of pnrvsa.
class MillCheck : public testing::Test {
protected:
    void plan(cam::PartKind kind) {
        const profile::Profile profile = profile::read_profile(fixtures::shipped("pnrvsa"));
        design_ = std::make_unique<pipeline::DesignedPart>(pipeline::design_part(kind, pipeline::resolve(profile).value()).value());
        out_ = std::make_unique<PartExport>(PartExport{
            design_->part, {}, {profile.name, profile.cable, profile.process, profile.machining, 0.0, profile.title}, {}, "k_xx", {}});
        programs_ = toolpath::part_programs(design_->part, profile.machining, "fusee test").value();
    }
    /// Gouge and excess of the last program [mm], with a fault planted in its text.
    [[nodiscard]] std::array<double, 2> simulated(const std::function<void(std::string&)>& plant) {
        std::vector<toolpath::Program> programs = programs_;
        plant(programs.back().text);
        const Milled milled = mill(*out_, programs).back();
        broken_ = core::any_error(milled.findings);
        return {measured(milled, "millsim.gouge"), measured(milled, "millsim.excess")};
    }
    static double measured(const Milled& milled, const std::string& rule) {
        const auto found = std::find_if(milled.findings.begin(), milled.findings.end(), [&](const auto& f) { return f.rule == rule; });
        EXPECT_NE(found, milled.findings.end()) << rule;
        return found == milled.findings.end() ? -1.0 : found->measured;
    }
    std::unique_ptr<pipeline::DesignedPart> design_;
    std::unique_ptr<PartExport> out_;
    std::vector<toolpath::Program> programs_;
    bool broken_ = false;
};

void keep(std::string&) {}

/// Tells the program another diameter than that of its cutter, 3 mm.
std::function<void(std::string&)> with_cutter(const std::string& diameter) {
    return [diameter](std::string& text) { text = std::regex_replace(text, std::regex("#<cutter> = 3.00000"), "#<cutter> = " + diameter); };
}

/// Moves every cut along Z [mm].
std::function<void(std::string&)> raised(double by) {
    return [by](std::string& text) {
        std::string moved;
        const std::regex word("(G1 A.* Z)([-.0-9]+)");
        auto begin = text.cbegin();
        for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
            moved.append(begin, (*it)[2].first);
            moved += fmt::format("{:.5f}", std::stod((*it)[2].str()) + by);
            begin = (*it)[2].second;
        }
        text = moved.append(begin, text.cend());
    };
}

// The cutter is 0.4 mm wider than the program knows: it cuts half of that into the floor, less the cell of 0.15 mm that is allowed for.
TEST_F(MillCheck, FindsWhatAHalfPlateLosesToAWiderCutter) {
    plan(cam::PartKind::kSeries);
    const auto good = simulated(keep);
    EXPECT_FALSE(broken_);
    EXPECT_LE(good[0], 0.02);
    EXPECT_LE(good[1], 0.02);
    const auto wide = simulated(with_cutter("2.60000"));
    EXPECT_TRUE(broken_);
    EXPECT_GT(wide[0], 0.05);
    EXPECT_LE(wide[1], 0.02);
    const auto narrow = simulated(with_cutter("4.00000"));
    EXPECT_TRUE(broken_);
    EXPECT_GT(narrow[1], 0.1);
}

TEST_F(MillCheck, FindsAWrappedGrooveThatIsTooDeepOrTooShallow) {
    plan(cam::PartKind::kParallel);
    const auto good = simulated(keep);
    EXPECT_FALSE(broken_);
    EXPECT_LE(good[0], 0.02);
    const auto deep = simulated(raised(-0.5));
    EXPECT_TRUE(broken_);
    EXPECT_GT(deep[0], 0.1);
    const auto shallow = simulated(raised(0.5));
    EXPECT_TRUE(broken_);
    EXPECT_GT(shallow[1], 0.1);
}

}  // namespace
}  // namespace fusee::formats
