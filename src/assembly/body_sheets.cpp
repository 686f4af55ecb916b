#include <fmt/format.h>

#include <cmath>
#include <map>

#include "fusee/assembly/to_make.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

constexpr double kCoincide_mm = 1e-6;

bool is_same(double a_mm, double b_mm) { return std::abs(a_mm - b_mm) < kCoincide_mm; }

/// Does a line through a point of a body's shape, along that shape, pass `at`?
bool passes(const Assembly& a, const char* body, const Eigen::Vector3d& at) {
    const Body* found = a.find(body);
    if (found == nullptr) return false;
    return std::any_of(found->shapes.begin(), found->shapes.end(), [&](const Extrusion& shape) {
        const Eigen::Vector3d local = (found->rest * shape.frame).inverse() * at;
        return std::hypot(local.x(), local.y()) < kCoincide_mm;
    });
}

bool is_along_y(const drawing::BodyHole& hole) { return !is_same(hole.from_mm.y(), hole.to_mm.y()); }

std::string use_in_frame(const Assembly& a, const drawing::BodyHole& hole) {
    if (is_same(hole.radius_mm, kCoreHole_mm)) return "thread M3";
    if (is_along_y(hole)) {
        const bool rod = passes(a, "rods_agonist", hole.from_mm) || passes(a, "rods_antagonist", hole.from_mm);
        return rod ? "rod, reamed H7" : "cable passes";
    }
    if (is_same(hole.radius_mm, 0.5 * bearing_seat_mm(core::mm_from_m(a.drive.k_pe->options.hub.bore_diameter))))
        return "bearing, bored H7";
    for (const char* pins : {"joint_stops", "capstan_stops_agonist", "capstan_stops_antagonist"})
        if (passes(a, pins, hole.from_mm)) return "stop pin, reamed H7";
    return "shaft passes";
}

std::string use_in_plate(const Assembly& a, const drawing::BodyHole& hole) {
    for (const FrameHole& h : a.frame_holes)
        if (is_same(h.x_mm, hole.from_mm.x()) && is_same(h.y_mm, hole.from_mm.y()))
            return h.holds + (h.holds.starts_with("bearing") ? ", bored H7" : "");
    return "";
}

std::string use_in_carriage(const Assembly&, const drawing::BodyHole& hole) {
    if (!is_along_y(hole)) return "sleeve bearing, reamed H7";
    return is_same(hole.radius_mm, kBush_mm) ? "linear bush, reamed H7" : "cable passes";
}

std::string use_elsewhere(const Assembly&, const drawing::BodyHole& hole) {
    if (is_same(hole.radius_mm, kScrewHole_mm)) return "screw M3 passes";
    return is_same(hole.radius_mm, kStop_mm) ? "stop pin, reamed H7" : "cable passes";
}

/// What the sheet of a body says beside its holes.
struct Kind {
    const char *title, *axis;
    std::string (*use)(const Assembly&, const drawing::BodyHole&);
};
const std::map<std::string, Kind> kKinds{
    {"frame_front", {"frame: front bracket", "the joint's axis", use_in_frame}},
    {"frame_rear", {"frame: rear bracket", "the joint's axis", use_in_frame}},
    {"joint_tower", {"frame: joint's tower", "the joint's axis", use_in_frame}},
    {"k_pe_posts", {"frame: posts of K_PE's seats", "the joint's axis", use_in_frame}},
    {"frame_plate", {"frame: plate", "the joint's axis", use_in_plate}},
    {"carriage", {"carriage of K_SE", "K_SE's axis", use_in_carriage}},
    {"capstan", {"capstan", "its axis", use_elsewhere}},
    {"joint_pulley", {"joint's pulley", "its axis", use_elsewhere}},
    {"k_pe_seat", {"seat of K_PE's spring", "the cable", use_elsewhere}},
    {"k_pe_cap", {"cap of K_PE's spring", "the cable", use_elsewhere}},
};

/// ", along the radius from K_SE's axis at 171.2 deg from +x": as the post and the leg in it stand.
std::string slot_angle(const Assembly& a, const Body& carriage) {
    const Body* leg = a.find("leg_in_" + carriage.name);
    if (leg == nullptr) return "";
    const Eigen::Vector3d along = leg->rest.linear() * leg->shapes.front().frame.linear().col(2);
    return fmt::format(", along the radius from K_SE's axis at {:.1f} deg from +x",
                       core::deg_from_rad(core::within_turn(std::atan2(along.y(), along.x()), 0.0)));
}

std::vector<std::string> notes_of(const Assembly& a, const Body& body) {
    const std::string name = body.base_name();
    std::vector<std::string> notes;
    if (name == "frame_rear" || name == "joint_tower")
        notes.emplace_back("Bore the bearing seats with the body screwed to frame_plate, in line with the seats there.");
    if (name == "capstan" || name == "joint_pulley") {
        const double pitch = name == "capstan" ? a.capstan_radius_mm : a.joint_radius_mm;
        notes.push_back(
            fmt::format("Groove's floor R {:g}: the cable of {:g} mm lies at R {:g}. An error of 0.1 mm is one of {:.2g} % of "
                        "its arm.",
                        pitch - 0.5 * a.cable_mm, a.cable_mm, pitch, 10.0 / pitch));
    }
    if (name == "carriage" && a.leg_slot.width_mm > 0.0)
        notes.push_back(fmt::format("Slot of the post for the spring's leg: {:.1f} mm wide, {:.1f} mm deep{}.", a.leg_slot.width_mm,
                                    a.leg_slot.top_mm - a.leg_slot.floor_mm, slot_angle(a, body)));
    if (name == "frame_plate") notes.emplace_back("Outline as in frame_plate.dxf (format dxf).");
    if (const std::string edge = edge_note(a, name); !edge.empty()) notes.push_back("R" + edge.substr(1) + ".");
    return notes;
}

}  // namespace

std::string edge_note(const Assembly& a, const std::string& body) {
    const solid::Part& part = body == "carriage" ? *a.drive.k_se : *a.drive.k_pe;
    if ((body != "carriage" && body != "k_pe_seat") || part.cam.options.guide.kind == cam::GuideKind::kIdler) return "";
    return fmt::format("round the edges of the hole for the cable by hand: R {:g} mm",
                       guide_edge_mm(a.cable_mm, core::mm_from_m(a.options.wall)));
}

drawing::SheetBody sheet_of(const Assembly& a, const Body& body) {
    const Kind& kind = kKinds.at(body.base_name());
    drawing::SheetBody sheet{body.shapes, kind.title,
                             kind.axis,   [&a, &kind](const drawing::BodyHole& hole) { return kind.use(a, hole); },
                             kChordal_mm, notes_of(a, body)};
    if (body.side == Side::kAntagonist) sheet.title += ", mirrored";
    if (kind.axis == std::string_view("the cable")) sheet.shapes.front().frame = Eigen::Isometry3d::Identity();  // one plate, from above
    const solid::HubOptions& hub = a.drive.k_pe->options.hub;
    const double floor = (body.base_name() == "capstan" ? a.capstan_radius_mm : a.joint_radius_mm) - 0.5 * a.cable_mm;
    sheet.locked = drum_has_lock(hub, floor);
    return sheet;
}

}  // namespace fusee::assembly
