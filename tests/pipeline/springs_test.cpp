#include "fusee/pipeline/springs.h"

#include <array>
#include <cmath>

#include "fusee/pipeline/check.h"
#include "fusee/report/springs.h"
#include "fusee/spring/coil.h"
#include "pipeline/fixture.h"

// Law: found springs have the rate of their coils, the load of the law's beginning and no remark; the profile that takes them can be made.
namespace fusee::pipeline {
namespace {

class Springs : public fixtures::TempFolder {
protected:
    [[nodiscard]] profile::Profile changed(const char* name, const fixtures::Changes& changes) const {
        lay_tables();
        return profile::read_profile(write("changed.toml", fixtures::with_keys(core::read_file(fixtures::shipped(name)), changes)));
    }
    [[nodiscard]] static SpringSearch found(cam::PartKind part, const profile::Profile& profile, const SpringSearchOptions& options = {},
                                            const spring::Catalogue& catalogue = {}) {
        const auto design = resolve(profile);
        EXPECT_TRUE(design);
        const auto search = find_springs(part, *design, catalogue, options);
        EXPECT_TRUE(search);
        return *search;
    }
};

TEST_F(Springs, HaveTheRateOfTheirCoilsAndTheFirstLoad) {
    const profile::Profile p = changed("pnrvsa", {});
    for (const cam::PartKind part : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const spring::BaseSpring& wanted = p.part(part).spring;
        const SpringSearch search = found(part, p);
        ASSERT_FALSE(search.wound.empty()) << report::springs_text(search);
        for (const FoundSpring& f : search.wound) {
            EXPECT_DOUBLE_EQ(spring::rate_of_coils(f.spring), f.spring.rate) << f.name;
            EXPECT_NEAR(f.spring.rate / wanted.rate, 1.0, 0.02) << f.name;
            EXPECT_NEAR(f.spring.rate * f.spring.preload, wanted.rate * wanted.preload, 1e-9 * wanted.rate * wanted.preload) << f.name;
            EXPECT_EQ(std::remainder(f.spring.active_coils, 0.25), 0.0) << f.name;
        }
        for (std::size_t i = 1; i < search.wound.size(); ++i) EXPECT_LE(search.wound[i - 1].volume, search.wound[i].volume);
    }
}

/// A caller that looks at the contours itself gets the same springs in the same order, those without a contour among them.
TEST_F(Springs, WithoutALookAtTheContoursAreTheSameAndMore) {
    const profile::Profile p = changed("pnrvsa", {});
    const SpringSearch with = found(cam::PartKind::kParallel, p, {.most = 50}),
                       all = found(cam::PartKind::kParallel, p, {.most = 1000, .with_cam = false});
    ASSERT_FALSE(with.wound.empty());
    std::size_t at = 0;
    for (const FoundSpring& spring : with.wound) {
        while (at < all.wound.size() && all.wound[at].name != spring.name) ++at;
        ASSERT_LT(at, all.wound.size()) << spring.name;
    }
    EXPECT_GT(all.wound.size(), with.wound.size());
}

TEST_F(Springs, MakeAProfileWithoutErrorsOrOpenRules) {
    const profile::Profile p = changed("first_prototype", {{"k_se.spring.wire_mm", "0"}, {"k_pe.spring.wire_mm", "0"}});
    std::vector<profile::Edit> edits;
    for (const cam::PartKind part : {cam::PartKind::kSeries, cam::PartKind::kParallel})
        for (profile::Edit& edit : spring_edits(part, found(part, p).wound.front(), p)) edits.push_back(std::move(edit));
    const std::string toml = profile::with_edits(core::read_file(p.file), p, edits);
    const Checked checked = check(profile::parse_profile(toml, p.file), std::array{checks::ProcessKind::kFdm});
    const core::Findings all = checked.processes.front().all();
    EXPECT_EQ(core::count(all, core::Severity::kError), 0u);
    EXPECT_EQ(core::count(all, core::Severity::kNotJudged), 0u);
}

TEST_F(Springs, SaysWhichRulesLeaveNone) {
    const SpringSearch search = found(cam::PartKind::kParallel, changed("pnrvsa", {{"k_pe.spring.rod_mm", "40"}}));
    EXPECT_TRUE(search.wound.empty());
    ASSERT_FALSE(search.broken.empty());
    EXPECT_NE(report::springs_text(search).find("none passes; broken or not judged:\n    spring."), std::string::npos)
        << report::springs_text(search);
}

TEST_F(Springs, OfACatalogueComeByTheNearestRate) {
    // 2.25 mm, 18 mm: G d^4/(8 D^3 n) is 7461.9 N/m at 6 turns, 7163.4 at 6.25
    const spring::Catalogue catalogue = spring::parse_catalogue(
        "kind,name,rate,wire_mm,coil_mm,active_coils,free_length_mm,max_deflection,max_load,tensile_strength_MPa\n"
        "compression,far,7163,2.25,18,6.25,48,25,180,1930\ncompression,near,7462,2.25,18,6,46,23.8,177,1930\n"
        "compression,weak,7462,2.25,18,6,46,23.8,177,1000\ncompression,false,7462,2.25,18,9,60,23.8,177,1930\n",
        "shop.csv");
    const SpringSearch search = found(cam::PartKind::kParallel, changed("pnrvsa", {}), {}, catalogue);
    ASSERT_EQ(search.bought.size(), 2u) << report::springs_text(search);
    EXPECT_EQ(search.bought[0].name, "near");
    EXPECT_EQ(search.bought[1].name, "far");
    EXPECT_TRUE(search.bought[0].bought);
}

}  // namespace
}  // namespace fusee::pipeline
