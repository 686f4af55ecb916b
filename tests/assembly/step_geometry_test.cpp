#include <fmt/format.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <functional>

#include "fusee/assembly/to_make.h"
#include "fusee/exchange/brep.h"
#include "in_step.h"
#include "long_form.h"

namespace fusee::assembly {

INSTANTIATE_TEST_SUITE_P(
    Shipped, InStep,
    testing::ValuesIn(fixtures::some_of<const char*>({"pnrvsa", "free_curve", "paper/new_cams", "init", kMirrored, "first_prototype"}, 5)),
    [](const auto& one) { return std::filesystem::path(one.param).filename().string(); });

// A row of another fastener has no test of its hole: it fails here.
TEST_P(InStep, EveryFastenerOfTheBillIsKnown) {
    static const std::set<std::string> kTested{"frame screw", "rod screw", "seat screw",       "link screw",
                                               "stop pin",    "stop post", "capstan stop pin", "capstan stop post"};
    for (const BillRow& r : joint().bill) {
        const std::string text = r.item + " " + r.size;
        if (r.count == 0 || !std::regex_search(text, std::regex("screw|\\bpin|dowel|ISO 4762|ISO 2338|ISO 8734"))) continue;
        EXPECT_TRUE(kTested.contains(r.item)) << r.item << ": " << r.size;
    }
}

// Whoever buys and makes asks nothing: a file of the folder, a standard, or what a shop cuts or winds to the sizes that stand there.
TEST_P(InStep, EveryLineOfTheBillIsAFileOrAStandardPart) {
    static const std::set<std::string> kToSize{"drive cable",  "series cable", "parallel cable", "compression spring", "torsion spring",
                                               "spring arbor", "guide tube",   "motor coupling", "carriage rod"};
    const std::regex file("[a-z_0-9]+[.](stl|dxf|svg)"), standard("(ISO|DIN|EN) [0-9]+");
    for (const BillRow& r : joint().bill) {
        if (r.count == 0) continue;  // what is not known is said
        const std::string text = r.item + (r.note.starts_with("made by fusee") ? ".stl; " : "; ") + r.size + "; " + r.note;
        bool named = std::regex_search(text, standard) || (kToSize.contains(r.item) && r.size.find("mm") != std::string::npos);
        for (std::sregex_iterator at(text.begin(), text.end(), file), end; at != end; ++at) {
            EXPECT_TRUE(joint().files.contains(at->str())) << at->str();
            named = true;
        }
        EXPECT_TRUE(named) << text;
    }
    std::string bill;
    for (const BillRow& r : joint().bill) bill += r.size + r.note + ";";
    for (const Body* body : bodies_to_make(joint().assembly))
        for (const char* ending : {".stl", "_drawing.svg"}) {
            const std::string name = body->base_name() + (body->side == Side::kAntagonist ? "_mirrored" : "") + ending;
            EXPECT_TRUE(joint().files.contains(name)) << name;
            EXPECT_NE(bill.find(name), std::string::npos) << name;
        }
}

void InStep::plates_screws() {
    std::vector<std::string> hung{"frame_front", "frame_rear", "joint_tower"};
    if (has("k_pe_posts")) hung.push_back("k_pe_posts");
    expect_screwed("frame screw", {"frame_plate"}, hung);
}

void InStep::seats_screws() {
    ASSERT_TRUE(has("k_pe_posts"));
    expect_screwed("seat screw", of_both("k_pe_seat"), {"k_pe_posts"});
}

// Head and washer lie on the bracket around the rod, whose end has the thread.
void InStep::rods_screws() {
    constexpr double kWasher_mm = 0.5;  // ISO 7089, M3: outside diameter 7 mm
    const auto length = numbers(row("rod screw").size, R"(M3 x ([0-9]+) mm)");
    ASSERT_EQ(length.size(), 1U);
    std::size_t ends = 0;
    for (const std::string& rods : of_both("rods"))
        for (const Cylinder& core : of_radius(body(rods), 0.5 * kThreads.at("M3").core, true)) {
            ++ends;
            EXPECT_GE(core.length, length.front() - kWasher_mm) << "the screw ends in its thread";
            const auto outside = of_radius(body(rods), 3.0, false);
            const auto its_own = std::find_if(outside.begin(), outside.end(), [&](const Cylinder& rod) { return coaxial(rod, core); });
            ASSERT_NE(its_own, outside.end());
            std::size_t bored = 0;
            for (const char* bracket : {"frame_front", "frame_rear"})
                for (const Cylinder& bore : of_radius(body(bracket), 3.0, true))
                    if (coaxial(bore, core) && covered(bore, core) > 0.0) {
                        ++bored;
                        EXPECT_NEAR(covered(bore, *its_own), bore.length, 1e-5) << "the rod passes the whole bracket";
                        const double y = core.end.y() < 0.5 * (its_own->end.y() + its_own->other_end().y())
                                             ? std::min(bore.end.y(), bore.other_end().y())
                                             : std::max(bore.end.y(), bore.other_end().y());
                        EXPECT_TRUE(same(its_own->end.y(), y) || same(its_own->other_end().y(), y)) << "flush with the bracket";
                    }
            EXPECT_EQ(bored, 1U);
        }
    EXPECT_EQ(ends, static_cast<std::size_t>(row("rod screw").count));
    EXPECT_EQ(row("rod washer").count, row("rod screw").count);
}

void InStep::links_screws() {
    const BillRow& link = row("link screw");
    const auto circle = numbers(link.note, R"(circle of ([0-9.]+) mm)");
    ASSERT_EQ(circle.size(), 1U) << link.note;
    const solid::Box& pulley = joint().boxes.at("joint_pulley");
    const auto holes = of_radius(body("joint_pulley"), 0.5 * kThreads.at("M3").clearance, true);
    EXPECT_EQ(holes.size(), static_cast<std::size_t>(link.count));
    for (const Cylinder& hole : holes) {
        EXPECT_NEAR(2.0 * std::hypot(hole.end.x(), hole.end.y()), circle.front(), 0.06) << "the bill rounds to 0.1 mm";
        EXPECT_NEAR(hole.length, pulley.high_mm[2] - pulley.low_mm[2], 1e-4);
    }
}

// Pins of the bill's size, each in one hole of its own, and as far out of it as pin and posts need to meet.
void InStep::stop_pins() {
    const auto expect_pins = [&](const std::string& item, const std::string& pins, const std::string& held_by, std::size_t sides = 1) {
        const auto size = numbers(row(item).size, R"(ISO 2338, ([0-9.]+) x ([0-9.]+) mm)");
        ASSERT_EQ(size.size(), 2U) << row(item).size;
        const auto found = of_radius(body(pins), 0.5 * size[0], false);
        ASSERT_EQ(sides * found.size(), static_cast<std::size_t>(row(item).count));
        for (const Cylinder& pin : found) {
            EXPECT_NEAR(pin.length, size[1], 1e-5);
            double held = 0.0;
            for (const Cylinder& hole : of_radius(body(held_by), 0.5 * size[0], true))
                if (coaxial(hole, pin)) held += covered(hole, pin);
            EXPECT_GE(held, size[0] - 1e-5) << item << ": held over its diameter at least";
            EXPECT_LE(held, size[1] - size[0] + 1e-5) << item << ": out of its hole by its diameter at least";
        }
    };
    expect_pins("stop pin", "stop_pin", "joint_pulley");
    expect_pins("stop post", "joint_stops", "joint_tower");
    const auto expect_met = [&](const std::string& pins, const std::string& posts) {
        const solid::Box &pin = joint().boxes.at(pins), &post = joint().boxes.at(posts);
        EXPECT_GE(std::min(pin.high_mm[2], post.high_mm[2]) - std::max(pin.low_mm[2], post.low_mm[2]), 4.0 - 1e-5) << pins << ": over 4 mm";
    };
    expect_met("stop_pin", "joint_stops");
    EXPECT_EQ(has("capstan_pin_agonist"), std::string(GetParam()) != "paper/new_cams") << "which turns its capstans by 496 deg";
    if (!has("capstan_pin_agonist")) return;
    for (const std::string side : {"_agonist", "_antagonist"}) {
        expect_pins("capstan stop pin", "capstan_pin" + side, "capstan" + side, 2);
        expect_pins("capstan stop post", "capstan_stops" + side, "frame_rear", 2);
        expect_met("capstan_pin" + side, "capstan_stops" + side);
    }
}

/// Tension of a cam's cable at an end of its working range [N].
struct Loads {
    double rest, most;
};
Loads tensions(const solid::Part& part) { return {part.cam.working.front().arm.tension, part.cam.working.back().arm.tension}; }

// Length by the file, rate and free length by the bill: the force is that of the law's cable.
void InStep::compression_spring() {
    const auto spring = numbers(row("compression spring").size, R"(^([0-9.]+) N/m.*free length ([0-9.]+) mm)");
    ASSERT_EQ(spring.size(), 2U) << row("compression spring").size;
    const Assembly& a = joint().assembly;
    for (const char* side : {"_agonist", "_antagonist"}) {
        const Body& cap = *a.find(std::string("k_pe_cap") + side);
        const solid::Box &seat = joint().boxes.at(std::string("k_pe_seat") + side), &end = joint().boxes.at(cap.name),
                         &coil = joint().boxes.at(std::string("k_pe_spring") + side);
        EXPECT_NEAR(seat.low_mm[1], coil.high_mm[1], 1e-4) << "it stands on its seat";
        EXPECT_NEAR(end.high_mm[1], coil.low_mm[1], 1e-4) << "and under its cap";
        const auto force = [&](double turn) {
            const Pose pose = pose_of(a, turn, turn, 0.0);
            const Eigen::Vector3d moved = placement(a, cap, pose).translation() - placement(a, cap, {}).translation();
            return 1e-3 * spring[0] * (spring[1] - (seat.low_mm[1] - end.high_mm[1] - moved.y()));
        };
        const Loads law = tensions(*a.drive.k_pe);
        EXPECT_NEAR(force(0.0) / law.rest, 1.0, 1e-3);
        EXPECT_NEAR(force(a.greatest_turn) / law.most, 1.0, 1e-3);
    }
}

// Angle between the legs by the file, that of the unloaded ones by the bill: the torque is that of the law's cable on its arm.
void InStep::torsion_spring() {
    const auto rate = numbers(row("torsion spring").size, R"(^([0-9.]+) Nm/rad)");
    const auto free = numbers(row("torsion spring").note, R"(radial leg is ([0-9]+) deg beyond ([0-9]+) turns)");
    ASSERT_EQ(rate.size(), 1U);
    ASSERT_EQ(free.size(), 2U) << row("torsion spring").note;
    const Assembly& a = joint().assembly;
    const double wire = 0.5e3 * a.drive.k_se_spring.wire_diameter;
    for (const auto& [side, sense] : {std::pair("_agonist", -1.0), std::pair("_antagonist", 1.0)}) {  // left-hand, and its mirror image
        const auto leg = [&](const char* name) { return of_radius(body(std::string(name) + side), wire, false).at(0); };
        const Cylinder axial = leg("leg_in_k_se"), radial = leg("leg_in_carriage");
        const Cylinder axle =
            of_radius(body(std::string("axle_sleeve") + side), 0.5e3 * a.drive.k_se->options.hub.bore_diameter, true).at(0);
        const auto angle = [&](const Vector3d& p) { return std::atan2(p.y() - axle.end.y(), p.x() - axle.end.x()); };
        const Vector3d out =
            (radial.other_end() - axle.end).head<2>().norm() > (radial.end - axle.end).head<2>().norm() ? radial.other_end() : radial.end;
        const double apart = sense * (angle(out) - angle(axial.end)), unloaded = core::rad_from_deg(free[0]);
        const double wound = std::fmod(apart - unloaded + 4.0 * core::kPi, 2.0 * core::kPi);  // less whole turns
        const double turns = std::round((a.drive.k_se_spring.preload - wound) / (2.0 * core::kPi));
        const double rest = wound + 2.0 * core::kPi * turns;
        const Body& spool = *a.find(std::string("k_se") + side);
        const auto turned = [&](double payout) {  // of the spool on its carriage, less whole turns
            const Pose pose{{0.0, payout}, {0.0, payout}};
            const Eigen::Matrix3d by = placement(a, spool, pose).linear() * placement(a, spool, {}).linear().transpose();
            return std::atan2(by(1, 0), by(0, 0));
        };
        const double all = a.drive.k_se->cam.working.back().arm.angle - a.drive.k_se->cam.working.front().arm.angle;
        const auto torque = [&](const cam::ArmPoint& at) { return at.tension * at.arm; };
        EXPECT_NEAR(rate[0] * rest / torque(a.drive.k_se->cam.working.front().arm), 1.0, 5e-3) << "the bill rounds to 1 deg";
        EXPECT_NEAR(rate[0] * (rest + all) / torque(a.drive.k_se->cam.working.back().arm), 1.0, 5e-3);
        const double sign = a.drive.k_se->cam.rotation_sign * (spool.side == Side::kAgonist ? 1.0 : -1.0);
        EXPECT_NEAR(std::remainder(turned(a.greatest_payout_mm) - sign * all, 2.0 * core::kPi), 0.0, 1e-3)
            << "the spool turns by the cam's own angle";
    }
}

/// Solids that one step places, and those that are there before it.
using Placed = std::vector<std::pair<std::string, const Solid*>>;

// A step's bodies come from afar: they must pass whatever is before their place along the way. Nothing is left over.
void InStep::free_paths() {
    const Assembly& a = joint().assembly;
    const auto solids = [&](const Piece& piece, const std::string& side) {
        const std::string name = a.find(piece.body) != nullptr ? piece.body : piece.body + "_" + side;
        const std::vector<Solid>& all = joint().solids.at(name);
        Placed found;
        if (piece.shape < 0)
            for (const Solid& solid : all) found.emplace_back(name, &solid);
        if (piece.shape < 0) return found;
        const Extrusion& shape = a.find(name)->shapes.at(static_cast<std::size_t>(piece.shape));
        const Vector3d middle = placement(a, *a.find(name), {}) * (shape.frame * Vector3d(0.0, 0.0, 0.5 * shape.length_mm));
        const auto away = [&](const Solid& solid) { return (solid.box.center() - middle).norm(); };
        found.emplace_back(name, &*std::min_element(all.begin(), all.end(), [&](auto& p, auto& q) { return away(p) < away(q); }));
        return found;
    };
    std::map<std::string, Placed> subassemblies;  // by subassembly and side
    std::set<const Solid*> placed;
    for (const Step& step : assembly_steps(a))
        for (const std::string side : {"agonist", "antagonist"}) {
            if (side == "antagonist" && a.find(step.pieces.front().body) != nullptr) continue;
            Placed moving;
            for (const Piece& piece : step.pieces)
                for (const auto& one : solids(piece, side)) moving.push_back(one);
            Placed& there = subassemblies[step.subassembly + (step.subassembly == "carriage" ? side : "")];
            for (const auto& [name, solid] : moving)
                for (const auto& [other, fixed] : there) {
                    EXPECT_FALSE(step.along.norm() > 0.0 && is_blocked(*solid, *fixed, step.along)) << name << " meets " << other;
                }
            there.insert(there.end(), moving.begin(), moving.end());
            if (!step.subassembly.empty()) continue;
            for (const auto& one : moving) EXPECT_TRUE(placed.insert(one.second).second) << one.first << " comes twice";
        }
    std::size_t all = 0;
    for (const auto& [name, of_body] : joint().solids) all += of_body.size();
    EXPECT_EQ(placed.size(), all);
}

// The solid of each cam, in its place, has the surface of the mesh that is printed: of a mirror image it would miss by millimetres.
void InStep::cams() {
    const Assembly& a = joint().assembly;
    EXPECT_EQ(a.drive.k_pe_mirrored, std::string(GetParam()) == kMirrored);
    for (const Body& body : a.bodies) {
        if (!body.cam) continue;
        const solid::Mesh mesh = placed_mesh(a, body, {});
        const std::size_t each = std::max<std::size_t>(1, mesh.points_mm.size() / 10);
        for (std::size_t i = 0; i < mesh.points_mm.size(); i += each) {
            const solid::Vec3& p = mesh.points_mm[i];
            const BRepExtrema_DistShapeShape gap(BRepBuilderAPI_MakeVertex({p[0], p[1], p[2]}), *joint().shapes.at(body.name));
            EXPECT_LT(gap.Value(), 0.02) << body.name;
        }
    }
}

TEST_P(InStep, EveryStepHasAFreePath) { free_paths(); }
TEST_P(InStep, TheCamsAreThoseOfTheirSide) { cams(); }
TEST_P(InStep, ThePlatesScrewsEndInThreads) { plates_screws(); }
TEST_P(InStep, TheSeatsScrewsEndInThreads) { seats_screws(); }
TEST_P(InStep, TheRodsScrewsEndInThreads) { rods_screws(); }
TEST_P(InStep, TheLinksScrewsPassThePulley) { links_screws(); }
TEST_P(InStep, StopPinsAreHeldInHoles) { stop_pins(); }
TEST_P(InStep, TheCompressionSpringHasItsLoad) { compression_spring(); }
TEST_P(InStep, TheTorsionSpringHasItsLoad) { torsion_spring(); }

/// Joints of which one body is spoiled, in a STEP file of its own.
class Spoiled : public InStep {
protected:
    /// The joint with one body's shapes changed.
    Made with(const std::string& name, const std::function<void(std::vector<Extrusion>&)>& change) {
        Made made = joint();
        std::vector<Extrusion> shapes = made.assembly.find(name)->shapes;
        change(shapes);
        const core::TemporaryFolder folder;
        const auto path = folder.path() / "spoiled.step";
        exchange::write_step_assembly(
            path, {{name, exchange::brep::extruded(shapes).value().shape, placement(made.assembly, *made.assembly.find(name), {}), {}}},
            "spoiled", "test");
        put(made, exchange::read_step_assembly(path).at(0));
        return made;
    }
    Made moved(const std::string& name, const Vector3d& by) {
        return with(name, [&](auto& shapes) {
            for (Extrusion& shape : shapes) shape.frame = Eigen::Translation3d(by) * shape.frame;
        });
    }
    /// Without the first hole of a radius.
    Made filled(const std::string& name, double radius_mm) {
        return with(name, [&](auto& shapes) {
            for (Extrusion& shape : shapes) {
                const auto hole =
                    std::find_if(shape.holes.begin(), shape.holes.end(), [&](const RoundHole& h) { return same(h.radius_mm, radius_mm); });
                if (hole != shape.holes.end()) return void(shape.holes.erase(hole));
            }
        });
    }
};

INSTANTIATE_TEST_SUITE_P(Pnrvsa, Spoiled, testing::Values("pnrvsa"));

TEST_P(Spoiled, AMissingHoleIsFound) {
    EXPECT_TRUE(fails(filled("frame_plate", 1.7), &Spoiled::plates_screws));
    EXPECT_TRUE(fails(filled("joint_tower", 1.25), &Spoiled::plates_screws));
    EXPECT_TRUE(fails(filled("k_pe_seat_agonist", 1.7), &Spoiled::seats_screws));
    EXPECT_TRUE(fails(filled("rods_antagonist", 1.25), &Spoiled::rods_screws));
    EXPECT_TRUE(fails(filled("joint_pulley", 1.7), &Spoiled::links_screws));
    EXPECT_TRUE(fails(filled("capstan_agonist", 2.0), &Spoiled::stop_pins));
    for (const auto& [body, radius] : {std::pair("frame_front", 3.0), std::pair("carriage_agonist", 6.0), std::pair("frame_rear", 9.5)})
        EXPECT_TRUE(fails(filled(body, radius), &Spoiled::free_paths)) << body;
}

TEST_P(Spoiled, ABodyThatIsAMillimetreAsideIsFound) {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
    EXPECT_TRUE(fails(moved("k_pe_posts", x), &Spoiled::plates_screws));
    EXPECT_TRUE(fails(moved("k_pe_posts", x), &Spoiled::seats_screws));
    EXPECT_TRUE(fails(moved("frame_front", x), &Spoiled::rods_screws));
    EXPECT_TRUE(fails(moved("joint_stops", x), &Spoiled::stop_pins));
    EXPECT_TRUE(fails(moved("capstan_stops_agonist", x), &Spoiled::stop_pins));
    EXPECT_TRUE(fails(moved("k_pe_seat_agonist", y), &Spoiled::compression_spring));
    for (const char* body : {"joint_tower", "frame_rear", "carriage_agonist", "motor_shaft_agonist", "joint_stops"})
        EXPECT_TRUE(fails(moved(body, x), &Spoiled::free_paths)) << body;
    EXPECT_TRUE(fails(moved("leg_in_carriage_agonist", y), &Spoiled::free_paths)) << "out of its slot";
}

TEST_P(Spoiled, ALegElsewhereOrTheOtherCamIsFound) {
    const auto turned = with("leg_in_carriage_agonist", [](auto& shapes) {
        for (Extrusion& shape : shapes) shape.frame = Eigen::AngleAxisd(0.1, Vector3d::UnitZ()) * shape.frame;
    });
    EXPECT_TRUE(fails(turned, &Spoiled::torsion_spring));
    Made swapped = joint();
    std::swap(swapped.shapes.at("k_pe_agonist"), swapped.shapes.at("k_pe_antagonist"));
    EXPECT_TRUE(fails(swapped, &Spoiled::cams));
    for (const auto check : {&Spoiled::free_paths, &Spoiled::cams, &Spoiled::plates_screws, &Spoiled::torsion_spring})
        EXPECT_FALSE(fails(joint(), check)) << "the joint itself";
}

}  // namespace fusee::assembly
