#include <limits>
#include <vector>

#include "fusee/core/lists.h"
#include "means.h"

namespace fusee::checks {

namespace {

constexpr int kSteps = 32;

core::Findings measure_cable_anchor_tail(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (!cam.path || cam.working.empty()) return {};
    const cam::Contact& nearest = worst_contact(cam, [&cam](const cam::Contact& c) { return -wound_angle(cam, c); });
    const double angle = wound_angle(cam, nearest), step = cam.options.torque_sign * angle / kSteps;
    double length = 0.0;
    for (int i = 0; i < kSteps; ++i) length += cam.path(cam.anchor_psi + (i + 0.5) * step).rho * angle / kSteps;
    core::Finding f = compare(mm_from_m(length), {allowed("review", mm_from_m(2.0 * design.cable.diameter))});
    f.what = "length of cable that stays wound between its anchor and the working arc";
    f.where = at_anchor(design);
    f.suggestion = change(design, "path.margin_deg", up(deg_from_rad(cam.options.path.margin) * f.allowed / f.measured));
    return {f};
}

constexpr double kMost = 4.0;  // [deg]

core::Findings measure_cable_fleet(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Contact& worst = worst_contact(cam, [&](const cam::Contact& c) { return std::abs(fleet_from_groove(cam, c)); });
    const bool own = design.cable.max_fleet > 0.0;
    const bool aimed = !cam.closed() && cam.options.path.lead == cam::Lead::kAimedAtGuide;
    const double fleet = deg_from_rad(std::abs(fleet_from_groove(cam, worst)));
    core::Finding f = own ? compare(fleet, {allowed("required", deg_from_rad(design.cable.max_fleet))})
                          : compare(fleet, {allowed("required", kMost), allowed("review")});
    f.what = fmt::format("largest fleet angle{}; the arm in the plane is longer by 1/{:.5f}",
                         aimed ? ", from the direction of the groove" : "", std::cos(worst.fleet));
    locate(f, design, worst.path);
    const double tangent = std::tan(rad_from_deg(f.allowed)), farther = std::abs(std::tan(worst.fleet)) / tangent;
    f.suggestion = change(design, "guide.distance_mm", up(mm_from_m(cam.options.guide.distance + worst.span * (farther - 1.0))))
                       .noted(fmt::format(": a free cable of {} mm there", up(mm_from_m(worst.span * farther))));
    if (!cam.closed() && cam.options.path.lead == cam::Lead::kConstantPitch && cam.working.size() > 1) {
        const double middle = 0.5 * (cam.working.front().path.z + cam.working.back().path.z);
        if (std::abs(cam.options.guide.z - middle) > 0.5 * cam.options.path.pitch)
            f.suggestion.or_else(change(design, "guide.z_mm", number(mm_from_m(middle), 3)).noted(": the guide at half height"));
    }
    if (own) f.source = "cable.max_fleet_deg";
    return {f};
}

core::Findings measure_cable_fleet_side(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const auto fleet = [&cam](const cam::Contact& c) { return fleet_from_groove(cam, c); };
    const cam::Contact& high = worst_contact(cam, fleet);
    const cam::Contact& low = worst_contact(cam, [&](const cam::Contact& c) { return -fleet(c); });
    const double above = std::max(0.0, fleet(high)), below = std::max(0.0, -fleet(low));
    const cam::Contact& worst = above > below ? high : low;
    core::Finding f = compare(deg_from_rad(std::abs(above - below)), {allowed("review")});
    f.what = fmt::format("fleet angle {:.2f} deg upwards, {:.2f} deg downwards: the guide is off the middle of the groove",
                         deg_from_rad(above), deg_from_rad(below));
    locate(f, design, worst.path);
    f.suggestion =
        change(design, "guide.z_mm", number(mm_from_m(cam.options.guide.z - worst.span * std::tan(0.5 * (high.fleet + low.fleet))), 3));
    return {f};
}

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

constexpr double kGuide_mm = 200.0;  // distance of a guide that had no place

/// A parallel guide has no point to aim at.
core::Suggestion aimed_change(const Design& design) {
    core::Suggestion aimed = change(design, "path.lead", quoted("aimed"));
    if (design.part.cam.options.guide.kind != cam::GuideKind::kParallel) return aimed;
    return aimed.with(key_of(design, "guide.kind"), quoted("point")).with(key_of(design, "guide.distance_mm"), number(kGuide_mm));
}

/// Cable that is taken in beyond the integral of the arm, since it crosses the groove (docs/theory/cams.md, fleet angle) [m].
template <class Angle>
double excess_intake(const cam::Cam& cam, const Angle& angle) {
    double excess = 0.0;
    for (std::size_t i = 1; i < cam.working.size(); ++i) {
        const cam::Contact &a = cam.working[i - 1], &b = cam.working[i];
        const double rho = 0.5 * (a.path.rho + b.path.rho), rise = b.path.z - a.path.z;
        excess += std::hypot(rho * (b.path.psi - a.path.psi), rise) * (1.0 - std::cos(0.5 * (angle(a) + angle(b))));
    }
    return excess;
}

core::Findings measure_cable_groove_angle(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.closed() || cam.working.size() < 2) return {};
    const auto angle = [&cam](const cam::Contact& c) { return std::abs(std::atan(groove_slope(cam, c)) - c.fleet); };
    const cam::Contact& worst = worst_contact(cam, angle);
    core::Finding f = compare(deg_from_rad(angle(worst)), {allowed("review")});
    f.what = fmt::format(
        "angle between the free cable and its groove: it rubs on a flank, where {:.2g} % of the torque may be lost or gained; over the "
        "range the cable moves by {:.2g} mm more than the arms state",
        100.0 * (1.0 - std::cos(angle(worst))) * worst.path.rho / worst.path.h, mm_from_m(excess_intake(cam, angle)));
    locate(f, design, worst.path);
    if (cam.options.path.lead == cam::Lead::kConstantPitch)
        f.suggestion = change(design, "path.pitch_mm",
                              down(mm_from_m(cam.options.path.pitch) * std::tan(rad_from_deg(f.allowed)) / std::tan(angle(worst))))
                           .or_else(aimed_change(design));
    else
        f.suggestion = change(design, "guide.z_mm", number(mm_from_m(0.5 * (cam.working.front().path.z + cam.working.back().path.z)), 3))
                           .noted(": half height");
    return {f};
}

constexpr double kLeast = 1e-3;  // of the largest tension: below, no start torque follows from it

core::Findings measure_cable_slack(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Contact& least = worst_contact(cam, [](const cam::Contact& c) { return -c.arm.tension; });
    const double most = worst_contact(cam, [](const cam::Contact& c) { return c.arm.tension; }).arm.tension;
    if (most <= 0.0) return {};
    core::Finding f = compare(100.0 * least.arm.tension / most, {allowed("review")});
    f.what = fmt::format("least tension, {:.2f} N, of {:.1f} N", least.arm.tension, most);
    locate(f, design, least.path);
    const double wanted = 0.01 * f.allowed * most;
    if (design.spring.kind == spring::BaseKind::kCompression)
        f.suggestion = change(design, "spring.preload_mm", up(mm_from_m(wanted / design.spring.rate)));
    else
        f.suggestion = change("law.start_torque_Nm", up(least.arm.tau * wanted / std::max(least.arm.tension, kLeast * most)))
                           .noted(fmt::format(": {} N", up(wanted)));
    return {f};
}

constexpr double kStep = core::kPi / 900.0;  // [rad] between points of the run-out: rho and pitch change within 0.05 rad there

/// The groove where a cable lies in it: from the anchor to the working arc's other end, by rising psi.
std::vector<cam::PathPoint> under_cable(const cam::Cam& cam) {
    auto path = core::each<cam::PathPoint>(cam.working, &cam::Contact::path);
    if (path.front().psi > path.back().psi) std::reverse(path.begin(), path.end());
    if (!cam.path) return path;
    const double low = std::min(cam.anchor_psi, path.front().psi), high = std::max(cam.anchor_psi, path.back().psi);
    std::vector<cam::PathPoint> before, after;
    for (double psi = low; psi < path.front().psi - 0.5 * kStep; psi += kStep) before.push_back(cam.path(psi));
    for (double psi = path.back().psi + kStep; psi < high + 0.5 * kStep; psi += kStep) after.push_back(cam.path(psi));
    path.insert(path.begin(), before.begin(), before.end());
    path.insert(path.end(), after.begin(), after.end());
    return path;
}

/// Curvature of a curve in space (docs/theory/cams.md, eq. 15).
struct Bend {
    double radius = 0.0;  ///< [m]
    double twist = 0.0;   ///< (z'' - m rho')/rho: rate at which its slope changes
};

/// The bend by differences with both neighbours, which need not be evenly spaced.
Bend bend_at(const cam::PathPoint& a, const cam::PathPoint& b, const cam::PathPoint& c) {
    const double before = b.psi - a.psi, after = c.psi - b.psi, both = before + after;
    const double rise = (b.z - a.z) / before, next_rise = (c.z - b.z) / after;
    const double slope = (rise * after + next_rise * before) / (both * b.rho);  // m = z'/rho
    const double twist = (2.0 * (next_rise - rise) / both - slope * (c.rho - a.rho) / both) / b.rho, turn = 1.0 + slope * slope;
    return {b.rho * turn * std::sqrt(turn / (turn + twist * twist)), std::abs(twist)};
}

/// The pitch at which the groove's slope changes slowly enough, or the cable that allows this bend.
core::Suggestion nearest_change(const Design& design, const Bend& bend, double rho, double allowed) {
    const double needed = 0.5 * design.cable.diameter * (1.0 + allowed), ratio = rho / needed;
    const core::Suggestion thinner = change("cable.diameter_mm", down(mm_from_m(2.0 * bend.radius / (1.0 + allowed))));
    const cam::PathOptions& path = design.part.cam.options.path;
    if (path.lead != cam::Lead::kConstantPitch || ratio <= 1.0 || bend.twist <= 0.0) return thinner;
    const double slower = std::min(1.0, std::sqrt(ratio * ratio - 1.0) / bend.twist);
    return change(design, "path.pitch_mm", down(mm_from_m(path.pitch) * slower)).or_else(thinner);
}

core::Findings measure_cable_space_bend(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.closed() || cam.working.size() < 3) return {};
    const std::vector<cam::PathPoint> path = under_cable(cam);
    Bend sharpest{path.front().rho, 0.0};
    const cam::PathPoint* worst = &path.front();
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
        if (const Bend bend = bend_at(path[i - 1], path[i], path[i + 1]); !(bend.radius >= sharpest.radius))
            sharpest = bend, worst = &path[i];
    const double d = design.cable.diameter, ratio = (2.0 * sharpest.radius - d) / d;
    core::Finding f = judge_bend(ratio, design, allowed);
    f.what = fmt::format("D/d at the groove's sharpest bend in space between anchor and guide, radius {:.3f} mm, {:.3f} mm in the plane",
                         mm_from_m(sharpest.radius), mm_from_m(worst->rho));
    locate(f, design, *worst);
    f.suggestion = nearest_change(design, sharpest, worst->rho, f.allowed);
    return {f};
}

}  // namespace

