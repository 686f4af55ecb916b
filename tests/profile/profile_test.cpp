#include "fusee/core/units.h"
#include "profile/fixture.h"

namespace fusee::profile {
namespace {

TEST_F(ProfileTest, TurnsUnitsIntoSi) {
    const Profile p = read(kShort);
    EXPECT_EQ(p.name, "short");
    EXPECT_EQ(p.rig.joint_radius, 0.025);
    EXPECT_EQ(p.law.lead_in_travel, core::rad_from_deg(5.0));
    EXPECT_EQ(p.cable.diameter, 8e-4);
    EXPECT_EQ(p.k_pe.spring.preload, 0.0146);
    EXPECT_EQ(p.k_pe.spring.rate, 7460.0);
    EXPECT_EQ(p.process.kind, checks::ProcessKind::kFdm);
    EXPECT_EQ(p.k_se.spring.kind, spring::BaseKind::kTorsion);
    EXPECT_EQ(p.k_pe.spring.kind, spring::BaseKind::kCompression);
}

TEST_F(ProfileTest, GivesSharedFiguresToEveryRoomThatNeedsThem) {
    const Profile p = read(std::string(kShort) + "[groove]\nrib_mm = 1.7\n[tolerances]\nchordal_error_mm = 0.01\n");
    const auto& law = std::get<spring::StictionLawOptions>(p.law.curves);
    EXPECT_EQ(law.mu, 0.28);
    EXPECT_EQ(law.start_torque, 0.6);
    EXPECT_EQ(law.end_torque, 2.09);
    for (const PartSpec* part : {&p.k_se, &p.k_pe}) {
        EXPECT_EQ(part->cam.cable_diameter, 8e-4);
        EXPECT_EQ(part->solid.groove.rib, 1.7e-3);
        EXPECT_EQ(part->solid.chordal_error, 1e-5);
    }
}

TEST_F(ProfileTest, LeavesTheRoomsDefaultsAlone) {
    const Profile p = read(kShort);
    EXPECT_EQ(p.k_se.solid.hub.bore_diameter, solid::HubOptions{}.bore_diameter);
    EXPECT_EQ(p.k_se.cam.path.margin, cam::PathOptions{}.margin);
    EXPECT_TRUE(p.outputs.has("stl") && p.outputs.has("scad") && p.outputs.has("dxf") && p.outputs.has("3mf"));
}

TEST_F(ProfileTest, ReadsEnumsListsAndArrays) {
    const Profile p = read(std::string(kShort) +
                           "[outputs]\nformats = [\"3mf\", \"stl\"]\n[k_pe.guide]\nkind = \"idler\"\ndistance_mm = 80\nradius_mm = 10\n"
                           "sense = -1\n[k_pe.path]\nkind = \"helix\"\nlead = \"aimed\"\npitch_mm = 2\n[k_pe.hub]\nlock = \"set_screw\"\n"
                           "screw_mm = 3\nboss_mm = 16\nboss_height_mm = 8\n");
    EXPECT_TRUE(p.outputs.has("stl") && p.outputs.has("3mf"));
    EXPECT_FALSE(p.outputs.has("scad") || p.outputs.has("dxf"));
    EXPECT_EQ(p.k_pe.cam.guide.kind, cam::GuideKind::kIdler);
    EXPECT_EQ(p.k_pe.cam.guide.sense, -1);
    EXPECT_EQ(p.k_pe.cam.path.lead, cam::Lead::kAimedAtGuide);
    EXPECT_EQ(p.k_pe.solid.hub.lock, solid::HubLock::kSetScrew);
}

TEST_F(ProfileTest, PolynomialAndExponentialLaws) {
    const std::string stiction = "kind = \"stiction_compensating\"\nk_per_Nm_rad = 0.225\nu_Nm = 0.0012\nc_Nm = 0.265\n";
    const Profile cubic = read(edited(stiction, "kind = \"polynomial\"\nseries_Nm = [0.1, 0.2, 0, 0.05]\nparallel_Nm = [0.1, 0.3]\n"));
    EXPECT_EQ(std::get<PolynomialPair>(cubic.law.curves).series, (std::vector<double>{0.1, 0.2, 0.0, 0.05}));
    const Profile growing = read(edited(stiction,
                                        "kind = \"exponential\"\nseries_scale_Nm = 0.2\nseries_rate_per_rad = 0.5\nseries_offset_Nm = 0.1\n"
                                        "parallel_scale_Nm = 0.3\nparallel_rate_per_rad = 0.6\nparallel_offset_Nm = 0.2\n"));
    EXPECT_EQ(std::get<ExponentialPair>(growing.law.curves).parallel.rate, 0.6);
    for (const Profile* p : {&cubic, &growing}) EXPECT_EQ(to_toml(read(to_toml(*p))), to_toml(*p));
}

TEST_F(ProfileTest, WrittenAndReadAgainGivesTheSameNumbersBitForBit) {
    const Profile shipped = read_profile(std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles" / "pnrvsa.toml");
    const Profile again = read(to_toml(shipped));
    EXPECT_EQ(to_toml(again), to_toml(shipped));
    EXPECT_EQ(again.law.lead_in_travel, shipped.law.lead_in_travel);
    EXPECT_EQ(again.k_pe.solid.hub.boss_diameter, shipped.k_pe.solid.hub.boss_diameter);
    EXPECT_EQ(again.k_se.cam.path.margin, shipped.k_se.cam.path.margin);  // a default of 0.35 rad, written in degrees
    EXPECT_EQ(again.k_se.solid.features.leg_slot_angle, shipped.k_se.solid.features.leg_slot_angle);
    // Found by the invariants: 17 digits of the angle in degrees are a neighbour of the number that was read.
    for (const double degrees : {-19.660610140271473, -136.47961446990968, -158.83735816566315, 36.075178847609834}) {
        Profile turned = shipped;
        turned.k_se.cam.guide.direction = degrees * core::kPi / 180.0;
        EXPECT_EQ(read(to_toml(turned)).k_se.cam.guide.direction, turned.k_se.cam.guide.direction) << degrees;
    }
}

/// With comments, only keys that differ from their defaults; the same profile whatever the kind of its law.
TEST_F(ProfileTest, CommentedTextReadAgainIsTheSameProfile) {
    for (const char* name : {"pnrvsa", "first_prototype", "measured_table", "from_dead_band", "free_curve"}) {
        const std::filesystem::path file = std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles" / (std::string(name) + ".toml");
        const Profile shipped = read_profile(file);
        const std::string text = to_commented_toml(shipped);
        EXPECT_EQ(to_toml(parse_profile(text, file)), to_toml(shipped)) << name;
        EXPECT_NE(text.find("# r_c, radius at which the capstan takes the joint's cable"), std::string::npos) << name;
    }
}

TEST_F(ProfileTest, TheShippedProfileIsThePapersActuator) {
    const Profile p = read_profile(std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles" / "pnrvsa.toml");
    EXPECT_EQ(p.rig.gear_friction, 0.28);
    EXPECT_EQ(p.rig.overdrive_torque, 1.5);
    EXPECT_GE(p.law.end_torque, p.rig.overdrive_torque / (1.0 - p.rig.gear_friction));  // what stiction asks of the springs
    EXPECT_LE(p.law.start_torque, p.rig.least_torque / (1.0 + p.rig.gear_friction));
}

TEST_F(ProfileTest, HashIsOfTheBytesOfTheProfileAndItsTable) {
    EXPECT_EQ(read(kShort).sha256, core::sha256_hex(kShort));
    std::string csv = "angle_rad,series_Nm,parallel_Nm\n";
    for (int i = 0; i < 8; ++i)
        csv += std::to_string(0.5 * i) + "," + std::to_string(0.1 + 0.1 * i) + "," + std::to_string(0.2 + 0.2 * i) + "\n";
    core::write_file(folder_ / "measured.csv", csv);
    const std::string toml = edited("kind = \"stiction_compensating\"\nk_per_Nm_rad = 0.225\nu_Nm = 0.0012\nc_Nm = 0.265\n",
                                    "kind = \"table\"\nfile = \"measured.csv\"\nknots = 9\n");
    const Profile p = read(toml);
    EXPECT_EQ(p.sha256, core::sha256_hex(toml + csv));
    const auto& table = std::get<TablePair>(p.law.curves);
    EXPECT_EQ(table.angle.size(), 8u);
    EXPECT_EQ(table.parallel.back(), 1.6);
    EXPECT_EQ(table.smoothing.knots, 9);
    EXPECT_EQ(to_toml(read(to_toml(p))), to_toml(p));
}

TEST_F(ProfileTest, ByteOrderMarkCarriageReturnsAndForeignComments) {
    std::string toml =
        "\xEF\xBB\xBF# \xC3\xBC"
        "ber den Aktor\n" +
        std::string(kShort);
    for (std::size_t at = 0; (at = toml.find('\n', at)) != std::string::npos; at += 2) toml.insert(at, "\r");
    EXPECT_EQ(read(toml).rig.peak_torque, 1.0);
}

}  // namespace
}  // namespace fusee::profile
