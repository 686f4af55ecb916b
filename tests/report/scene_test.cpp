#include "scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "fusee/actuator/equilibrium.h"
#include "fusee/checks/along.h"
#include "fusee/core/text.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/profile/profile.h"
#include "fusee/report/assembly.h"
#include "fusee/report/diagnosis.h"
#include "page_structure.h"
#include "pipeline/fixture.h"
#include "report/diagnosis_fixture.h"
#include "scene/poses.h"

namespace fusee::report {
namespace {

/// pnrvsa with its assembly, made once.
const DesignReport& pnrvsa() {
    static const DesignReport made = [] {
        auto design = pipeline::make_figures(profile::read_profile(fixtures::shipped("pnrvsa"))).value();
        const auto& profile = design.resolved.profile;
        DesignReport report = design.report;
        report.law.samples = spring::sample_by_load(*design.resolved.law(), 61);
        report.dead_band = actuator::dead_band_curve(report.actuator, 21);
        auto assembly =
            assembly::assemble({report.parts[0].part, report.parts[1].part, profile.k_se.spring, profile.k_pe.spring, profile.cable},
                               profile.rig.capstan_radius, profile.rig.joint_radius, profile.assembly);
        report.assembly = std::make_shared<const assembly::Assembly>(std::move(assembly).value());
        return report;
    }();
    return made;
}

const assembly::Assembly& joint() { return *pnrvsa().assembly; }

const nlohmann::json& scene() {
    static const nlohmann::json json = nlohmann::json::parse(scene_json(pnrvsa()));
    return json;
}

const PoseGrid& grid() {
    static const PoseGrid made = pose_grid(joint(), pnrvsa().actuator).value();
    return made;
}

/// 4 x 4, by columns.
Eigen::Matrix4d matrix_of(const nlohmann::json& json) { return Eigen::Map<const Eigen::Matrix4d>(json.get<std::vector<double>>().data()); }

double largest_move_mm(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b) {  // of a point within 100 mm
    return (a - b).topLeftCorner<3, 3>().cwiseAbs().maxCoeff() * 100.0 + (a - b).topRightCorner<3, 1>().norm();
}

TEST(Scene, ADiagnosisCarriesTheJointWhereItNamesEffects) {
    diagnosis::Diagnosis d = diagnosis();
    d.verdict = diagnosis::VerdictKind::kIdentified;
    const std::string page = diagnosis_html(d, "", joint_scene(pnrvsa()));
    EXPECT_LT(page.size(), 2u << 20);
    EXPECT_EQ(data_of(page, "joint-scene"), scene());
    d.effects.clear();
    d.alternatives.clear();
    EXPECT_TRUE(data_of(diagnosis_html(d, "", joint_scene(pnrvsa())), "joint-scene").is_null()) << "nothing to mark";
    EXPECT_TRUE(data_of(diagnosis_html(diagnosis()), "joint-scene").is_null()) << "no profile";
}

TEST(ScenePoses, BodiesStandWhereTheAssemblyPutsThem) {
    for (const auto& pose : {assembly::Pose{}, assembly::pose_of(joint(), 0.6, 0.9, 0.2), assembly::pose_of(joint(), 1.1, 0.8, -0.15)})
        for (const assembly::Body& body : joint().bodies) {
            const Eigen::Isometry3d here = placement(body, follows(joint(), body), channels_of(joint(), pose));
            EXPECT_LT(largest_move_mm(here.matrix(), assembly::placement(joint(), body, pose).matrix()), 1e-9) << body.name;
        }
}

TEST(ScenePoses, TheJsonHoldsTheGridsPoses) {
    const nlohmann::json& rows = scene()["grid"]["rows"];
    ASSERT_EQ(rows.size(), grid().tau.size());
    for (const std::size_t i : {std::size_t{0}, rows.size() / 2, rows.size() - 1})
        for (std::size_t j = 0; j < grid().share.size(); ++j) {
            const auto pose = resting_pose(joint(), pnrvsa().actuator, grid().tau[i], grid().share[j] * grid().most[i]);
            ASSERT_TRUE(pose);
            const ChannelValues values = channels_of(joint(), pose_from(rows[i][j].get<PoseValues>()));
            for (std::size_t b = 0; b < joint().bodies.size(); ++b) {
                const nlohmann::json& body = scene()["bodies"][b];
                const auto angle = [&](const char* key) { return body[key] < 0 ? 0.0 : values[body[key].get<std::size_t>()]; };
                const auto direction = body["direction"].get<std::vector<double>>();
                Eigen::Isometry3d at(matrix_of(body["rest"]));
                at.rotate(Eigen::AngleAxisd(body["gain"].get<double>() * angle("turn"), Eigen::Vector3d::UnitZ()));
                at.pretranslate(angle("slide") * Eigen::Vector3d(direction[0], direction[1], direction[2]));
                const Eigen::Matrix4d exact = assembly::placement(joint(), joint().bodies[b], *pose).matrix();
                EXPECT_LT(largest_move_mm(at.matrix(), exact), 0.005) << body["name"];  // rounded to 1e-5 rad and mm
            }
        }
}

TEST(ScenePoses, RestWithoutJointTorqueIsTheLawsAngle) {
    for (std::size_t i = 0; i < grid().tau.size(); ++i) {
        const ChannelValues rest = channels_of(joint(), pose_from(grid().rows[i][grid().share.size() / 2]));
        EXPECT_NEAR(rest[kTurnAgonist], pnrvsa().actuator.law->at_load(grid().tau[i]).theta, 1e-6);
        EXPECT_NEAR(rest[kTurnAntagonist], rest[kTurnAgonist], 1e-9);
        EXPECT_NEAR(rest[kJointAngle], 0.0, 1e-9);
    }
}

TEST(ScenePoses, OppositeTorquesMirrorTheSides) {
    for (const std::vector<PoseValues>& level : grid().rows) {
        const ChannelValues low = channels_of(joint(), pose_from(level.front())), high = channels_of(joint(), pose_from(level.back()));
        EXPECT_NEAR(low[kJointAngle], -high[kJointAngle], 1e-6);
        EXPECT_NEAR(low[kSpoolAgonist], high[kSpoolAntagonist], 1e-5);
        EXPECT_GT(high[kJointAngle], 0.0);
    }
}

TEST(ScenePoses, TheStatedErrorBoundsTheInterpolation) {
    EXPECT_GT(grid().error_rad, 0.0);
    EXPECT_LT(core::deg_from_rad(grid().error_rad), 1.0);
    EXPECT_LT(grid().error_mm, 0.5);
    EXPECT_DOUBLE_EQ(scene()["grid"]["error_deg"].get<double>(), core::deg_from_rad(grid().error_rad));
}

TEST(PackedMeshes, ComeBackWithinHalfAStep) {
    for (const assembly::Body& body : joint().bodies) {
        const solid::Mesh mesh = body.mesh();
        const PackedMesh small = packed(mesh);
        EXPECT_LT(small.error_mm(), 0.02) << body.name;
        const std::string points = core::from_base64(small.points), triangles = core::from_base64(small.triangles);
        ASSERT_EQ(points.size(), 6 * mesh.points_mm.size());
        ASSERT_EQ(triangles.size(), (small.wide ? 12 : 6) * mesh.triangles.size());
        const auto byte = [](const std::string& text, std::size_t at) {
            return static_cast<unsigned>(static_cast<unsigned char>(text[at]));
        };
        double worst = 0.0;
        for (std::size_t i = 0; i < mesh.points_mm.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const unsigned count = byte(points, 6 * i + 2 * k) + 256 * byte(points, 6 * i + 2 * k + 1);
                worst = std::max(worst, std::abs(small.low_mm[k] + count * small.step_mm[k] - mesh.points_mm[i][k]));
            }
        EXPECT_LE(worst, small.error_mm() * (1.0 + 1e-9)) << body.name;
        const std::size_t size = small.wide ? 4 : 2;
        unsigned last = 0;
        for (std::size_t k = size; k-- > 0;) last = 256 * last + byte(triangles, triangles.size() - size + k);
        EXPECT_EQ(last, mesh.triangles.back()[2]);
    }
}

TEST(Scene, ShowsEveryBodyWithAMeshOrCoils) {
    ASSERT_EQ(scene()["bodies"].size(), joint().bodies.size());
    for (const nlohmann::json& body : scene()["bodies"])
        EXPECT_TRUE(!body["coil"].is_null() || scene()["meshes"].contains(body["mesh"])) << body;
    EXPECT_EQ(scene()["cables"].size(), 6u);
}

TEST(Scene, CablesPassTheEndsOfFreeLengths) {
    const auto free = assembly::free_cables(joint(), {});
    const auto at = [](const nlohmann::json& node) { return Eigen::Vector3d(node["at_mm"][0], node["at_mm"][1], node["at_mm"][2]); };
    const nlohmann::json& series = scene()["cables"][1];
    EXPECT_LT((at(series["nodes"][0]) - free[1].to_mm).norm(), 1e-4);
    EXPECT_LT((at(series["nodes"][1]) - free[2].to_mm).norm(), 1e-4);
    EXPECT_NEAR(series["arc"]["radius_mm"].get<double>(), joint().joint_radius_mm, 1e-4);
    EXPECT_NEAR(scene()["cables"][0]["arc"]["radius_mm"].get<double>(), joint().capstan_radius_mm, 1e-4);
}

TEST(Scene, CamTablesHoldArmTensionAndRules) {
    for (std::size_t p = 0; p < 2; ++p) {
        const nlohmann::json& cam = scene()["cams"][p];
        const PartReport& part = pnrvsa().parts[p];
        const auto& working = part.part->cam.working;
        EXPECT_NEAR(cam["angle_rad"].back().get<double>(), working.back().arm.angle, 1e-5);
        EXPECT_NEAR(cam["arm_mm"].front().get<double>(), 1e3 * working.front().arm.arm, 1e-5);
        EXPECT_NEAR(cam["tension_N"].back().get<double>(), working.back().arm.tension, 1e-5);
        for (const nlohmann::json& rule : cam["rules"]) {  // the worst place of the cam is what the rule found, but for the rows between
            const bool most = rule["bound"] == "at most";
            const auto values = rule["values"].get<std::vector<double>>();
            const double worst = most ? *std::max_element(values.begin(), values.end()) : *std::min_element(values.begin(), values.end());
            const auto found =
                std::find_if(part.findings.begin(), part.findings.end(), [&](const auto& f) { return f.rule == rule["rule"]; });
            ASSERT_NE(found, part.findings.end());
            EXPECT_NEAR(worst, found->measured, 0.02 * std::abs(found->measured) + 1e-5) << rule["rule"];
            EXPECT_EQ(std::count(cam["rules_of_whole_part"].begin(), cam["rules_of_whole_part"].end(), rule["rule"]), 0);
        }
        EXPECT_EQ(cam["rules"].size(), checks::along_cam().size());
    }
}

TEST(JointViewer, IsPartOfAPageBelowTwoMegabytes) {
    const std::string page = report_html(pnrvsa());
    EXPECT_LT(page.size(), 2'000'000u);
    expect_all(page, {"three.js", "uplot"});
    EXPECT_EQ(data_of(page, "joint-scene"), scene());
    EXPECT_EQ(data_of(page, "plan"), assembly_plan(joint()));
    for (const char* loads : {"<script src", "<img src=\"http", "<link", "@import", "url(http"}) EXPECT_FALSE(holds(page, loads)) << loads;
    EXPECT_EQ(page, report_html(pnrvsa()));
}

}  // namespace
}  // namespace fusee::report
