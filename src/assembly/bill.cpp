#include <fmt/format.h>

#include <cmath>
#include <map>

#include "fusee/assembly/motion.h"
#include "fusee/assembly/to_make.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/stack.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

using core::mm_from_m;

std::string sleeve_of(double bore_mm) {
    return fmt::format("{:g} x {:g} mm, as long as the carriage's plate is thick", bore_mm, sleeve_mm(bore_mm));
}

/// Stated, or that of a usual cable.
std::string breaking_text(const checks::Cable& cable) {
    if (cable.breaking_load > 0.0) return fmt::format("breaking load at least {:g} N", cable.breaking_load);
    return fmt::format("breaking load not stated: that of a usual cable, {:.0f} N, is assumed",
                       checks::usual_cable(cable.construction, cable.diameter));
}

double length_of(const Assembly& a, const char* body) {
    const Body& found = *a.find(body);
    double low = INFINITY, high = -INFINITY;
    for (const Prism& prism : found.prisms) low = std::min(low, prism.z_low_mm), high = std::max(high, prism.z_high_mm);
    return high - low;
}

/// "23 mm long" of the tube inside K_PE's spring: the spring's cap stays a gap away where the spring is shortest.
std::string tube_length(const Assembly& a) {
    const spring::BaseSpring& s = a.drive.k_pe_spring;
    const double length = std::floor(mm_from_m(s.free_length - s.preload - a.options.gap) - drawn_mm(a, a.greatest_turn));
    return length > 0.0 ? fmt::format("{:.0f} mm long", length) : "its length not known";
}

/// What stands inside the coils, where the profile states its diameter.
void add_rods(const Assembly& a, std::vector<BillRow>& rows) {
    const double tube = mm_from_m(a.drive.k_pe_spring.rod_diameter), axle = mm_from_m(a.drive.k_se->options.hub.bore_diameter);
    if (a.find("spring_arbor_agonist") != nullptr)
        rows.push_back(
            {"spring arbor", 2,
             fmt::format("sleeve, {:g} x {:g} mm, {:.1f} mm long", axle, arbor_mm(a.drive), length_of(a, "spring_arbor_agonist")),
             "on the spool axle, inside the torsion spring"});
    if (tube > 0.0)
        rows.push_back({"guide tube", 2,
                        fmt::format("{:g} mm, bore of {:.1f} mm at least, {}, {}", tube, 1.5 * a.cable_mm, tube_length(a),
                                    checks::designation_of(a.drive.process)),
                        "bonded to k_pe_seat around its hole, inside the compression spring, the parallel cable through it; not modelled"});
}

/// "M3 x 12 mm": the shortest screw on sale that reaches as far.
std::string m3_screw(double least_mm) {
    constexpr std::array kLengths_mm{5, 6, 8, 10, 12, 16, 20, 25, 30, 35, 40, 45, 50};  // ISO 4762
    const auto sold = std::find_if(kLengths_mm.begin(), kLengths_mm.end(), [&](int mm) { return mm > least_mm - 0.05; });
    return fmt::format("ISO 4762, M3 x {} mm", sold == kLengths_mm.end() ? std::lround(least_mm) : *sold);
}

/// "15 of 3.4 mm (M3), 3 of 19 mm": the plate's holes by diameter.
std::string hole_counts(const Assembly& a) {
    std::map<double, int> counts;
    for (const FrameHole& hole : a.frame_holes) ++counts[hole.diameter_mm];
    std::string text;
    for (const auto& [diameter, count] : counts) text += fmt::format("{}{} of {:g} mm", text.empty() ? "" : ", ", count, diameter);
    return text;
}

/// The files of a body that is made, of both sides.
std::string file_of(const Assembly& a, const std::string& name) {
    const auto both = [&](const char* ending) {
        return name + ending + (a.find(name) != nullptr ? "" : ", " + name + "_mirrored" + ending);
    };
    return both(".stl") + " (format stl), " + both("_drawing.svg") + " (format drawing); in assembly.step, too";
}

