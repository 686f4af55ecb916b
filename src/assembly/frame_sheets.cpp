#include <cmath>

#include "fusee/assembly/to_make.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

constexpr double kCoincide_mm = 1e-6;

/// Does a line through a point of a body's shape, along that shape, pass `at`?
bool passes(const Assembly& a, const char* body, const Eigen::Vector3d& at) {
    const Body* found = a.find(body);
    if (found == nullptr) return false;
    return std::any_of(found->shapes.begin(), found->shapes.end(), [&](const Extrusion& shape) {
        const Eigen::Vector3d local = (found->rest * shape.frame).inverse() * at;
        return std::hypot(local.x(), local.y()) < kCoincide_mm;
    });
}

/// What a hole of the frame's printed bodies is for, with its fit.
std::string use_of(const Assembly& a, const drawing::BodyHole& hole) {
    const double seat = 0.5 * bearing_seat_mm(core::mm_from_m(a.drive.k_pe->options.hub.bore_diameter));
    const auto has_radius = [&](double mm) { return std::abs(hole.radius_mm - mm) < kCoincide_mm; };
    const bool along_y = std::abs(hole.from_mm.y() - hole.to_mm.y()) > kCoincide_mm;
    if (has_radius(kCoreHole_mm)) return "thread M3";
    if (along_y) {
        const bool rod = passes(a, "rods_agonist", hole.from_mm) || passes(a, "rods_antagonist", hole.from_mm);
        return rod ? "rod, reamed H7" : "cable passes";
    }
    if (has_radius(seat)) return "bearing, bored H7";
    for (const char* pins : {"joint_stops", "capstan_stops_agonist", "capstan_stops_antagonist"})
        if (passes(a, pins, hole.from_mm)) return "stop pin, reamed H7";
    return "shaft passes";
}

}  // namespace

std::vector<FrameSheet> frame_sheets(const Assembly& a) {
    struct Named {
        const char *name, *title;
    };
    std::vector<FrameSheet> all;
    for (const Named& one : {Named{"frame_front", "frame: front bracket"}, Named{"frame_rear", "frame: rear bracket"},
                             Named{"joint_tower", "frame: joint's tower"}, Named{"k_pe_posts", "frame: posts of K_PE's seats"}}) {
        const Body* body = a.find(one.name);
        if (body == nullptr) continue;
        drawing::SheetBody sheet{body->shapes, one.title, [&a](const drawing::BodyHole& hole) { return use_of(a, hole); }, kChordal_mm, {}};
        if (std::string_view(one.name) == "frame_rear" || std::string_view(one.name) == "joint_tower")
            sheet.notes.emplace_back("Bore the bearing seats with the body screwed to frame_plate, in line with the seats there.");
        all.push_back({body, std::move(sheet)});
    }
    return all;
}

}  // namespace fusee::assembly
