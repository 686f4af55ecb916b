#include <gtest/gtest.h>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/stl.h"
#include "fusee/formats/format.h"

// A disc turns about a point beside its centre and pushes a roller: the roller's centre stays both radii from the disc's.
namespace fusee::readback {
namespace {

using exchange::PartFile;
using fixtures::Disc;

constexpr double kRoller = 8.0, kLead = 2.6;  // [mm]; [rad] of the disc's centre before the follower's line

/// The law of a disc whose rim is the floor of the fixture's groove.
PartFile follower_part(const Disc& disc, double offset, int torque_sign) {
    PartFile part;
    part.part = "k_pe";
    part.torque_sign = torque_sign;
    part.rotation_sign = -torque_sign;
    part.spring_kind = "compression";
    part.spring_rate = 7460.0;
    part.spring_preload = 14.6e-3;
    part.provenance = "fusee test";
    part.guide.kind = "roller";
    const double beta = -torque_sign * kLead, rim = disc.radius_mm - 0.5 * disc.cable_mm, apart = rim + kRoller;
    part.guide.direction = {std::cos(beta), std::sin(beta)};
    part.guide.offset_mm = offset;
    part.guide.radius_mm = kRoller;
    for (int i = 0; i < 400; ++i) {
        const double a = 1.6 * i / 399, along = disc.offset_mm * std::cos(kLead - a), across = disc.offset_mm * std::sin(kLead - a);
        const double beside = across - offset, root = std::sqrt(apart * apart - beside * beside), s = along + root;
        if (i == 0) part.guide.start_mm = s;
        const double line = beta + torque_sign * a, x = s * std::cos(line) - torque_sign * offset * std::sin(line),
                     y = s * std::sin(line) + torque_sign * offset * std::cos(line), share = rim / apart;
        const double lift = s - part.guide.start_mm;
        part.target.push_back({a,
                               across + beside * along / root,
                               part.spring_rate * (part.spring_preload + 1e-3 * lift),
                               {disc.offset_mm + share * (x - disc.offset_mm), share * y, 0.0},
                               lift});
    }
    return part;
}

/// The law of the same disc under a roller on an arm, by the triangles of pivot, disc and roller, and of pivot and the spring's pins.
PartFile arm_part(const Disc& disc, int sense, int torque_sign) {
    constexpr double kArm = 50.0, kLever = 45.0, kSpring = 60.0, kStep = 1e-5;
    PartFile part = follower_part(disc, 0.0, torque_sign);
    exchange::PartGuide& guide = part.guide;
    guide = {};
    guide.kind = "arm";
    guide.position_mm = {62.0 * std::cos(0.4), 62.0 * std::sin(0.4)};
    guide.radius_mm = kRoller;
    guide.sense = sense;
    guide.arm_mm = kArm, guide.lever_mm = kLever, guide.spring_mm = kSpring;
    const double rim = disc.radius_mm - 0.5 * disc.cable_mm, apart = rim + kRoller;
    const auto direction = [&](double a) {  // of the arm in the world
        const double x = disc.offset_mm * std::cos(part.rotation_sign * a) - guide.position_mm[0],
                     y = disc.offset_mm * std::sin(part.rotation_sign * a) - guide.position_mm[1], d = std::hypot(x, y);
        return std::atan2(y, x) + sense * std::acos((kArm * kArm + d * d - apart * apart) / (2.0 * kArm * d));
    };
    const auto lift = [&](double a) {
        const double turned = std::remainder(sense * (direction(a) - direction(0.0)), 2.0 * core::kPi);
        return kSpring - std::hypot(kLever - kLever * std::cos(turned), kSpring - kLever * std::sin(turned));
    };
    guide.direction = {std::cos(direction(0.0)), std::sin(direction(0.0))};
    for (exchange::TargetRow& row : part.target) {
        const double a = row.angle_rad, towards = direction(a), share = rim / apart;
        const double x = guide.position_mm[0] + kArm * std::cos(towards), y = guide.position_mm[1] + kArm * std::sin(towards);
        const double back = -part.rotation_sign * a, c = std::cos(back), s = std::sin(back);
        row.lift_mm = lift(a);
        row.arm_mm = (lift(a + kStep) - lift(a - kStep)) / (2.0 * kStep);
        row.load = part.spring_rate * (part.spring_preload + 1e-3 * row.lift_mm);
        row.contact_mm = {disc.offset_mm + share * (c * x - s * y - disc.offset_mm), share * (s * x + c * y), 0.0};
    }
    return part;
}

class RollerReadBack : public fixtures::FolderTest {
protected:
    std::vector<ArmError> errors_of(PartFile part, const solid::Mesh& mesh) const {
        exchange::write_stl(folder_ / "a.stl", mesh, "fusee test");
        part.files = {{"a.stl", core::sha256_hex(core::read_file(folder_ / "a.stl")), mesh.triangles.size(), 0.002}};
        exchange::write_part_file(folder_ / "a.json", part);
        return formats::read_back(folder_, exchange::read_part_file(folder_ / "a.json"));
    }
};

// 1,000 columns leave the polygon 1e-4 mm inside the disc: 4e-6 of the spring's force, and steps of 1e-4 mm over 0.2 rad of an arm of 2 mm.
constexpr double kFacets = 1e-4;

TEST_F(RollerReadBack, DiscHasTheArmKnownByHand) {
    for (const auto& [offset, sign] : {std::pair{0.0, 1}, {0.0, -1}, {2.0, 1}, {-1.5, -1}})
        for (const ArmError& e : errors_of(follower_part({}, offset, sign), fixtures::disc_mesh({}))) {
            EXPECT_LT(e.worst_relative, kFacets) << offset << ' ' << sign << " at " << e.worst_angle_rad;
            EXPECT_EQ(e.rows, 400u);
        }
}

TEST_F(RollerReadBack, DiscTurnsAnArmAsKnownByHand) {
    for (const auto& [sense, sign] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}})
        for (const ArmError& e : errors_of(arm_part({}, sense, sign), fixtures::disc_mesh({})))
            EXPECT_LT(e.worst_relative, 2.0 * kFacets) << sense << ' ' << sign << " at " << e.worst_angle_rad;
    Disc wide;
    wide.radius_mm += 0.05;
    EXPECT_FALSE(errors_of(arm_part({}, 1, 1), fixtures::disc_mesh(wide)).front().passed());
    PartFile none = arm_part({}, 1, 1);
    none.guide.lever_mm = 0.0;
    fixtures::expect_refusal([&] { (void)errors_of(none, fixtures::disc_mesh({})); }, {"lever_mm"});
}

