#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "exchange/fixtures/parts.h"
#include "fusee/core/file.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/formats/format.h"

namespace fusee::readback {
namespace {

using exchange::PartFile;
using exchange::PartGuide;
using fixtures::Disc;

// 1,000 columns leave the polygon 5e-6 of the radius inside the disc; the rays add 1.2e-6, single precision 1e-7.
constexpr double kPolygon = 7e-6;

struct Case {
    const char* name;
    PartGuide guide;
    int torque_sign, rotation_sign;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"parallel spool", {"parallel", {std::cos(0.7), std::sin(0.7)}, {}, 0.0, 1}, 1, 1},
        {"parallel cam, turned the other way", {"parallel", {std::cos(0.7), std::sin(0.7)}, {}, 0.0, 1}, -1, 1},
        {"point", {"point", {}, {20.0, 60.0}, 0.0, 1}, 1, -1},
        {"point, negative torque", {"point", {}, {20.0, 60.0}, 0.0, 1}, -1, -1},
        {"idler on the left", {"idler", {}, {20.0, 60.0}, 6.0, 1}, 1, 1},
        {"idler on the right", {"idler", {}, {20.0, 60.0}, 6.0, -1}, 1, 1},
        {"idler, negative torque", {"idler", {}, {-50.0, 30.0}, 6.0, 1}, -1, 1},
    };
    return all;
}

class ReadBackTest : public fixtures::FolderTest {
protected:
    exchange::FileEntry entry(const std::string& name, std::size_t triangles) const {
        return {name, core::sha256_hex(core::read_file(folder_ / name)), triangles, 0.002};
    }
    void write_mesh(PartFile& part, const solid::Mesh& mesh) const {
        exchange::write_stl(folder_ / "a.stl", mesh, "fusee test");
        part.files = {entry("a.stl", mesh.triangles.size())};
    }
    std::filesystem::path file(const char* name) const { return folder_ / name; }
};

TEST_F(ReadBackTest, DiscHasTheArmKnownByHandForEveryGuide) {
    const solid::Mesh mesh = fixtures::disc_mesh({});
    for (const Case& c : cases()) {
        PartFile part = fixtures::disc_part({}, c.guide, c.torque_sign, c.rotation_sign);
        write_mesh(part, mesh);
        const std::vector<ArmError> errors = formats::read_back(folder_, part);
        ASSERT_EQ(errors.size(), 2u);
        EXPECT_EQ(errors[0].reader, "assimp");
        EXPECT_EQ(errors[1].reader, "openmesh");
        for (const ArmError& e : errors) {
            EXPECT_EQ(e.rows, 400u);
            EXPECT_LT(e.worst_relative, kPolygon) << c.name << " at " << e.worst_angle_rad;
            EXPECT_GT(e.worst_relative, 0.0);  // a polygon is not a circle
            EXPECT_TRUE(e.passed());
        }
    }
}

// A guide above the groove's plane: the torque is the arm's in the plane times the cosine of the free cable's fleet angle; its length
// follows from the disc's centre alone. 5 mm over about 55 mm cost 0.4 %.
TEST_F(ReadBackTest, ALeaningCableHasTheCosineOfItsArm) {
    const Disc disc;
    const solid::Mesh mesh = fixtures::disc_mesh(disc);
    for (const Case& c : cases()) {
        if (c.guide.kind == "parallel") continue;
        PartFile part = fixtures::disc_part(disc, c.guide, c.torque_sign, c.rotation_sign);
        part.guide.z_mm = 5.0;
        write_mesh(part, mesh);
        for (const ArmError& e : formats::read_back(folder_, part)) EXPECT_FALSE(e.passed()) << c.name << ": arms for a cable in the plane";
        const double side = disc.radius_mm - c.torque_sign * c.guide.sense * (c.guide.kind == "idler" ? c.guide.radius_mm : 0.0);
        for (exchange::TargetRow& row : part.target) {
            const double turned = c.rotation_sign * row.angle_rad, x = disc.offset_mm * std::cos(turned),
                         y = disc.offset_mm * std::sin(turned);
            const double to_centre = std::hypot(c.guide.position_mm[0] - x, c.guide.position_mm[1] - y);
            const double free = std::sqrt(to_centre * to_centre - side * side);
            row.arm_mm *= free / std::hypot(free, 5.0);
        }
        for (const ArmError& e : formats::read_back(folder_, part))
            EXPECT_LT(e.worst_relative, kPolygon) << c.name << " at " << e.worst_angle_rad;
    }
}