void add_frame(const Assembly& a, std::vector<BillRow>& rows) {
    const std::string threads =
        fmt::format("threads M3, {:g} mm deep (core hole {:g} mm), in its upper face", kThread_mm, 2.0 * kCoreHole_mm);
    const Body* plate = a.find("frame_plate");
    if (plate == nullptr) {
        rows.push_back({"frame", 0, "not modelled", "left out; it holds bearings, rods, seats and stop posts; its screws follow it"});
        return;
    }
    const double thick = plate_mm(a);
    rows.push_back(
        {"frame_plate", 1,
         fmt::format(
             "frame_plate.stl (format stl), frame_plate.dxf (format dxf), frame_plate_drawing.svg (format drawing), sheet of {:g} mm, {}",
             thick, material_of(a, *plate).designation),
         "holes: " + hole_counts(a)});
    rows.push_back({"frame_front", 1, file_of(a, "frame_front"), threads});
    rows.push_back({"frame_rear", 1, file_of(a, "frame_rear"), fmt::format("{}; with the inner bearings of the motors' shafts", threads)});
    rows.push_back(
        {"joint_tower", 1, file_of(a, "joint_tower"), fmt::format("{}; with the lower bearing of the joint and the stop posts", threads)});
    if (a.find("k_pe_posts") != nullptr)
        rows.push_back({"k_pe_posts", 1, file_of(a, "k_pe_posts"), fmt::format("two posts, one for each k_pe_seat; {}", threads)});
    const auto screws =
        std::count_if(a.frame_holes.begin(), a.frame_holes.end(), [](const FrameHole& hole) { return hole.holds.starts_with("screw"); });
    rows.push_back({"frame screw", static_cast<int>(screws), m3_screw(thick + kScrewReach_mm),
                    "through frame_plate into the threads of what hangs on it"});
}

/// Largest torque of a motor: both springs of its side [Nm].
double motor_torque(const Assembly& a) {
    double k_pe = 0.0;
    for (const cam::Contact& c : a.drive.k_pe->cam.working) k_pe = std::max(k_pe, c.arm.tension * c.arm.arm);
    return k_pe + tensions(a.drive.k_se->cam)[1] * core::m_from_mm(a.capstan_radius_mm);
}

void add_screws(const Assembly& a, std::vector<BillRow>& rows) {
    const bool frame = a.find("frame_plate") != nullptr, posts = a.find("k_pe_posts") != nullptr;
    const double wall = mm_from_m(a.options.wall);
    rows.push_back({"rod screw", 8, frame ? "ISO 4762, M3 x 8 mm" : "ISO 4762, M3, 6 mm longer than the frame is thick there",
                    "one in a thread in each end of the carriage rods"});
    if (frame) rows.push_back({"rod washer", 8, "ISO 7089, M3", "under each rod screw, on the outer faces of frame_front and frame_rear"});
    rows.push_back(
        {"seat screw", 4, posts ? m3_screw(wall + 8.0) : fmt::format("ISO 4762, M3, {:.0f} mm longer than the frame is thick there", wall),
         posts ? "two in opposite corners of each k_pe_seat, in threads (core hole 2.5 mm) of k_pe_posts"
               : "two in opposite corners of each k_pe_seat; what holds the seats is not modelled: posts are made where K_PE pulls away "
                 "from the joint (assembly.k_pe_direction_deg = -90) past a far enough guide"});
    rows.push_back({"motor coupling", 2,
                    fmt::format("bore {:g} mm for {:g} mm of the motor shaft, {:.2g} Nm at least",
                                mm_from_m(a.drive.k_pe->options.hub.bore_diameter), kMotor_mm, motor_torque(a)),
                    "its bore for the motor follows the motor"});
    rows.push_back({"screws of the motors", 0, "not known", "motors are not modelled: count and size follow them"});
}

