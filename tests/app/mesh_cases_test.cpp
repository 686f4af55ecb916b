#include <gtest/gtest.h>

#include "app/run.h"

// Meshes of other people that were judged wrongly, from ../shared/cases beside the repository.
namespace fusee::app {
namespace {

struct MeshCase {
    const char* file;
    int code;
    std::vector<std::string> said, not_said;
};
void PrintTo(const MeshCase& c, std::ostream* out) { *out << c.file; }

class MeshCases : public Program, public testing::WithParamInterface<MeshCase> {};

TEST_P(MeshCases, AreRight) {
    const MeshCase& c = GetParam();
    const fs::path file = fs::path(FUSEE_SOURCE_DIR).parent_path() / "shared/cases" / c.file;
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there: not tried";
    const Ended ended = run("check '" + file.string() + "' --process fdm");
    EXPECT_EQ(ended.code, c.code) << ended.all();
    for (const std::string& words : c.said) EXPECT_NE(ended.all().find(words), std::string::npos) << words << " in\n" << ended.all();
    for (const std::string& words : c.not_said) EXPECT_EQ(ended.all().find(words), std::string::npos) << words << " in\n" << ended.all();
}

INSTANTIATE_TEST_SUITE_P(Shared, MeshCases,
                         testing::Values(
                             // 0.9 mm by construction: enough for FDM, thin if it carries load.
                             MeshCase{
                                 "mesh_walls/fb_0.9.stl", 0, {"warning: mesh.wall", "measured 0.90"}, {"mesh.rib", "mesh.feather_edge"}},
                             MeshCase{"mesh_walls/fb_1.5.stl", 0, {}, {"mesh.rib", "mesh.wall", "mesh.feather_edge"}},
                             // The edge of 60 deg is no wall; the step of 0.96 mm beside it is one.
                             MeshCase{"mesh_walls/test_lever_100mm_single.stl", 0, {"measured 0.9"}, {"mesh.rib", "error:"}},
                             MeshCase{"mesh_bodies/block_far.stl", 0, {"body 2 of 20.00 x 20.00 x 20.00 mm"}, {"mesh.rib"}},
                             MeshCase{"mesh_bodies/plate_and_block.stl", 0, {"body 1 of 40.00 x 20.00 x 2.00 mm"}, {"mesh.rib"}}));

}  // namespace
}  // namespace fusee::app
