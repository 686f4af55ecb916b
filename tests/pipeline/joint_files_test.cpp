#include <algorithm>
#include <cmath>
#include <memory>

#include "fusee/assembly/motion.h"
#include "fusee/checks/support.h"
#include "fusee/core/folder.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/mesh_file.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/pipeline/make.h"
#include "fusee/profile/profile.h"
#include "long_form.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

/// A shipped joint with holes for its cables, both springs and a pulley for its whole range, made once, and its bodies as meshes in the
/// assembly's frame.
class WholeJoint : public testing::TestWithParam<std::string> {
protected:
    struct Made {
        std::shared_ptr<core::TemporaryFolder> folder;  // tests of one design run side by side
        MadeDesign design;
        std::vector<exchange::StepBody> solids;
        std::map<std::string, solid::Mesh> bodies;  // by the names of their STL files
    };
    static const Made& made() {
        static std::map<std::string, Made> all;
        const auto known = all.find(GetParam());
        return known != all.end() ? known->second : all.emplace(GetParam(), make(GetParam())).first->second;
    }
    static std::vector<exchange::NamedMesh> meshes() {
        const assembly::Assembly& joint = *made().design.report.assembly;
        std::vector<exchange::NamedMesh> all;
        for (const assembly::Body& body : joint.bodies) {
            solid::Mesh mesh = body.mesh();
            for (solid::Vec3& p : mesh.points_mm) {
                const Eigen::Vector3d at = placement(joint, body, {}) * Eigen::Vector3d(p[0], p[1], p[2]);
                p = {at.x(), at.y(), at.z()};
            }
            all.push_back({body.name, std::move(mesh)});
        }
        return all;
    }

private:
    static Made make(const std::string& name) {
        const std::string text =
            fixtures::with_keys(core::read_file(fixtures::shipped(name)), {{"outputs.formats", R"(["step", "3mf", "stl", "dxf"])"}});
        const profile::Profile profile = profile::parse_profile(text, fixtures::shipped(name));
        Made once{std::make_shared<core::TemporaryFolder>(), {}, {}, {}};
        core::OutputFolder output(once.folder->path() / name, {.command = "make", .source = profile.file});
        once.design = make_parts(profile, output).value();
        once.solids = exchange::read_step_assembly(output.path() / "assembly.step");
        fs::copy_file(output.path() / "assembly.3mf", once.folder->path() / "assembly.3mf");
        fs::copy_file(output.path() / "frame_plate.dxf", once.folder->path() / "frame_plate.dxf");
        for (const char* body :
             {"capstan", "capstan_mirrored", "k_pe_seat", "k_pe_cap_mirrored", "joint_pulley", "frame_plate", "frame_front", "frame_rear"})
            once.bodies[body] = exchange::read_mesh_file(output.path() / (std::string(body) + ".stl")).mesh;
        return once;
    }
};

// Planar cams, of which K_PE is overhung; and a helix.
INSTANTIATE_TEST_SUITE_P(Shipped, WholeJoint,
                         testing::ValuesIn(fixtures::some_of<std::string>({"pnrvsa", "first_prototype", "paper/new_cams"}, 2)),
                         [](const auto& one) { return fs::path(one.param).filename().string(); });

void expect_same(const solid::Box& a, const solid::Box& b, double within_mm) {
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(a.low_mm[k], b.low_mm[k], within_mm);
        EXPECT_NEAR(a.high_mm[k], b.high_mm[k], within_mm);
    }
}

// Meshes keep circles within 0.02 mm: 1.3 % of the area at the least radius of 2 mm, and 0.02 mm of the box. Cams are finer.
TEST_P(WholeJoint, StepFileHoldsEveryBodyInItsPlace) {
    const auto expected = meshes();
    ASSERT_EQ(made().solids.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const exchange::StepBody& body = made().solids[i];
        SCOPED_TRACE(body.name);
        EXPECT_EQ(body.name, expected[i].name);
        const bool cam = made().design.report.assembly->bodies[i].cam != nullptr;
        EXPECT_NEAR(body.volume_mm3 / solid::volume_mm3(expected[i].mesh), 1.0, cam ? 5e-4 : 0.015);
        expect_same(body.box, solid::bounding_box(expected[i].mesh), 0.021);
    }
}

