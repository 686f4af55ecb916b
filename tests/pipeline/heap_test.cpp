#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "fusee/pipeline/design.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

/// Holes of random sizes in this thread's memory: what is laid out next comes to addresses in another order each time.
std::vector<std::unique_ptr<char[]>> torn_memory(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::unique_ptr<char[]>> blocks(20000);
    for (auto& block : blocks) block = std::make_unique<char[]>(16 + random() % 300);
    for (auto& block : blocks)
        if (random() % 2 == 0) block.reset();
    return blocks;
}

// CGAL numbers what a cut adds by address. At this chordal error a key's corner lies within 0.1 um of a facet's, so that one of two ends
// has to go.
TEST(HeapTest, TheSameMeshWhereverItsMemoryLies) {
    const profile::Profile profile =
        profile::parse_profile(fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "tolerances.chordal_error_mm", "0.003"),
                               fixtures::shipped("pnrvsa"));
    const auto designed = design_part(cam::PartKind::kSeries, *resolve(profile));
    ASSERT_TRUE(designed);
    for (unsigned seed = 0; seed < 8; ++seed)
        std::thread([&] {
            const auto memory = torn_memory(seed);
            const auto again = solid::build_part(designed->part.cam, designed->part.options);
            ASSERT_TRUE(again);
            ASSERT_EQ(again->mesh.points_mm, designed->part.mesh.points_mm) << seed;
            ASSERT_EQ(again->mesh.triangles, designed->part.mesh.triangles) << seed;
        }).join();
}

}  // namespace
}  // namespace fusee::pipeline
