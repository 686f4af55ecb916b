#pragma once
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <set>

#include "fixture.h"
#include "free_path.h"
#include "fusee/core/folder.h"
#include "fusee/exchange/step.h"
#include "step_geometry.h"

// The joint as a workshop gets it: assembly.step and bom.csv. Each step of the order has a free path, each fastener of the bill its hole,
// each spring its load at its angle; and a joint that is spoiled on purpose fails.
namespace fusee::assembly {

using namespace step_geometry;

struct Thread {
    double clearance, core;  ///< diameters: ISO 273, medium; ISO 2306
};
inline const std::map<std::string, Thread> kThreads{{"M3", {3.4, 2.5}}, {"M4", {4.5, 3.3}}};

/// The numbers that a pattern's groups match in a text.
inline std::vector<double> numbers(const std::string& text, const std::string& pattern) {
    std::smatch found;
    if (!std::regex_search(text, found, std::regex(pattern))) return {};
    std::vector<double> all;
    for (std::size_t i = 1; i < found.size(); ++i) all.push_back(std::stod(found[i]));
    return all;
}

inline constexpr const char* kMirrored = "mirrored";

class InStep : public testing::TestWithParam<const char*> {
public:
    struct Made {
        Assembly assembly;
        std::map<std::string, std::vector<Cylinder>> bodies;
        std::map<std::string, solid::Box> boxes;
        std::map<std::string, std::shared_ptr<const TopoDS_Shape>> shapes;
        std::map<std::string, std::vector<Solid>> solids;
        std::vector<BillRow> bill;
        std::set<std::string> files;
    };
    const Made& joint() {
        if (twin_ != nullptr) return *twin_;
        static std::map<std::string, Made> all;
        const auto known = all.find(GetParam());
        return known != all.end() ? known->second : all.emplace(GetParam(), make(GetParam())).first->second;
    }
    const std::vector<Cylinder>& body(const std::string& name) { return joint().bodies.at(name); }
    bool has(const std::string& name) { return joint().bodies.contains(name); }
    const BillRow& row(const std::string& item) {
        const auto& rows = joint().bill;
        return *std::find_if(rows.begin(), rows.end(), [&](const BillRow& r) { return r.item == item; });
    }
    /// Screws of one row of the bill that go through clearance holes of one body into threads of others.
    void expect_screwed(const std::string& item, const std::vector<std::string>& clamped, const std::vector<std::string>& threaded) {
        const BillRow& screw = row(item);
        const auto length = numbers(screw.size, R"(M3 x ([0-9]+) mm)");
        ASSERT_EQ(length.size(), 1U) << screw.size;
        const Thread size = kThreads.at("M3");
        std::size_t screws = 0;
        for (const std::string& part : clamped)
            for (const Cylinder& hole : of_radius(body(part), 0.5 * size.clearance, true)) {
                ++screws;
                std::vector<Cylinder> threads;
                for (const std::string& other : threaded)
                    for (const Cylinder& core : of_radius(body(other), 0.5 * size.core, true))
                        if (coaxial(core, hole)) threads.push_back(core);
                ASSERT_EQ(threads.size(), 1U) << item << " at " << hole.end.transpose();
                const Cylinder& core = threads.front();
                const double deep = length.front() - hole.length;
                EXPECT_GE(deep, 2.0 * 3.0 - 1e-9) << item << ": two diameters hold in plastic";
                EXPECT_GE(core.length, deep) << item << " ends in its thread";
                const double apart =
                    std::min((core.end - hole.end).norm(),
                             std::min((core.end - hole.other_end()).norm(),
                                      std::min((core.other_end() - hole.end).norm(), (core.other_end() - hole.other_end()).norm())));
                EXPECT_NEAR(apart, 0.0, 1e-5) << item << ": the thread begins where the hole ends";
            }
        EXPECT_EQ(screws, static_cast<std::size_t>(screw.count)) << item;
    }
    // The checks. Those of a spoiled twin are called by `fails`.
    void free_paths(), cams();
    void plates_screws(), seats_screws(), rods_screws(), links_screws(), stop_pins();
    void compression_spring(), torsion_spring();
    static void put(Made& made, const exchange::StepBody& solid) {
        made.bodies[solid.name] = cylinders(*solid.shape), made.boxes[solid.name] = solid.box;
        made.shapes[solid.name] = solid.shape, made.solids[solid.name] = solids_of(*solid.shape);
    }
    /// Does a check find the fault of a twin?
    bool fails(const Made& twin, void (InStep::*check)()) {
        testing::TestPartResultArray results;
        {
            const testing::ScopedFakeTestPartResultReporter here(testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD,
                                                                 &results);
            twin_ = &twin;
            (this->*check)();
            twin_ = nullptr;
        }
        return results.size() > 0;
    }
    std::vector<std::string> of_both(const std::string& name) { return {name + "_agonist", name + "_antagonist"}; }

private:
    const Made* twin_ = nullptr;
    static Made make(const std::string& name) {
        const core::TemporaryFolder folder;
        const bool mirrored = name == kMirrored;  // an overhung K_PE of the other sense, whose mirror image hangs below its capstan
        const std::filesystem::path source = joint_file(mirrored ? "pnrvsa" : name);
        std::string text = fixtures::with_keys(core::read_file(source), {{"outputs.formats", R"(["step", "stl", "dxf", "drawing"])"}});
        if (mirrored) text = fixtures::with_key(text, "k_pe.torque_sign", "-1");
        const profile::Profile profile = profile::parse_profile(text, source);
        core::OutputFolder output(folder.path() / "out", {.command = "make", .source = profile.file});
        const pipeline::MadeDesign design = pipeline::make_parts(profile, output).value();
        Made made{*design.report.assembly, {}, {}, {}, {}, bill_of(*design.report.assembly), {}};
        for (const auto& file : std::filesystem::directory_iterator(output.path())) made.files.insert(file.path().filename().string());
        for (const exchange::StepBody& solid : exchange::read_step_assembly(output.path() / "assembly.step")) put(made, solid);
        return made;
    }
};

}  // namespace fusee::assembly
