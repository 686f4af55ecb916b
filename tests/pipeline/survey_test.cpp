#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <set>

#include "fusee/batch/batch.h"
#include "fusee/core/units.h"
#include "fusee/exchange/part_file.h"
#include "pipeline/fixture.h"

// Guides and paths together: both parts are made, every rule that demands a change is content, and each file carries the law. A few of all
// combinations here, as meshes and drawings; with FUSEE_SURVEY in the environment every one, STEP and G-code too.
namespace fusee::pipeline {
namespace {

struct SurveyedPath {
    const char* guide;  ///< "parallel", "point", "idler 1", "idler -1"
    const char* path;   ///< "planar", "pitch", "aimed"
    double turns;
};
std::string path_name(const SurveyedPath& c) {
    std::string name = std::string(c.guide) + "_" + c.path + "_" + std::to_string(static_cast<int>(10 * c.turns));
    std::replace(name.begin(), name.end(), ' ', '_');
    std::replace(name.begin(), name.end(), '-', 'n');
    return name;
}
void PrintTo(const SurveyedPath& c, std::ostream* out) { *out << path_name(c); }

bool possible(const SurveyedPath& c) {
    const std::string path = c.path;
    return path == "planar" ? c.turns < 1.0 : path == "pitch" || std::string(c.guide) != "parallel";
}

std::vector<SurveyedPath> surveyed_paths() {
    if (!std::getenv("FUSEE_SURVEY")) return {{"point", "planar", 0.9}, {"idler -1", "pitch", 1.5}, {"idler 1", "aimed", 2.5}};
    std::vector<SurveyedPath> all;
    for (const char* guide : {"parallel", "point", "idler 1", "idler -1"})
        for (const char* path : {"planar", "pitch", "aimed"})
            for (const double turns : {0.5, 0.9, 1.5, 2.5, 3.5})
                if (const SurveyedPath c{guide, path, turns}; possible(c)) all.push_back(c);
    return all;
}

/// Springs that turn both cams by `turns`, arms about 20 mm: F_SE = 0.05 + 0.02 x + 0.0004 x^2, F_PE = 0.05 + 0.01 x + 0.0002 x^2 [Nm].
/// The cable's end is held elsewhere on a helix: an axial hole would break into the turns above.
std::string profile_of(const SurveyedPath& c) {
    const double x = 2.0 * core::kPi * c.turns, end = 0.1 + 0.03 * x + 0.0006 * x * x;
    const std::string guide = c.guide, path = c.path;
    // Of a constant pitch the guide stands half way up; aimed, so high that the last turns still climb by more than their groove's width.
    const double high = path == "planar" ? 0.0 : path == "pitch" ? 2.0 * c.turns : 46.0;
    std::string part = "guide = { kind = \"" + guide.substr(0, guide.find(' ')) + '"';
    if (guide != "parallel") part += ", distance_mm = 800.0, z_mm = " + std::to_string(high);
    if (guide.starts_with("idler")) part += ", radius_mm = 8.0, sense = " + guide.substr(6);
    part += " }\npath = { kind = \"" + std::string(path == "planar" ? "planar" : "helix") + '"';
    if (path == "pitch") part += ", pitch_mm = 4.2";
    if (path == "aimed") part += ", lead = \"aimed\"";
    part += " }\nfeatures = { anchor_hole_mm = " + std::string(path == "planar" ? "2.0" : "0.0") + " }\n";
    return "name = \"survey\"\n[rig]\ncapstan_radius_mm = 20.0\njoint_radius_mm = 20.0\ngear_friction = 0.1\nleast_torque_Nm = 0.12\n"
           "peak_torque_Nm = 0.15\noverdrive_torque_Nm = 0.16\n[law]\nkind = \"polynomial\"\nseries_Nm = [0.05, 0.02, 0.0004]\n"
           "parallel_Nm = [0.05, 0.01, 0.0002]\nstart_torque_Nm = 0.1\nend_torque_Nm = " +
           std::to_string(end) +
           "\n[cable]\ndiameter_mm = 0.8\n[process]\nkind = \"fdm\"\n[tolerances]\nchordal_error_mm = 0.01\n"
           "[outputs]\nformats = [\"stl\", \"dxf\"" +
           (std::getenv("FUSEE_SURVEY") ? ", \"step\", \"ngc\"" : "") +
           "]\npair = false\nplate = false\n"
           "[machining]\ntolerance_mm = 0.005\n[k_se]\n" +
           part + "spring = { rate_Nm_per_rad = 0.022, preload_rad = 2.4 }\n[k_pe]\n" + part +
           "spring = { rate_N_per_m = 25.0, preload_mm = 100.0 }\n";
}

class Survey : public fixtures::TempFolder, public testing::WithParamInterface<SurveyedPath> {};
INSTANTIATE_TEST_SUITE_P(Pipeline, Survey, testing::ValuesIn(surveyed_paths()), [](const auto& one) { return path_name(one.param); });

TEST_P(Survey, IsMadeAndEveryFileCarriesItsLaw) {
    const profile::Profile profile = profile::read_profile(write("survey.toml", profile_of(GetParam())));
    const batch::MakeResult result = batch::make(profile, {.out = folder_ / "out"});
    for (const core::Finding& f : result.findings) EXPECT_NE(f.severity, core::Severity::kError) << core::to_line(f);
    ASSERT_TRUE(result.made);
    std::set<std::string> kinds;  // of both parts, each read back by `make`, which refuses what does not pass
    for (const char* name : {"k_se.json", "k_pe.json"})
        for (const exchange::FileEntry& file : exchange::read_part_file(result.folder / name).files)
            kinds.insert(name + std::filesystem::path(file.name).extension().string());
    for (const char* kind : {"k_se.json.stl", "k_pe.json.stl"}) EXPECT_TRUE(kinds.count(kind)) << kind;
    EXPECT_EQ(kinds.count("k_pe.json.dxf"), std::string(GetParam().path) == "planar" ? 1u : 0u);
    EXPECT_GT(result.file_errors.arm, 0.0);
    EXPECT_LT(result.file_errors.arm, 5e-4);  // chords of 0.01 mm on arms of 20 mm
}

}  // namespace
}  // namespace fusee::pipeline
