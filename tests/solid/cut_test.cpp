#include <gtest/gtest.h>

#include "fusee/solid/cutters.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/validity.h"
#include "local_cut.h"

namespace fusee::solid {
namespace {

const Ring kCutSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(Cut, TakesAwayEveryTool) {
    const Mesh body = prism(kCutSquare, 0.0, 2.0);
    const Mesh through = prism(ring_of(circle(0.5, {1.0, 1.0}), 1e-3), -1.0, 3.0),
               pocket = prism(ring_of(circle(0.5, {3.0, 3.0}), 1e-3), 1.0, 3.0);
    const auto result = cut(body, {through, pocket});
    ASSERT_TRUE(result);
    EXPECT_TRUE(validate(*result).good()) << validate(*result).line();
    EXPECT_NEAR(volume_mm3(*result), 32.0 - 0.5 * volume_mm3(through) - 0.5 * volume_mm3(pocket), 1e-9);
}

Mesh box(double low, double high, double z_low, double z_high) {
    return prism({{low, low}, {high, low}, {high, high}, {low, high}}, z_low, z_high);
}

// Two ways to one solid: with the triangles near the tool, and wholly. The second tool cuts what the first one left.
TEST(LocalCut, GivesTheSolidOfTheWholeCut) {
    const Mesh body = prism(ring_of(circle(10.0), 1e-3), 0.0, 2.0);
    const std::vector<Mesh> tools{prism(ring_of(circle(0.5, {3.0, 1.0}), 1e-3), 1.0, 3.0),
                                  prism(ring_of(circle(0.5, {3.5, 1.0}), 1e-3), -1.0, 3.0),
                                  prism(ring_of(circle(1.0, {10.0, 0.0}), 1e-3), -1.0, 1.5)};
    const auto near = cut_locally(body, tools);
    ASSERT_TRUE(near);
    const Validity validity = validate(*near);
    EXPECT_TRUE(validity.good()) << validity.line();
    const auto all = cut(body, tools);
    ASSERT_TRUE(all);
    EXPECT_NEAR(volume_mm3(*near), volume_mm3(*all), 1e-9);
    double left = volume_mm3(body);  // one after the other
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const double now = volume_mm3(cut_locally(body, {tools.begin(), tools.begin() + static_cast<std::ptrdiff_t>(i) + 1}).value());
        EXPECT_LT(now, left - 0.1) << i;
        left = now;
    }
}

// Known by hand: a pocket in an edge, in a corner, and one that leaves a wall; a quarter, an eighth and so on of the tool remains.
TEST(LocalCut, CutsEdgesAndCorners) {
    const Mesh body = box(0.0, 4.0, 0.0, 4.0);
    const Mesh edge = prism({{-1.0, 1.3}, {1.0, 1.3}, {1.0, 2.3}, {-1.0, 2.3}}, 3.5, 4.5);
    const Mesh corner = prism({{3.5, 3.6}, {4.5, 3.6}, {4.5, 4.6}, {3.5, 4.6}}, 3.7, 4.5);
    EXPECT_NEAR(volume_mm3(cut_locally(body, {edge}).value()), 64.0 - 1.0 * 1.0 * 0.5, 1e-12);
    EXPECT_NEAR(volume_mm3(cut_locally(body, {corner}).value()), 64.0 - 0.5 * 0.4 * 0.3, 1e-12);
    EXPECT_NEAR(volume_mm3(cut_locally(body, {edge, corner}).value()), 64.0 - 0.5 - 0.06, 1e-12);
}

// In a reflex edge of the body the tool's faces begin inside the body above one of its two faces.
TEST(LocalCut, CutsAReflexEdge) {
    const Mesh block = box(0.0, 4.0, 0.0, 2.0);
    const Mesh stepped = cut(block, {prism({{2.0, -1.0}, {5.0, -1.0}, {5.0, 5.0}, {2.0, 5.0}}, 1.0, 3.0)}).value();
    const Mesh hole = prism({{1.5, 1.5}, {2.5, 1.5}, {2.5, 2.5}, {1.5, 2.5}}, 0.5, 3.0);
    const auto left = cut_locally(stepped, {hole});
    ASSERT_TRUE(left);
    EXPECT_TRUE(validate(*left).good()) << validate(*left).line();
    EXPECT_NEAR(volume_mm3(*left), 24.0 - 0.5 * 1.5 - 0.5 * 0.5, 1e-12);
}

TEST(LocalCut, LeavesToTheWholeCutWhatItCannotDecide) {
    const Mesh body = box(0.0, 4.0, 0.0, 4.0);
    const Mesh most = prism({{-1.0, -1.0}, {7.0, -1.0}, {-1.0, 7.0}}, -1.0, 5.0);  // but the prism beyond x + y = 6
    EXPECT_FALSE(cut_locally(body, {box(1.0, 3.0, 1.0, 3.0)})) << "a hollow: no common curve";
    EXPECT_FALSE(cut_locally(body, {most})) << "no triangle is left as a border";
    EXPECT_NEAR(volume_mm3(cut(body, {most}).value()), 8.0, 1e-12);
    EXPECT_NEAR(volume_mm3(cut(body, {box(1.0, 3.0, 1.0, 3.0)}).value()), 64.0 - 8.0, 1e-12);
    EXPECT_FALSE(cut_locally(body, {box(5.0, 6.0, 0.0, 1.0)})) << "beside the body";
}

TEST(Cut, WithoutToolsIsTheBodyItself) {
    const Mesh body = prism(kCutSquare, 0.0, 2.0);
    EXPECT_EQ(cut(body, {})->triangles, body.triangles);
}

TEST(Cut, GivesNothingForABodyThatIsNoManifold) {
    Mesh broken = prism(kCutSquare, 0.0, 2.0);
    broken.triangles.push_back(broken.triangles.front());
    EXPECT_FALSE(cut(broken, {prism(ring_of(circle(0.5, {1.0, 1.0}), 1e-3), -1.0, 3.0)}));
}

}  // namespace
}  // namespace fusee::solid