Rules cable_path_rules() {
    return {
        {"cable.anchor_tail",
         "a cable that is lifted off its working floor by the bend into its hole",
         "length that stays wound between the anchor and the working arc",
         "two cable diameters (practice)",
         {review(kAtLeast, "mm", "two cable diameters")},
         measure_cable_anchor_tail},
        {"cable.fleet",
         "the cable leaving the groove's plane at an angle",
         "largest angle between free cable and the contact's plane; of an aimed helix, between free cable and groove",
         "wirerope.net: 2 deg grooved; 4 deg (practice)",
         {required(kAtMost, "deg", "4 deg, or cable.max_fleet_deg"), review(kAtMost, "deg", 2.0)},
         measure_cable_fleet,
         works},
        {"cable.fleet_side",
         "a guide off the middle, so that the cable rubs on one flank only",
         "largest fleet angle to one side less the largest to the other",
         "wirerope.net: 1.5 deg on a smooth drum",
         {review(kAtMost, "deg", 1.5)},
         measure_cable_fleet_side,
         works},
        {"cable.free_path",
         "the part blocking its own cable",
         "longest piece of a free cable's centreline inside the mesh, 24 positions",
         "geometry: free cable against the mesh",
         {required(kAtMost, "mm", 0.0)},
         measure_cable_free_path,
         nullptr,
         {},
         true},
        {"cable.groove_angle",
         "the cable leaving a helical groove across its flank",
         "helix: largest angle between free cable and groove",
         "US7677540B1: a focused groove points at the guide; 4 deg (practice)",
         {review(kAtMost, "deg", 4.0)},
         measure_cable_groove_angle},
        {"cable.slack",
         "a cable that goes slack and leaves its groove",
         "least tension over the largest",
         "1 % (practice)",
         {review(kAtLeast, "%", 1.0)},
         measure_cable_slack,
         works},
        {"cable.space_bend",
         "a helical groove whose slope changes so fast that it bends the cable too sharply",
         "helix: D/d = (2 R - d)/d with R the least radius of curvature in space, from the anchor to the working arc's end",
         "by construction, as cable.bend_ratio; docs/theory/cams.md, eq. 15",
         {required(kAtLeast, "", "the construction's critical D/d, or cable.min_bend_ratio"),
          review(kAtLeast, "", "the construction's recommended D/d")},
         measure_cable_space_bend},
    };
}

}  // namespace fusee::checks