TEST_F(ReadBackTest, ThreeMfAndDrawingAgreeWithTheStl) {
    const Disc disc;
    const solid::Mesh mesh = fixtures::disc_mesh(disc);
    PartFile part = fixtures::disc_part(disc, cases()[2].guide, 1, -1);
    exchange::DxfPolyline floor;
    for (int i = 0; i < 2000; ++i) {
        const double psi = 2.0 * core::kPi * i / 2000, r = disc.radius_mm - disc.cable_mm / 2.0;
        floor.points_mm.push_back({disc.offset_mm + r * std::cos(psi), r * std::sin(psi)});
    }
    exchange::write_3mf(file("a.3mf"), mesh, "k_se", "fusee test");
    exchange::brep::PlaneSpline line{1, {0.0}, floor.points_mm};  // of degree 1, through the same points
    line.control_mm.push_back(floor.points_mm.front());
    for (std::size_t i = 0; i < line.control_mm.size(); ++i) line.knots.push_back(static_cast<double>(i));
    line.knots.push_back(line.knots.back());
    exchange::write_dxf(file("a.dxf"), {{{"FLOOR", {floor}, {}}, {"FLOOR_SPLINE", {}, {}, {line}}}, "fusee test"});
    core::write_file(file("a.scad"), "// not read here");
    part.files = {entry("a.3mf", mesh.triangles.size()), entry("a.dxf", 0), entry("a.scad", 0)};
    const std::vector<ArmError> errors = formats::read_back(folder_, part);
    ASSERT_EQ(errors.size(), 3u);
    EXPECT_EQ(errors[0].reader, "lib3mf");
    EXPECT_EQ(errors[1].reader, "dxflib");
    EXPECT_EQ(errors[2].reader, "dxflib, spline");
    for (const ArmError& e : errors) EXPECT_LT(e.worst_relative, kPolygon) << e.reader;
}

