#include <algorithm>
#include <nlohmann/json.hpp>

#include "fusee/batch/batch.h"
#include "fusee/checks/support.h"
#include "fusee/core/units.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/readback/readback.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

class OnePlate : public fixtures::TempFolder {
protected:
    [[nodiscard]] batch::MakeResult made(const fixtures::Changes& changes) const {
        auto text = fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "outputs.formats", R"(["3mf"])");
        text = fixtures::with_keys(text,
                                   {{"k_se.target_rows", "200"}, {"k_pe.target_rows", "200"}, {"tolerances.chordal_error_mm", "0.0025"}});
        return batch::make(profile::read_profile(write("pnrvsa.toml", fixtures::with_keys(text, changes))), {.out = folder_ / "out"});
    }
    [[nodiscard]] static const core::Finding* bed(const batch::MakeResult& result) {
        const auto found =
            std::find_if(result.findings.begin(), result.findings.end(), [](const auto& f) { return f.rule == "plate.bed"; });
        return found == result.findings.end() ? nullptr : &*found;
    }
};

TEST_F(OnePlate, HoldsEveryPartApartAndEachCarriesItsLaw) {
    const batch::MakeResult result = made({});
    ASSERT_TRUE(result.made);
    const exchange::Plate plate = exchange::read_plate_file(result.folder / "plate.json");
    const auto objects = exchange::read_3mf_objects(result.folder / "plate.3mf");
    ASSERT_EQ(objects.size(), 4u);
    const std::vector<std::string> names{"k_se", "k_se_mirrored", "k_pe", "k_pe_mirrored"};
    std::vector<solid::Box> boxes;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(objects[i].name, names[i]);
        const solid::Box box = solid::bounding_box(objects[i].mesh);
        EXPECT_NEAR(box.low_mm[2], 0.0, 1e-5) << "on the bed";
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_GE(box.low_mm[k], -1e-5);
            EXPECT_LE(box.high_mm[k], 200.0);
        }
        for (const solid::Box& other : boxes) {
            const double x = std::max(box.low_mm[0] - other.high_mm[0], other.low_mm[0] - box.high_mm[0]);
            const double y = std::max(box.low_mm[1] - other.high_mm[1], other.low_mm[1] - box.high_mm[1]);
            EXPECT_GE(std::max(x, y), 10.0 - 1e-4) << "supports reach 4 mm beyond each part";
        }
        boxes.push_back(box);
    }
    const auto errors = readback::read_back_plate(result.folder, plate);
    ASSERT_EQ(errors.size(), 4u);
    for (const readback::ArmError& e : errors) EXPECT_LE(e.worst_relative, 1e-3) << e.reader;
    const auto report = nlohmann::json::parse(core::read_file(result.folder / "report.json"));
    EXPECT_EQ(report["plate"].size(), 4u);
    EXPECT_EQ(bed(result), nullptr);
}

/// Area of the faces that lie flat at the lowest and at the highest height [mm^2].
std::pair<double, double> flat_areas(const solid::Mesh& mesh) {
    const solid::Box box = solid::bounding_box(mesh);
    std::pair<double, double> areas{0.0, 0.0};
    for (const solid::Triangle& t : mesh.triangles) {
        const auto &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]], &c = mesh.points_mm[t[2]];
        const double area = 0.5 * std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        const auto all_at = [&](double z) { return std::max({std::abs(a[2] - z), std::abs(b[2] - z), std::abs(c[2] - z)}) < 1e-3; };
        if (all_at(box.low_mm[2])) areas.first += area;
        if (all_at(box.high_mm[2])) areas.second += area;
    }
    return areas;
}

// K_PE is overhung on its boss: upright it would stand on the boss alone, and its whole flange would need support.
TEST_F(OnePlate, PartsStandTheWayUpThatNeedsLessSupport) {
    const batch::MakeResult result = made({});
    ASSERT_TRUE(result.made);
    const exchange::Plate plate = exchange::read_plate_file(result.folder / "plate.json");
    const auto objects = exchange::read_3mf_objects(result.folder / "plate.3mf");
    ASSERT_EQ(objects.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const bool overhung = objects[i].name.starts_with("k_pe");
        EXPECT_EQ(plate.objects[i].flipped, overhung) << objects[i].name;
        const double overhang = core::rad_from_deg(45.0), here = checks::unsupported_mm2(objects[i].mesh, overhang, false),
                     turned = checks::unsupported_mm2(objects[i].mesh, overhang, true);
        EXPECT_LE(here, turned) << objects[i].name;
        const auto found = std::find_if(result.findings.begin(), result.findings.end(), [&](const core::Finding& f) {
            return f.rule == "fdm.support" && objects[i].name.starts_with(f.where);
        });
        if (found != result.findings.end()) {
            EXPECT_NEAR(here, found->measured, 0.01 * found->measured) << objects[i].name;
        }
        const auto [bed, top] = flat_areas(objects[i].mesh);
        if (!overhung) continue;
        EXPECT_GT(bed, 3.0 * top) << objects[i].name << " stands on its boss";
        EXPECT_GT(bed, 500.0) << objects[i].name;
    }
}

// What the suggestion names holds them.
TEST_F(OnePlate, TooSmallABedIsToReviewWithTheOneThatHolds) {
    const batch::MakeResult result = made({{"process.build_mm", "[60.0, 60.0, 60.0]"}});
    ASSERT_TRUE(result.made) << "each part fits alone";
    EXPECT_FALSE(std::filesystem::exists(result.folder / "plate.3mf"));
    ASSERT_NE(bed(result), nullptr);
    EXPECT_EQ(bed(result)->severity, core::Severity::kWarning);
    EXPECT_GT(bed(result)->measured, 60.0);
    const std::string side = std::to_string(bed(result)->measured);
    EXPECT_EQ(bed(made({{"process.build_mm", "[" + side + ", " + side + ", 60.0]"}})), nullptr);
}

TEST_F(OnePlate, IsLeftOutWithoutItsKeyOrItsFormat) {
    for (const auto& change : {std::pair<std::string, std::string>{"outputs.plate", "false"}, {"outputs.formats", R"(["stl"])"}}) {
        const batch::MakeResult result = made({change});
        ASSERT_TRUE(result.made);
        EXPECT_FALSE(std::filesystem::exists(result.folder / "plate.3mf")) << change.first;
    }
    const batch::MakeResult one_side = made({{"outputs.pair", "false"}});
    EXPECT_EQ(exchange::read_3mf_objects(one_side.folder / "plate.3mf").size(), 2u);
}

}  // namespace
}  // namespace fusee::pipeline