TEST_P(WholeJoint, EachBodyIsOneSolidButForPiecesOfOneName) {
    const auto expected = [](const std::string& name) {
        const std::string of = name.substr(0, name.rfind('_'));
        return of == "rods" || name == "joint_stops" || of == "capstan_stops" ? 2U
               : of == "axle_rings"                                           ? 3U
               : of == "bushes"                                               ? 4U
               : name == "bearings"                                           ? 6U
               : name == "k_pe_posts"                                         ? 2U
                                                                              : 1U;
    };
    for (const exchange::StepBody& body : made().solids) EXPECT_EQ(body.solids, expected(body.name)) << body.name;
}

// Bodies that touch by design (an axle in its bore, a spring on its plate) have no volume in common.
TEST_P(WholeJoint, NoTwoSolidsInterfere) {
    for (const exchange::Interference& found : exchange::interferences(made().solids, 1e-3))
        ADD_FAILURE() << found.a << " and " << found.b << " share " << found.common_mm3 << " mm^3";
}

TEST_P(WholeJoint, ThreeMfHoldsTheSameBodies) {
    const auto expected = meshes();
    const auto objects = exchange::read_3mf_objects(made().folder->path() / "assembly.3mf");
    ASSERT_EQ(objects.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        SCOPED_TRACE(expected[i].name);
        EXPECT_EQ(objects[i].name, expected[i].name);
        EXPECT_EQ(objects[i].mesh.triangles, expected[i].mesh.triangles);
        expect_same(solid::bounding_box(objects[i].mesh), solid::bounding_box(expected[i].mesh), 1e-4);  // single precision
    }
}

/// Files to print: as large as the body of the assembly, outward, on both sides.
TEST_P(WholeJoint, BodiesToMakeAreFiles) {
    for (const auto& [name, mesh] : made().bodies) {
        const bool mirrored = name.ends_with("_mirrored"), both = name == "joint_pulley" || name.starts_with("frame_");
        const std::string body = both ? name : (mirrored ? name.substr(0, name.size() - 9) + "_antagonist" : name + "_agonist");
        const assembly::Body* drawn = made().design.report.assembly->find(body);
        ASSERT_NE(drawn, nullptr) << body;
        EXPECT_NEAR(solid::volume_mm3(mesh) / solid::volume_mm3(drawn->mesh()), 1.0, 1e-5) << name;  // single precision
        EXPECT_GT(solid::volume_mm3(mesh), 0.0);
    }
}

/// Discs and brackets lie flat: on edge, or on the end of the longer leg, they would stand on supports.
TEST_P(WholeJoint, BodiesToMakeLieOnTheBed) {
    for (const char* name : {"k_pe_cap_mirrored", "k_pe_seat", "frame_front"}) {
        const solid::Box box = solid::bounding_box(made().bodies.at(name));
        const auto size = [&](std::size_t k) { return box.high_mm[k] - box.low_mm[k]; };
        EXPECT_LE(size(2), std::min(size(0), size(1))) << name;
    }
    EXPECT_EQ(checks::unsupported_mm2(made().bodies.at("k_pe_cap_mirrored"), core::rad_from_deg(45.0), false), 0.0);
}

TEST_P(WholeJoint, ThePlateIsDrilledByItsDrawing) {
    const exchange::DxfDrawing drawing = exchange::read_dxf(made().folder->path() / "frame_plate.dxf");
    const auto& holes = made().design.report.assembly->frame_holes;
    std::size_t drawn = 0;
    for (const exchange::DxfLayer& layer : drawing.layers)
        for (const exchange::DxfCircle& circle : layer.circles) {
            ++drawn;
            EXPECT_TRUE(std::any_of(holes.begin(), holes.end(), [&](const assembly::FrameHole& hole) {
                return std::hypot(hole.x_mm - circle.centre_mm[0], hole.y_mm - circle.centre_mm[1]) < 1e-9 &&
                       std::abs(hole.diameter_mm - 2.0 * circle.radius_mm) < 1e-9;
            })) << layer.name;
        }
    EXPECT_EQ(drawn, holes.size());
    ASSERT_NE(drawing.layer("OUTLINE"), nullptr);
    EXPECT_FALSE(drawing.layer("OUTLINE")->arcs.empty());
}

TEST_P(WholeJoint, TheReportListsItsFiles) {
    const auto& files = made().design.report.files;
    for (const std::string name :
         {"assembly.step", "assembly.3mf", "capstan.stl", "capstan_mirrored.stl", "joint_pulley.stl", "frame_plate.dxf"})
        EXPECT_TRUE(std::any_of(files.begin(), files.end(), [&](const FileRow& row) { return row.entry.name == name; })) << name;
}

}  // namespace
}  // namespace fusee::pipeline