/// The dowels of milled half plates.
void add_pins(const solid::Part& part, std::vector<BillRow>& rows) {
    const double pin = mm_from_m(part.options.dowel_diameter);
    if (solid::pin_places(part, pin).empty()) return;
    rows.push_back({"dowel", 4, fmt::format("ISO 8734, {:g} m6 x {:.0f} mm", pin, std::floor(mm_from_m(part.z_high - part.z_low))),
                    fmt::format("two in the half plates of each {}; bonded", to_string(part.cam.kind))});
}

/// The sheets of a part that is a stack of plates, by thickness, and its dowels.
void add_plates(const Assembly& a, const solid::Part& part, std::vector<BillRow>& rows) {
    const checks::Process& process = a.drive.process;
    if (!checks::is_stacked(process) || !solid::is_stack(part.cam, part.options)) return add_pins(part, rows);
    const std::string name = to_string(part.cam.kind);
    const std::vector<solid::Plate> plates = solid::stack_plates(part);
    double height = 0.0;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        height += plates[i].thickness_mm;
        rows.push_back({"sheet", 2, fmt::format("{:g} mm, {}", plates[i].thickness_mm, checks::designation_of(process)),
                        fmt::format("cut by {}_plate_{}.dxf and by {}_mirrored_plate_{}.dxf: the {} of {}", name, i + 1, name, i + 1,
                                    plates[i].name, name)});
    }
    rows.push_back({"dowel", 4, pin_of(solid::kDowel_mm, height),
                    "two in the plates of each " + name + ", whose holes are reamed H7 through the clamped stack; bonded"});
}

constexpr const char* kMirrorImage = "one is the mirror image of the other";

/// "4.8 mm long, cut from 6 mm": keys are sold in the lengths of DIN 6885-1.
std::string key_length(double length_mm) {
    constexpr std::array kLengths_mm{6, 8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 32, 36, 40, 45, 50, 56, 63, 70, 80};
    const auto sold = std::find_if(kLengths_mm.begin(), kLengths_mm.end(), [&](int sold_mm) { return sold_mm > length_mm - 0.05; });
    const std::string length = fmt::format("{:.1f} mm long", length_mm);
    if (sold == kLengths_mm.end() || std::abs(*sold - length_mm) < 0.05) return length;
    return length + fmt::format(", cut from {} mm", *sold);
}

/// "ISO 4026, M3 x 5 mm": the longest on sale that ends in the boss.
std::string set_screw(const solid::HubOptions& hub) {
    constexpr std::array kLengths_mm{2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0};
    const double wall = 0.5 * mm_from_m(hub.boss_diameter - hub.bore_diameter) + 0.05;
    const auto longer = std::upper_bound(kLengths_mm.begin() + 1, kLengths_mm.end(), wall);
    return fmt::format("ISO 4026, M{:g} x {:g} mm", mm_from_m(hub.screw_diameter), *(longer - 1));
}

BillRow key(const solid::HubOptions& hub, double length_mm, const std::string& part) {
    return {"key", 2, fmt::format("DIN 6885-1, {:g} mm wide, {}", mm_from_m(hub.key_width), key_length(length_mm)), "in " + part};
}

/// What carries the torque between a part and its shaft; a D-flat needs no piece.
void add_lock(const solid::Part& part, std::vector<BillRow>& rows) {
    const solid::HubOptions& hub = part.options.hub;
    const std::string name = to_string(part.cam.kind);
    const bool blind = hub.kind == solid::HubKind::kOverhung;
    const double length = mm_from_m(hub.boss_height + (blind ? part.options.groove.rib - hub.web : part.z_high - part.z_low));
    if (hub.lock == solid::HubLock::kKeyway) rows.push_back(key(hub, length, name));
    if (hub.lock == solid::HubLock::kSetScrew)
        rows.push_back({"set screw", 2, set_screw(hub), "in the boss of " + name + ", on the flat of its shaft"});
}