/// A ribbon: the floor and flanks of a groove that rises 2 mm per turn over 1.6 turns of h = R + g psi, so h' = g, rho = h.
solid::Mesh helix_ribbon(double radius, double growth, double pitch, double margin, double travel) {
    const auto section = fixtures::disc_section({});
    const auto rails = static_cast<std::uint32_t>(section.size() - 2);
    constexpr std::uint32_t kColumns = 3000;
    solid::Mesh mesh;
    for (std::uint32_t c = 0; c <= kColumns; ++c) {
        const double psi = -margin + (travel + 2.0 * margin) * c / kColumns, cs = std::cos(psi), sn = std::sin(psi);
        for (std::uint32_t k = 0; k < rails; ++k) {
            const double h = radius + growth * psi + section[k + 1][0];
            mesh.points_mm.push_back({h * cs - growth * sn, h * sn + growth * cs, pitch * psi / (2.0 * core::kPi) + section[k + 1][1]});
        }
        for (std::uint32_t k = 0; c > 0 && k + 1 < rails; ++k) {
            const std::uint32_t a = rails * (c - 1) + k, b = rails * c + k;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    }
    return mesh;
}

TEST_F(ReadBackTest, HelixOfMoreThanATurnMeetsItsOwnTurnOnly) {
    const double radius = 6.0, growth = 0.9, travel = 10.0;  // the last turn stands 5.6 mm above the first
    PartFile part = fixtures::disc_part({}, {"parallel", {0.0, 1.0}, {}, 0.0, 1}, 1, -1, travel);
    for (exchange::TargetRow& row : part.target) {
        const double psi = row.angle_rad, h = radius + growth * psi, c = std::cos(psi), s = std::sin(psi);
        row.arm_mm = h;
        row.contact_mm = {h * c - growth * s, h * s + growth * c, 3.0 * psi / (2.0 * core::kPi)};
    }
    write_mesh(part, helix_ribbon(radius, growth, 3.0, 0.35, travel));
    // columns: (10.7/3000)^2/8 of the arm, 1.6e-6; rays: (10/399/5)^2/8, 3e-6; floor points have heights between two columns: below 1e-5
    for (const ArmError& e : formats::read_back(folder_, part))
        EXPECT_LT(e.worst_relative, 2e-5) << e.reader << " at " << e.worst_angle_rad;
}

struct RealCase {
    const char* name;
    cam::Cam cam;
    solid::PartOptions options;
    double first_psi, travel;
};

/// With torque_sign 1, rotation_sign -1 and a parallel exit, psi rises with the cam angle: psi = first_psi + a.
solid::Part build(RealCase c) {
    c.cam.rotation_sign = -1;
    c.cam.options.guide.direction = c.first_psi + core::kPi / 2.0;
    for (int i = 0; i < 300; ++i) {
        cam::Contact contact;
        contact.arm.angle = c.travel * i / 299;
        contact.path = c.cam.path(c.first_psi + contact.arm.angle);
        contact.arm.arm = contact.path.h;
        c.cam.working.push_back(contact);
    }
    c.options.chordal_error = 2e-6;
    auto part = solid::build_part(c.cam, c.options);
    if (!part) throw std::runtime_error(core::to_line(part.refusal().front()));
    return *part;
}

TEST_F(ReadBackTest, BuiltPartsKeepTheirArmInEveryFormat) {
    const std::vector<RealCase> real{{"planar", fixtures::planar_cam(), fixtures::keyed_options(), 0.5, 2.5},
                                     {"helix", fixtures::helix_cam(), fixtures::overhung_options(), 0.0, 9.4}};
    for (const RealCase& c : real) {
        const solid::Part built = build(c);
        exchange::write_stl(file("a.stl"), built.mesh, "fusee test");
        exchange::write_3mf(file("a.3mf"), built.mesh, "part", "fusee test");
        std::vector<exchange::FileEntry> files{entry("a.stl", built.mesh.triangles.size()), entry("a.3mf", built.mesh.triangles.size())};
        if (built.cam.closed()) {
            exchange::write_dxf(file("a.dxf"), exchange::spool_drawing(built, "fusee test"));
            files.push_back(entry("a.dxf", 0));
        }
        exchange::write_part_file(file("a.json"), exchange::describe_part(built, {}, files, {"test", "0123456789abcdef", ""}));
        const std::vector<ArmError> errors = formats::read_back(folder_, exchange::read_part_file(file("a.json")));
        EXPECT_EQ(errors.size(), files.size() + (built.cam.closed() ? 2 : 1));  // STL and DXF are read twice
        // chordal error 2e-3 mm of an arm of at least 8.5 mm; it cannot be exceeded where mesh and drawing keep what they state
        for (const ArmError& e : errors)
            EXPECT_LT(e.worst_relative, 2e-3 / 8.5) << c.name << " " << e.reader << " at " << e.worst_angle_rad;
    }
}

TEST_F(ReadBackTest, WrongPartsAreNoticed) {
    const PartGuide guide = cases()[0].guide;
    PartFile part = fixtures::disc_part({}, guide, 1, 1);
    Disc larger, lump, elsewhere;
    larger.radius_mm *= 1.002;
    lump.bulge_mm = elsewhere.bulge_mm = 0.1;  // 0.5 % of the radius
    lump.bulge_at = std::atan2(part.target[200].contact_mm[1], part.target[200].contact_mm[0] - 5.0);
    elsewhere.bulge_at = lump.bulge_at + core::kPi;
    for (const Disc& disc : {larger, lump}) {
        write_mesh(part, fixtures::disc_mesh(disc));
        for (const ArmError& e : formats::read_back(folder_, part)) {
            EXPECT_FALSE(e.passed());
            EXPECT_LT(e.worst_relative, 6e-3);
        }
    }
    write_mesh(part, fixtures::disc_mesh(elsewhere));  // a lump that the cable never meets
    for (const ArmError& e : formats::read_back(folder_, part)) EXPECT_TRUE(e.passed());
    PartFile flipped = part;
    flipped.rotation_sign = -1;
    for (const ArmError& e : formats::read_back(folder_, flipped)) EXPECT_FALSE(e.passed());
    PartFile other_torque = part;
    other_torque.torque_sign = -1;
    for (const ArmError& e : formats::read_back(folder_, other_torque)) EXPECT_FALSE(e.passed());
}

TEST_F(ReadBackTest, NoFloorIsNoPass) {
    PartFile part = fixtures::disc_part({}, cases()[0].guide, 1, 1);
    for (exchange::TargetRow& row : part.target) row.contact_mm[2] = 50.0;  // above the part
    write_mesh(part, fixtures::disc_mesh({}));
    for (const ArmError& e : formats::read_back(folder_, part)) {
        EXPECT_TRUE(std::isnan(e.worst_relative));
        EXPECT_FALSE(e.passed());
    }
}

TEST_F(ReadBackTest, RefusesFilesThatAreNotTheOnesStated) {
    PartFile part = fixtures::disc_part({}, cases()[0].guide, 1, 1);
    const solid::Mesh mesh = fixtures::disc_mesh({});
    write_mesh(part, mesh);
    part.files[0].triangles -= 1;
    fixtures::expect_refusal([&] { (void)formats::read_back(folder_, part); }, {"a.stl", "triangles"});
    std::string bytes = core::read_file(file("a.stl"));
    bytes[100] = static_cast<char>(bytes[100] ^ 1);
    core::write_file(file("a.stl"), bytes);
    fixtures::expect_refusal([&] { (void)formats::read_back(folder_, part); }, {"a.stl", "SHA-256"});
    part.files[0].name = "missing.stl";
    fixtures::expect_refusal([&] { (void)formats::read_back(folder_, part); }, {"missing.stl"});
    core::write_file(file("a.step"), "ISO-10303-21;");
    part.files = {entry("a.step", 0)};
    fixtures::expect_refusal([&] { (void)formats::read_back(folder_, part); }, {"a.step"});
    exchange::write_dxf(file("a.dxf"), {{{"PITCH", {}, {}}}, ""});
    part.files = {entry("a.dxf", 0)};
    fixtures::expect_refusal([&] { (void)formats::read_back(folder_, part); }, {"a.dxf", "FLOOR"});
}

}  // namespace
}  // namespace fusee::readback
