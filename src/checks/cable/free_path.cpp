#include <limits>
#include <vector>

#include "means.h"

namespace fusee::checks {

namespace {

constexpr std::size_t kContacts = 24;  // working positions that are checked
constexpr double kStart = 0.05;        // of d: the cable is traced from this distance off its contact

/// Where the free cable's centreline crosses the mesh: first and last distance from the contact [mm].
struct Crossing {
    double first = std::numeric_limits<double>::infinity(), last = 0.0;
    bool leaves_first = false;  ///< the first crossing leads out of the part: the cable starts inside
    [[nodiscard]] double length() const { return leaves_first ? last : last > first ? last - first : 0.0; }
};

/// A vertex seen along the cable: across (two coordinates) and along [mm].
struct Seen {
    double across, up, along;
};

Crossing cross(const Design& design, const cam::Contact& contact, std::vector<Seen>& seen) {
    const cam::PathPoint& p = contact.path;
    const int sign = design.part.cam.options.torque_sign;  // the cable leaves along sign * t: its tension then has that torque
    const double c = std::cos(p.psi), s = std::sin(p.psi), rise = std::tan(contact.fleet);
    const double h = mm_from_m(p.h), slope = mm_from_m(p.slope), z = mm_from_m(p.z);
    const solid::Mesh& mesh = design.part.mesh;
    for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
        const auto& q = mesh.points_mm[i];
        const double along = sign * (-q[0] * s + q[1] * c - slope);
        seen[i] = {q[0] * c + q[1] * s - h, q[2] - z - along * rise, along};
    }
    const double begin = kStart * mm_from_m(design.cable.diameter);
    const double end = contact.span > 0.0 ? mm_from_m(contact.span) : std::numeric_limits<double>::infinity();
    const auto side = [](const Seen& a, const Seen& b) { return a.across * b.up - a.up * b.across; };
    Crossing crossing;
    for (const solid::Triangle& t : mesh.triangles) {
        const Seen &a = seen[t[0]], &b = seen[t[1]], &d = seen[t[2]];
        const double wd = side(a, b), wa = side(b, d), wb = side(d, a), area = wa + wb + wd;
        const bool inside = (wa >= 0.0 && wb >= 0.0 && wd >= 0.0) || (wa <= 0.0 && wb <= 0.0 && wd <= 0.0);
        if (!inside || area == 0.0) continue;
        const double along = (wa * a.along + wb * b.along + wd * d.along) / area;
        if (along < begin || along > end) continue;
        // (n, z, t) is left-handed: seen along +t an outward face that the cable leaves through has a negative area.
        if (along < crossing.first) crossing.leaves_first = sign * area < 0.0;
        crossing.first = std::min(crossing.first, along);
        crossing.last = std::max(crossing.last, along);
    }
    return crossing;
}

core::Findings measure_cable_free_path(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.working.empty() || design.part.mesh.triangles.empty()) return {};
    std::vector<Seen> seen(design.part.mesh.points_mm.size());
    const std::size_t stride = std::max<std::size_t>(1, (cam.working.size() - 1) / kContacts);
    const cam::Contact* worst = &cam.working.front();
    double longest = 0.0;
    for (std::size_t i = 0; i < cam.working.size(); i += stride)
        if (const double length = cross(design, cam.working[i], seen).length(); length > longest) longest = length, worst = &cam.working[i];
    core::Finding f = compare(longest, {allowed("required")});
    f.what = "length of the free cable inside the part";
    locate(f, design, worst->path);
    double reach = 0.0;
    for (const auto& q : design.part.mesh.points_mm) reach = std::max(reach, std::hypot(q[0], q[1]));
    const double leaves = std::acos(std::clamp(mm_from_m(worst->path.h) / reach, 0.0, 1.0));  // direction in which it passes the rim
    f.suggestion = change(design, "path.margin_deg", up(deg_from_rad(leaves))).noted(": a groove open as far as the rim");
    return {f};
}

}  // namespace

Rule cable_free_path() {
    return {"cable.free_path",
            "the part blocking its own cable",
            "longest piece of a free cable's centreline inside the mesh, 24 positions",
            "geometry: free cable against the mesh",
            {required(kAtMost, "mm", 0.0)},
            measure_cable_free_path,
            nullptr,
            {},
            true};
}

}  // namespace fusee::checks