/// A drum is locked by a key where K_PE on the motor's shaft is, else by the flat. @param floor_mm radius of its floor
void add_drum_lock(const Assembly& a, const std::string& name, double floor_mm, double length_mm, int count, std::vector<BillRow>& rows) {
    const solid::HubOptions& hub = a.drive.k_pe->options.hub;
    if (hub.lock != solid::HubLock::kKeyway) return;
    rows.push_back(key(hub, length_mm,
                       drum_has_lock(hub, floor_mm) ? name : name + "; its keyway is not modelled: less than 1 mm would be left over it"));
    rows.back().count = count;
}

/// What holds the joint's pulley on its shaft, and the output link on the pulley.
void add_pulley(const Assembly& a, std::vector<BillRow>& rows) {
    const double floor = a.joint_radius_mm - 0.5 * a.cable_mm, thick = 2.0 * a.find("joint_pulley")->prisms.at(4).z_high_mm;
    add_drum_lock(a, "the joint's pulley", floor, thick, 1, rows);
    if (const LinkHoles link = link_holes(a.drive.k_pe->options.hub, floor); link.count > 0)
        rows.push_back({"link screw", link.count,
                        fmt::format("ISO 4762, M3, {:.1f} mm longer than the output link is thick there", thick + 4.0),
                        fmt::format("with a nut M3 (ISO 4032) each, in the holes of the joint's pulley on a circle of {:.1f} mm",
                                    2.0 * link.circle_mm)});
}

/// ", with a flat 0.5 mm deep", or its keyways; "" of a plain shaft, or where the table has no key.
std::string flat_of(const solid::HubOptions& hub) {
    const checks::KeySize* size = hub.lock == solid::HubLock::kKeyway ? checks::key_size(hub.bore_diameter) : nullptr;
    if (size)
        return fmt::format(", keyways {:g} mm wide and {:g} mm deep under its keys", mm_from_m(hub.key_width),
                           mm_from_m(size->shaft_depth));
    return on_shaft(hub).lock == solid::HubLock::kDFlat ? fmt::format(", with a flat {:g} mm deep", mm_from_m(hub.flat_depth)) : "";
}

/// ", turned down to 5 mm over the upper 31.3 mm, for the spring"; "" where the axle is as thick inside it.
std::string neck_of(const Assembly& a) {
    const double axle = mm_from_m(a.drive.k_se->options.hub.bore_diameter), arbor = arbor_mm(a.drive);
    if (!has_through_axle(*a.drive.k_se) || arbor >= axle) return "";
    const std::vector<Prism>& prisms = a.find("axle_agonist")->prisms;
    return fmt::format(", turned down to {:g} mm over the upper {:.1f} mm, for the spring", arbor,
                       prisms.back().z_high_mm - prisms.back().z_low_mm);
}

/// One below the sleeve of each axle, and one at the end of a through axle.
void add_rings(const Assembly& a, double axle, std::vector<BillRow>& rows) {
    const double end = std::min(axle, arbor_mm(a.drive));
    const auto add = [&](int count, double size, const char* note) {
        rows.push_back({"retaining ring", count, fmt::format("DIN 471, {:g} x {:g} mm", size, ring_mm(size)), note});
    };
    if (!has_through_axle(*a.drive.k_se)) return add(2, axle, "one for each spool axle");
    if (end == axle) return add(4, axle, "two for each spool axle");
    add(2, axle, "one for each spool axle, below"), add(2, end, "one for each spool axle, above");
}

