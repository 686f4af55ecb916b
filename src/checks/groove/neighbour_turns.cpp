#include <limits>

#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kPsiStep = core::kPi / 180.0;  // between surface points
constexpr std::size_t kComparedContacts = 60;   // working positions that are checked
constexpr double kSpacing = 0.25;               // of surface points along the section, in d

struct SurfacePoint {
    double x, y, z, psi;
};

/// The groove's section with half of the land on both sides, densely sampled: offsets along n and heights [m].
std::vector<std::array<double, 2>> dense_section(const solid::Part& part, double spacing) {
    std::vector<std::array<double, 2>> corners;
    for (const solid::SectionPoint& s : part.section) corners.push_back({m_from_mm(s.offset_mm), m_from_mm(s.z_mm)});
    const double land = 0.5 * part.options.groove.rib;
    corners.insert(corners.begin(), {corners.front()[0], corners.front()[1] - land});
    corners.push_back({corners.back()[0], corners.back()[1] + land});
    std::vector<std::array<double, 2>> dense{corners.front()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const auto &a = corners[i - 1], &b = corners[i];
        const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(b[0] - a[0], b[1] - a[1]) / spacing)));
        for (int k = 1; k <= steps; ++k) dense.push_back({a[0] + (b[0] - a[0]) * k / steps, a[1] + (b[1] - a[1]) * k / steps});
    }
    return dense;
}

std::vector<SurfacePoint> surface(const Design& design) {
    const auto section = dense_section(design.part, kSpacing * design.cable.diameter);
    std::vector<SurfacePoint> points;
    double last = -std::numeric_limits<double>::infinity();
    for (const cam::PathPoint& p : contour(design.part.cam)) {
        if (p.psi - last < kPsiStep) continue;
        last = p.psi;
        const double c = std::cos(p.psi), s = std::sin(p.psi);
        for (const auto& [offset, z] : section)
            points.push_back({(p.h + offset) * c - p.slope * s, (p.h + offset) * s + p.slope * c, p.z + z, p.psi});
    }
    return points;
}

/// Clearance between the free cable of one contact and the other turns; infinite if no turn is near. `turns`: distance of the nearest one
/// along the groove.
struct Clearance {
    double least = std::numeric_limits<double>::infinity();
    double turns = 0.0;
    const cam::Contact* contact = nullptr;
};

Clearance clearance_at(const Design& design, const cam::Contact& contact, const std::vector<SurfacePoint>& points) {
    const cam::PathPoint& p = contact.path;
    const int sign = design.part.cam.options.torque_sign;  // the cable leaves along sign * t: its tension then has that torque
    const double c = std::cos(p.psi), s = std::sin(p.psi), radius = 0.5 * design.cable.diameter, rise = std::tan(contact.fleet);
    const double end = contact.span > 0.0 ? contact.span : std::numeric_limits<double>::infinity();
    Clearance found;
    found.contact = &contact;
    for (const SurfacePoint& q : points) {
        if (std::abs(q.psi - p.psi) <= core::kPi) continue;  // the cable's own turn
        const double along = sign * (-q.x * s + q.y * c - p.slope);
        if (along <= 0.0 || along > end) continue;
        const double above = q.x * c + q.y * s - p.h, height = q.z - p.z - along * rise;
        // For a surface point beyond the cable's line only the height difference counts.
        const double clearance = (above >= 0.0 ? std::abs(height) : std::hypot(above, height)) - radius;
        if (clearance < found.least) found.least = clearance, found.turns = std::abs(q.psi - p.psi) / (2.0 * core::kPi);
    }
    return found;
}

core::Findings measure_groove_neighbour_turns(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.closed() || cam.working.empty() || design.part.section.empty()) return {};
    const std::vector<SurfacePoint> points = surface(design);
    const std::size_t stride = std::max<std::size_t>(1, cam.working.size() / kComparedContacts);
    Clearance tightest;
    for (std::size_t i = 0; i < cam.working.size(); i += stride)
        if (const Clearance at = clearance_at(design, cam.working[i], points); at.least < tightest.least) tightest = at;
    if (!tightest.contact) return {};
    core::Finding f = compare(mm_from_m(tightest.least), {allowed("required")});
    f.what = "clearance between the free cable and the lips of the other turns";
    locate(f, design, tightest.contact->path);
    f.suggestion =
        change(design, "path.pitch_mm", up(mm_from_m(cam.options.path.pitch) + (f.allowed - f.measured) / std::max(tightest.turns, 0.5)));
    if (cam.options.path.lead == cam::Lead::kAimedAtGuide)
        f.suggestion = fmt::format("the turns {} mm farther apart: a larger {}, now {:.3g}", up(f.allowed - f.measured),
                                   key_of(design, "guide.z_mm"), mm_from_m(cam.options.guide.z));
    return {f};
}

}  // namespace

Rule groove_neighbour_turns() {
    return {"groove.neighbour_turns",
            "the free cable striking a larger neighbouring turn",
            "helix: least clearance between free cable and the other turns, 60 positions",
            "geometry: free cable against the groove's surface",
            {required(kAtLeast, "mm", 0.0)},
            measure_groove_neighbour_turns};
}

}  // namespace fusee::checks
