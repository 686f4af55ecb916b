#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fusee/batch/batch.h"
#include "fusee/core/folder.h"
#include "fusee/exchange/part_file.h"
#include "long_form.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

namespace fs = std::filesystem;

class Shipped : public testing::TestWithParam<const char*> {
protected:
    /// A shipped design with its files.
    struct Run {
        std::shared_ptr<core::TemporaryFolder> folder = std::make_shared<core::TemporaryFolder>();
        batch::MakeResult result = batch::make(profile::read_profile(fixtures::shipped(GetParam())), {.out = folder->path() / "out"});
        [[nodiscard]] std::map<std::string, std::string> files() const { return fixtures::contents(folder->path() / "out"); }
    };
    /// The first run of this design, shared by all tests of a process.
    static const Run& first_run() {
        static std::map<std::string, Run> runs;
        return runs[GetParam()];
    }
    static const batch::MakeResult& made() { return first_run().result; }
    /// The names of all files, sorted: every format of both parts on both sides of the joint, DXF of the planar ones, PDF where it is
    /// asked for, the plate and the joint.
    static std::vector<std::string> expected() {
        const std::string design = GetParam();
        std::vector<std::string> names{
            "assembly.3mf",      "assembly.json",     "assembly.md",     "assembly.html",   "assembly.step", "assembly_exploded.svg",
            "assembly_plan.svg", "assembly_view.svg", "bom.csv",         "dead_band.csv",   "plate.3mf",     "plate.json",
            "report.html",       "report.json",       "simulation.html", "simulation.json", "springs.csv"};
        names.insert(names.end(), {"joint_pulley.stl", "frame_plate.stl", "frame_plate.dxf", "frame_front.stl", "frame_rear.stl",
                                   "joint_tower.stl", "k_pe_posts.stl"});
        const auto add_sheet = [&](const std::string& body) {
            names.push_back(body + "_drawing.svg");
            if (design == "pnrvsa") names.push_back(body + "_drawing.pdf");
        };
        for (const char* body : {"frame_plate", "frame_front", "frame_rear", "joint_tower", "k_pe_posts", "joint_pulley"}) add_sheet(body);
        for (const std::string side : {"", "_mirrored"}) {
            for (const std::string body : {"capstan", "carriage", "k_pe_seat", "k_pe_cap"})
                names.push_back(body + side + ".stl"), add_sheet(body + side);
            for (const std::string part : {"k_se", "k_pe"})
                for (const char* ending : {".3mf", ".json", ".scad", ".step", ".stl", "_drawing.svg", "_drawing_2.svg", "_inspection.csv"})
                    names.push_back(part + side + ending);
            names.push_back("k_se" + side + ".dxf");
            if (design != "first_prototype") names.push_back("k_pe" + side + ".dxf");  // its K_PE is a helix
            if (design == "pnrvsa") names.insert(names.end(), {"k_se" + side + "_drawing.pdf", "k_pe" + side + "_drawing.pdf"});
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    /// Files of a part, without its PART.json.
    static std::size_t files_of(const std::string& part) {
        const std::vector<std::string> names = expected();
        return static_cast<std::size_t>(std::count_if(
            names.begin(), names.end(), [&](const auto& name) { return name.starts_with(part + ".") && !name.ends_with(".json"); }));
    }
};
INSTANTIATE_TEST_SUITE_P(Pipeline, Shipped,
                         testing::ValuesIn(fixtures::some_of<const char*>({"pnrvsa", "first_prototype", "measured_table"}, 2)),
                         [](const auto& one) { return std::string(one.param); });

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST_P(Shipped, LeavesEveryFileAndEachIsTheOneStated) {
    const batch::MakeResult& result = made();
    ASSERT_TRUE(result.made);
    EXPECT_EQ(result.folder, first_run().folder->path() / "out" / GetParam());
    const auto files = first_run().files();
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files) names.push_back(fs::path(name).filename().string());
    EXPECT_EQ(names, expected());
    for (const std::string part : {"k_se", "k_pe", "k_se_mirrored", "k_pe_mirrored"}) {
        const exchange::PartFile stated = exchange::read_part_file(result.folder / (part + ".json"));
        EXPECT_EQ(stated.part, part.substr(0, 4));
        EXPECT_GE(stated.target.size(), 200u);
        EXPECT_EQ(stated.files.size(), files_of(part));
        for (const exchange::FileEntry& file : stated.files)
            EXPECT_EQ(core::sha256_hex(core::read_file(result.folder / file.name)), file.sha256) << file.name;
    }
}

// What was asked is what the files hold, by every reader.
TEST_P(Shipped, EveryFileCarriesTheLaw) {
    const batch::MakeResult& result = made();
    EXPECT_GT(result.file_errors.arm, 0.0);
    EXPECT_LE(result.file_errors.arm, 1e-3);
    EXPECT_FALSE(core::any_error(result.findings));
    const auto readings =
        std::count_if(result.findings.begin(), result.findings.end(), [](const core::Finding& f) { return f.rule == "readback.arm"; });
    const int planar = std::string(GetParam()) == "first_prototype" ? 1 : 2;
    // Of both sides: STL twice, 3MF and STEP once for both parts, DXF twice for a planar one; four on the plate; G-code if rs274 is there.
    EXPECT_GE(readings, 2 * (8 + 2 * planar) + 4);
    EXPECT_GT(result.dead_band_peak_deg, 0.0);
}

TEST_P(Shipped, SpringsAreATable) {
    const batch::MakeResult& result = made();
    const auto lines = lines_of(core::read_file(result.folder / "springs.csv"));
    ASSERT_GE(lines.size(), 201u);
    EXPECT_EQ(lines.front(), "tau_Nm,theta_rad,f_se_Nm,f_pe_Nm,s_Nm_per_rad,p_Nm_per_rad,u_se_J,u_pe_J,t");
    for (std::size_t i = 1; i < lines.size(); ++i) {
        std::vector<double> row;
        std::istringstream cells(lines[i]);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
        ASSERT_EQ(row.size(), 9u) << lines[i];
        EXPECT_NEAR(row[2] + row[3], row[0], 1e-9 * row[0]) << "the springs' torques are the load";
        EXPECT_NEAR(row[4] / (row[4] + row[5]), row[8], 1e-12) << "T = S/(S+P)";
    }
}

TEST_P(Shipped, ReportsTellTheSame) {
    const batch::MakeResult& result = made();
    const auto report = nlohmann::json::parse(core::read_file(result.folder / "report.json"));
    EXPECT_EQ(report["name"], GetParam());
    EXPECT_EQ(report["parts"].size(), 2u);
    double worst = 0.0;
    const auto look_at = [&](const auto& readings) {
        for (const auto& reading : readings) {
            EXPECT_EQ(reading["passed"], true);
            worst = std::max(worst, reading["worst_relative"].template get<double>());
        }
    };
    for (const auto* sides : {&report["parts"], &report["mirrored"]})
        for (const auto& part : *sides) look_at(part["read_back"]);
    look_at(report["plate"]);
    EXPECT_DOUBLE_EQ(worst, result.file_errors.arm);
    const std::string page = core::read_file(result.folder / "report.html");
    EXPECT_EQ(page.rfind("<!", 0), 0u);
    EXPECT_EQ(page.find("<script src"), std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos) << "opens offline";
    EXPECT_NE(page.find(GetParam()), std::string::npos);
}

class ShippedTwice : public Shipped {};
INSTANTIATE_TEST_SUITE_P(Pipeline, ShippedTwice,
                         testing::ValuesIn(fixtures::some_of<const char*>({"first_prototype", "pnrvsa", "measured_table"}, 1)),
                         [](const auto& one) { return std::string(one.param); });

TEST_P(ShippedTwice, TwoRunsGiveTheSameBytes) {
    const Run second;
    ASSERT_TRUE(second.result.made);
    EXPECT_TRUE(second.files() == first_run().files());
}

using FromDeadBand = fixtures::TempFolder;

/// Wanted in the profile, cut into cams, and simulated from them: the same dead-band.
TEST_F(FromDeadBand, TheDeadBandAskedForIsTheOneThatTheJointHas) {
    const batch::MakeResult result = batch::make(profile::read_profile(fixtures::shipped("from_dead_band")), {.out = folder_});
    ASSERT_TRUE(result.made);
    const auto lines = lines_of(core::read_file(result.folder / "dead_band.csv"));
    ASSERT_GE(lines.size(), 3u);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        std::istringstream cells(lines[i]);
        double tau = 0.0, linear = 0.0;
        char comma = 0;
        cells >> tau >> comma >> linear;
        const double wanted = core::rad_from_deg(48.0 * std::pow(tau, -2.2));
        EXPECT_NEAR(linear, wanted, 1e-8 * wanted) << lines[i];
    }
}

}  // namespace
}  // namespace fusee::pipeline