/// Pins in pulley and frame. Without a frame nothing decides how deep the posts are in what holds them.
void add_stops(const Assembly& a, std::vector<BillRow>& rows) {
    const auto posts = static_cast<int>(a.find("joint_stops")->prisms.size());
    const bool pressed = a.find("stop_pin") != nullptr, frame = a.find("frame_plate") != nullptr;
    if (pressed)
        rows.push_back(
            {"stop pin", 1, pin_of(2.0 * kStop_mm, length_of(a, "stop_pin")), "pressed into the joint's pulley, down to its web"});
    rows.push_back({"stop post", posts,
                    frame ? pin_of(2.0 * kStop_mm, length_of(a, "joint_stops")) : fmt::format("ISO 2338, {:g} mm", 2.0 * kStop_mm),
                    frame ? fmt::format("pressed into joint_tower, {:g} mm deep", kStopOverlap_mm)
                          : fmt::format("in the frame, {:g} mm out of it: its length depends on the frame", kStopOverlap_mm)});
    if (!pressed) rows.back().note += "; the pulley's own pin is part of it";
}

/// The capstans' stops, or where whoever builds the frame puts them.
void add_stops_of_capstans(const Assembly& a, std::vector<BillRow>& rows) {
    const Body* posts = a.find("capstan_stops_agonist");
    if (posts == nullptr) {
        const char* why =
            a.find("frame_plate") == nullptr ? "no frame" : "it turns too far for a pin, or capstan and frame_rear have no room for one";
        rows.push_back({"capstan stop", 0, "not modelled",
                        fmt::format("{}: stop each motor at {:.1f} and {:.1f} deg of its capstan from the lowest load, positive where its "
                                    "springs are loaded",
                                    why, core::deg_from_rad(-a.spare_turn), core::deg_from_rad(a.greatest_turn + a.spare_turn))});
        return;
    }
    rows.push_back({"capstan stop pin", 2, pin_of(2.0 * kStop_mm, length_of(a, "capstan_pin_agonist")),
                    "pressed into each capstan from below, up to its upper flange"});
    rows.push_back({"capstan stop post", static_cast<int>(2 * posts->prisms.size()),
                    pin_of(2.0 * kStop_mm, length_of(a, "capstan_stops_agonist")), "pressed through the arms of frame_rear, flush below"});
}

/// Of a carriage's rods.
double rod_length_mm(const Assembly& a) {
    double low = INFINITY, high = -INFINITY;
    for (const solid::Point2& p : a.find("rods_agonist")->prisms.front().outline_mm) low = std::min(low, p[1]), high = std::max(high, p[1]);
    return high - low;
}

void add_shafts(const Assembly& a, std::vector<BillRow>& rows) {
    const double shaft = mm_from_m(a.drive.k_pe->options.hub.bore_diameter), axle = mm_from_m(a.drive.k_se->options.hub.bore_diameter);
    const bool frame = a.find("frame_plate") != nullptr;
    for (const char* side : {"agonist", "antagonist"}) {
        const double length = length_of(a, (std::string("motor_shaft_") + side).c_str());
        const std::string size = fmt::format("{:g} mm, {:.1f} mm long{}", shaft, length, flat_of(a.drive.k_pe->options.hub));
        if (rows.back().size == size)
            rows.back().count = 2;
        else
            rows.push_back({"motor shaft", 1, size, std::string("h6, ") + shaft_steel(motor_shaft_load(a))});
        if (frame) rows.back().note += fmt::format("; {}", side);
    }
    rows.push_back(
        {"spool axle", 2,
         fmt::format("{:g} mm, {:.1f} mm long{}{}", axle, length_of(a, "axle_agonist"), flat_of(a.drive.k_se->options.hub), neck_of(a)),
         std::string("h6, ") + shaft_steel(axle_load(a)) +
             (has_through_axle(*a.drive.k_se) ? "" : "; ends in the blind bore of k_se, bonded")});
    rows.push_back({"joint shaft", 1,
                    fmt::format("{:g} mm{}{}", shaft, frame ? fmt::format(", {:.1f} mm long", length_of(a, "joint_shaft")) : "",
                                flat_of(a.drive.k_pe->options.hub)),
                    frame ? std::string("h6, ") + shaft_steel(joint_shaft_load(a)) : "its length depends on the frame"});
    rows.push_back(
        {"ball bearing", 6, bearing_of(shaft),
         frame ? fmt::format(
                     "seats {:g} H7, bored out after the cut or the print: three in frame_plate, two in frame_rear, one in joint_tower",
                     bearing_seat_mm(shaft))
               : "two for each motor shaft and the joint"});
    rows.push_back({"sleeve bearing", 2, sleeve_of(axle), "ISO 2795, one for each spool axle, in the carriage"});
    add_rings(a, axle, rows);
    const Collar collar = collar_of(shaft);
    rows.push_back({"set collar", 2, fmt::format("DIN 705, {:g} x {:g} x {:g} mm", shaft, collar.outside_mm, collar.width_mm),
                    "on each motor shaft, beside the capstan"});
    add_stops(a, rows);
    add_stops_of_capstans(a, rows);
    rows.push_back(
        {"carriage rod", 4, fmt::format("{:g} mm, {:.1f} mm long", 2.0 * kRod_mm, rod_length_mm(a)),
         fmt::format("hardened, h6; threads M3, {:g} mm deep (core hole {:g} mm), in both ends", kRodThread_mm, 2.0 * kCoreHole_mm)});
    rows.push_back({"linear bush", 8, "ISO 10285, 6 x 12 x 19 mm", "pressed into the housings of the carriages"});
    rows.push_back({"support washers", 2,
                    fmt::format("DIN 988, {:g} x {:g} mm, together {:g} mm thick", axle, washer_mm(axle), mm_from_m(a.options.gap)),
                    "on each spool axle, between carriage and k_se"});
}

}  // namespace

