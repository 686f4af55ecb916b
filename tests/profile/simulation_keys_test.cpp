#include <fmt/format.h>

#include "fusee/core/units.h"
#include "profile/fixture.h"
#include "shipped.h"

namespace fusee::profile {
namespace {

class SimulationKeys : public ProfileTest {
protected:
    static constexpr const char* kStiction = "kind = \"stiction_compensating\"\nk_per_Nm_rad = 0.225\nu_Nm = 0.0012\nc_Nm = 0.265\n";
    static constexpr const char* kEnds = "start_torque_Nm = 0.6\nend_torque_Nm = 2.09\n";
    /// The short profile without a single table that only parts need.
    static std::string partless() {
        const std::string whole = kShort;
        return whole.substr(0, whole.find("[cable]"));
    }
    /// A CSV file whose rows are x, slope x for x = 0.2, 0.4, ... up to count of them.
    void write_rows(const std::string& file, const std::string& header, int count, double slope) const {
        std::string csv = "# rows\n" + header + "\n";
        for (int i = 1; i <= count; ++i) csv += fmt::format("{},{}\n", 0.2 * i, slope * 0.2 * i);
        core::write_file(folder_ / file, csv);
    }
    void expect_round_trip(const Profile& p) const { EXPECT_EQ(to_toml(read(to_toml(p))), to_toml(p)); }
};

TEST_F(SimulationKeys, GearAndBearingFriction) {
    const Profile p = read(edited("gear_friction = 0.28",
                                  "gear_friction = 0.28\ngear_friction_constant_Nm = 0.02\ngear_friction_rest_excess = 0.1\n"
                                  "joint_friction_Nm = 0.003\njoint_tension_friction = 0.01"));
    EXPECT_EQ(p.rig.gear_friction_constant, 0.02);
    EXPECT_EQ(p.rig.gear_friction_rest_excess, 0.1);
    EXPECT_EQ(p.rig.joint_friction.constant, 0.003);
    EXPECT_EQ(p.rig.joint_friction.tension_share, 0.01);
    expect_round_trip(p);
}

TEST_F(SimulationKeys, AMeasuredGearFrictionTakesThePlaceOfTheLine) {
    write_rows("gear.csv", "load_Nm,friction_Nm", 4, 0.3);
    const std::string toml = edited("gear_friction = 0.28", "gear_friction_table = \"gear.csv\"");
    const Profile p = read(toml);
    EXPECT_EQ(p.rig.gear_friction_table.x.size(), 4u);
    EXPECT_EQ(p.rig.gear_friction_table.y.back(), 0.24);
    EXPECT_EQ(p.sha256, core::sha256_hex(toml + core::read_file(folder_ / "gear.csv")));
    expect_round_trip(p);
    expect_words(refusal(edited("gear_friction = 0.28", "gear_friction = 0.28\ngear_friction_table = \"gear.csv\"")),
                 {"p.toml:5:", "rig.gear_friction", "only without rig.gear_friction_table"});
    expect_words(refusal(edited("gear_friction = 0.28\n", "")), {"rig.gear_friction: missing"});
    core::write_file(folder_ / "gear.csv", "load_Nm,friction_Nm\n0.5,0.1\n0.4,0.2\n");
    expect_words(refusal(toml), {"gear.csv:3:1: load_Nm", "0.4", "above the row before, 0.5"});
    core::write_file(folder_ / "gear.csv", "load_Nm,friction_Nm\n0.5,0.1\n0.6,-0.2\n");
    expect_words(refusal(toml), {"gear.csv:3:5: friction_Nm", "-0.2", "at least 0"});
}

TEST_F(SimulationKeys, ArrangementsNeedNoPartsAndTakeNone) {
    const std::string toml = partless();
    const std::string other =
        std::string(toml).replace(toml.find("[rig]\n"), 6, "[rig]\narrangement = \"bidirectional\"\nposition_stiffness_Nm_per_rad = 12\n");
    const Profile p = read(other);
    EXPECT_EQ(p.rig.arrangement, actuator::Arrangement::kBidirectional);
    EXPECT_EQ(p.rig.position_stiffness, 12.0);
    EXPECT_FALSE(p.has_parts);
    expect_round_trip(p);
    expect_words(refusal(other + "[cable]\ndiameter_mm = 0.8\n"),
                 {"cable.diameter_mm: has no meaning here", "rig.arrangement = \"pnrvsa\""});
    expect_words(refusal(edited("[rig]\n", "[rig]\nposition_stiffness_Nm_per_rad = 12\n")),
                 {"only with rig.arrangement = \"series_elastic\" or"});
    expect_words(refusal(edited("[rig]\n", "[rig]\narrangement = \"parallel\"\n")), {"p.toml:3:15: rig.arrangement", "\"cross_coupled\""});
}

TEST_F(SimulationKeys, AProfileHasAllItsPartsOrNone) {
    const Profile none = read(partless());
    EXPECT_FALSE(none.has_parts);
    EXPECT_EQ(to_toml(none).find("[cable]"), std::string::npos);
    expect_round_trip(none);
    EXPECT_TRUE(read(kShort).has_parts);
    expect_words(refusal(partless() + "[outputs]\nsprings_rows = 300\n"), {"cable.diameter_mm: missing"});
}

TEST_F(SimulationKeys, DynamicsAndSimulation) {
    write_rows("read.csv", "tau_Nm,width_deg", 3, 90.0);
    const Profile p = read(std::string(kShort) +
                           "[dynamics]\nmotor_inertia_kgm2 = 0.003\njoint_noise_Nm2s = 2e-6\n[simulate]\nlevels = 31\n"
                           "push_torque_Nm = 0.7\nmeasured = \"read.csv\"\n");
    EXPECT_EQ(p.dynamics.motor_inertia, 0.003);
    EXPECT_EQ(p.dynamics.joint_noise, 2e-6);
    EXPECT_EQ(p.dynamics.motor_viscous, Profile().dynamics.motor_viscous);
    EXPECT_EQ(p.simulate.levels, 31);
    EXPECT_EQ(p.simulate.push_torque, 0.7);
    ASSERT_EQ(p.simulate.measured.y.size(), 3u);
    EXPECT_DOUBLE_EQ(p.simulate.measured.y[0], core::rad_from_deg(18.0));
    expect_round_trip(p);
    expect_words(refusal(std::string(kShort) + "[simulate]\nlevels = 1\n"), {"p.toml:28:10: simulate.levels: 1", "2 to 1000"});
    expect_words(refusal(std::string(kShort) + "[dynamics]\njoint_inertia_kgm2 = 0\n"), {"dynamics.joint_inertia_kgm2", "above 0"});
    expect_words(refusal(std::string(kShort) + "[simulate]\nmeasured = \"none.csv\"\n"), {"none.csv"});
}

TEST_F(SimulationKeys, SpringsFromADeadBand) {
    const Profile formula =
        read(edited(kStiction, "kind = \"from_dead_band\"\ndead_band_deg = \"60 * exp(-tau)\"\nstart_transmission = 0.3\n"));
    const auto& wanted = std::get<DeadBandSpec>(formula.law.curves);
    EXPECT_EQ(wanted.dead_band.formula, "60 * exp(-tau)");
    EXPECT_EQ(wanted.start_transmission, 0.3);
    EXPECT_TRUE(wanted.series_stiffness.formula.empty() && wanted.series_stiffness.rows.file.empty());
    expect_round_trip(formula);
    write_rows("db.csv", "tau_Nm,dead_band_deg", 12, 30.0);
    write_rows("s.csv", "tau_Nm,stiffness_Nm_per_rad", 12, 0.4);
    const Profile rows =
        read(edited(kStiction, "kind = \"from_dead_band\"\ndead_band_file = \"db.csv\"\nseries_stiffness_file = \"s.csv\"\n"));
    EXPECT_DOUBLE_EQ(std::get<DeadBandSpec>(rows.law.curves).dead_band.rows.y[0], core::rad_from_deg(6.0));
    EXPECT_EQ(std::get<DeadBandSpec>(rows.law.curves).series_stiffness.rows.x.size(), 12u);
    expect_round_trip(rows);
    expect_words(refusal(edited(kStiction, "kind = \"from_dead_band\"\n")), {"law.dead_band_deg: missing", "a formula"});
    expect_words(refusal(edited(kStiction, "kind = \"from_dead_band\"\ndead_band_file = \"db.csv\"\ndead_band_deg = \"3\"\n")),
                 {"law.dead_band_deg", "only without law.dead_band_file"});
    expect_words(refusal(edited(kStiction,
                                "kind = \"from_dead_band\"\ndead_band_deg = \"3\"\nseries_stiffness_Nm_per_rad = \"1\"\n"
                                "start_transmission = 0.3\n")),
                 {"law.start_transmission", "only without law.series_stiffness_Nm_per_rad"});
}

TEST_F(SimulationKeys, AFreeCurveNamesItsOwnEnds) {
    const std::string curve =
        "kind = \"free_curve\"\nloads_Nm = [0.5, 0.8, 1.3, 2.1]\nseries_Nm_per_rad = [0.1, 0.2, 0.4, 0.9]\ntransmission = [0.5, 0.4, 0.3, "
        "0.2]\n";
    const std::string toml = edited(std::string(kStiction) + kEnds, curve);
    const Profile p = read(toml);
    EXPECT_EQ(std::get<spring::FreeCurveOptions>(p.law.curves).transmission.back(), 0.2);
    EXPECT_EQ(p.law.start_torque, 0.5);
    EXPECT_EQ(p.law.end_torque, 2.1);
    expect_round_trip(p);
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = toml;
        return text.replace(text.find(from), from.size(), to);
    };
    expect_words(refusal(edited(kStiction, curve)), {"law.start_torque_Nm: has no meaning here"});
    expect_words(refusal(changed("[0.5, 0.8,", "[0.8, 0.8,")), {"p.toml:11:", "law.loads_Nm: 0.8", "above the knot before, 0.8 Nm"});
    expect_words(refusal(changed("[0.5, 0.4, 0.3, 0.2]", "[0.5, 0.4, 0.3]")), {"law.transmission", "array of 4 to 100 numbers"});
    expect_words(refusal(changed("[0.5, 0.4, 0.3, 0.2]", "[0.5, 0.4, 0.3, 0.2, 0.1]")),
                 {"law.transmission: 5 numbers", "as many as law.loads_Nm, 4"});
    expect_words(refusal(changed("[0.5, 0.4, 0.3, 0.2]", "[0.5, 0.4, 0.3, 1.0]")), {"law.transmission", "at most 0.999"});
}

// What is shipped is read, and written again without loss.
TEST_F(SimulationKeys, ShippedProfiles) {
    std::size_t read = 0;
    for (const std::filesystem::path& file : fixtures::shipped_files("profiles")) {
        const std::string folder = file.parent_path().string();
        if (file.extension() != ".toml" || (folder != "profiles" && folder != "profiles/paper" && folder != "profiles/relatives")) continue;
        SCOPED_TRACE(file);
        const std::filesystem::path path = std::filesystem::path(FUSEE_SOURCE_DIR) / file;
        const Profile p = read_profile(path);
        for (const std::filesystem::path& csv : {p.simulate.measured.file, p.rig.gear_friction_table.file})
            EXPECT_TRUE(csv.empty() || std::filesystem::exists(path.parent_path() / csv));
        EXPECT_EQ(p.has_parts, folder == "profiles" || p.name == "new_cams");
        ++read;
    }
    EXPECT_GE(read, 15u);
}

}  // namespace
}  // namespace fusee::profile