/// The rim of the disc as polyline and as spline of degree 1, and the cross of the pivot.
exchange::DxfDrawing drawing_of(const Disc& disc, const std::array<double, 2>& pivot) {
    exchange::DxfPolyline rim;
    for (int i = 0; i < 4000; ++i) {
        const double psi = 2.0 * core::kPi * i / 4000, r = disc.radius_mm - 0.5 * disc.cable_mm;
        rim.points_mm.push_back({disc.offset_mm + r * std::cos(psi), r * std::sin(psi)});
    }
    exchange::brep::PlaneSpline spline{1, {0.0}, rim.points_mm};
    spline.control_mm.push_back(rim.points_mm.front());
    for (std::size_t i = 0; i < spline.control_mm.size(); ++i) spline.knots.push_back(static_cast<double>(i));
    spline.knots.push_back(spline.knots.back());
    const auto [x, y] = pivot;
    return {{{"FLOOR", {rim}, {}},
             {"FLOOR_SPLINE", {}, {}, {spline}},
             {"PIVOT", {}, {}, {}, {}, {{{x - 2.0, y}, {x + 2.0, y}}, {{x, y - 2.0}, {x, y + 2.0}}}}},
            "fusee test"};
}

TEST_F(RollerReadBack, ADrawingsCrossIsTheArmsPivot) {
    PartFile part = arm_part({}, 1, 1);
    const auto errors = [&](const exchange::DxfDrawing& drawing) {
        exchange::write_dxf(folder_ / "a.dxf", drawing);
        part.files = {{"a.dxf", core::sha256_hex(core::read_file(folder_ / "a.dxf")), 0, 0.001}};
        return formats::read_back(folder_, part);
    };
    const std::array<double, 2> pivot = part.guide.position_mm;
    for (const ArmError& e : errors(drawing_of({}, pivot))) EXPECT_LT(e.worst_relative, 1e-3) << e.reader;
    fixtures::expect_refusal([&] { (void)errors(drawing_of({}, {pivot[0], pivot[1] + 0.01})); }, {"a.dxf", "PIVOT", "PART.json"});
    exchange::DxfDrawing none = drawing_of({}, pivot);
    none.layers.pop_back();
    fixtures::expect_refusal([&] { (void)errors(none); }, {"a.dxf", "PIVOT"});
}

// A rim 0.05 mm too far out lifts the follower by that: k 0.05 mm over the force, 0.3 % of 109 N.
TEST_F(RollerReadBack, ARimTooLargeLoadsTheSpringMore) {
    Disc wide;
    wide.radius_mm += 0.05;
    const ArmError e = errors_of(follower_part({}, 0.0, 1), fixtures::disc_mesh(wide)).front();
    EXPECT_FALSE(e.passed());
    EXPECT_NEAR(e.worst_relative, 7460.0 * 0.05e-3 / (7460.0 * 14.6e-3), 4e-4);  // and a slope that differs by beside/root^2
}

TEST_F(RollerReadBack, ALumpOnTheRimIsFound) {
    Disc lump;
    lump.bulge_mm = 0.05;
    const PartFile part = follower_part({}, 0.0, 1);
    const auto& c = part.target[200].contact_mm;
    lump.bulge_at = std::atan2(c[1], c[0] - lump.offset_mm);
    EXPECT_FALSE(errors_of(part, fixtures::disc_mesh(lump)).front().passed());
}

TEST_F(RollerReadBack, ALiftThatItsArmsDoNotGiveIsRefused) {
    PartFile part = follower_part({}, 0.0, 1);
    part.target[300].lift_mm += 0.01;
    fixtures::expect_refusal([&] { (void)errors_of(part, fixtures::disc_mesh({})); }, {"target"});
}

}  // namespace
}  // namespace fusee::readback
