#include "fusee/solid/mesh.h"

#include <gtest/gtest.h>

namespace fusee::solid {
namespace {

using Triangles = std::vector<Triangle>;
const Triangles kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(IsClosedAndOriented, ATetrahedronIs) { EXPECT_TRUE(is_closed_and_oriented(kTetrahedron)); }

TEST(IsClosedAndOriented, OneWithAFaultIsNot) {
    Triangles open = kTetrahedron, turned = kTetrahedron, thin = kTetrahedron, twice = kTetrahedron;
    open.pop_back();
    std::swap(turned[1][0], turned[1][1]);
    thin.push_back({0, 1, 1});
    twice.insert(twice.end(), kTetrahedron.begin(), kTetrahedron.end());  // four triangles on each edge
    for (const Triangles& triangles : {open, turned, thin, twice}) EXPECT_FALSE(is_closed_and_oriented(triangles));
}

}  // namespace
}  // namespace fusee::solid
