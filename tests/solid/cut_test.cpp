#include "fusee/solid/cut.h"

#include <gtest/gtest.h>

#include "fusee/solid/fill.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/validity.h"

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