std::vector<BillRow> bill_of(const Assembly& a) {
    std::vector<BillRow> rows;
    for (const std::string name : {"k_se", "k_pe"})
        for (const bool image : {false, true}) {
            const char* swapped = image ? "; on the agonist's side" : "; on the antagonist's side";
            rows.push_back({name + (image ? "_mirrored" : ""), 1, "",
                            std::string("made by fusee") + (name == "k_pe" && a.drive.k_pe_mirrored ? swapped : "")});
        }
    for (const auto& part : {a.drive.k_se, a.drive.k_pe}) add_plates(a, *part, rows);
    for (const char* name : {"capstan", "carriage", "k_pe_seat", "k_pe_cap"})
        if (a.find(std::string(name) + "_agonist") != nullptr) {
            const std::string edge = edge_note(a, name);
            rows.push_back({name, 2, file_of(a, name), kMirrorImage + (edge.empty() ? "" : "; " + edge)});
        }
    add_frame(a, rows);
    rows.push_back({"joint_pulley", 1, file_of(a, "joint_pulley"), ""});
    for (BillRow& row : spring_rows(a)) rows.push_back(std::move(row));
    for (const Cable& cable : a.cables)
        if (cable.side == Side::kAgonist)
            rows.push_back({std::string(to_string(cable.kind)) + " cable", 2,
                            fmt::format("{:g} mm {}, cut to {:.0f} mm", a.cable_mm, a.drive.cable.construction, cable.cut_mm()),
                            fmt::format("{:.1f} mm from anchor to anchor, {:g} mm for the {} at each end; {}", cable.length_mm,
                                        kCableEnd_mm, checks::to_string(a.drive.cable.termination), breaking_text(a.drive.cable))});
    add_shafts(a, rows);
    add_rods(a, rows);
    add_screws(a, rows);
    add_lock(*a.drive.k_se, rows);
    add_lock(*a.drive.k_pe, rows);
    add_drum_lock(a, "the capstan", a.capstan_radius_mm - 0.5 * a.cable_mm, length_of(a, "capstan_agonist"), 2, rows);
    add_pulley(a, rows);
    return rows;
}

std::vector<const Body*> bodies_to_make(const Assembly& a) {
    std::vector<const Body*> made;
    for (const Body& body : a.bodies)
        if (body.made) made.push_back(&body);
    return made;
}

}  // namespace fusee::assembly
