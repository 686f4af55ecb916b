#include <limits>

#include "fusee/solid/stack.h"
#include "means.h"

namespace fusee::checks {

namespace {

/// Depth by which a line load q = T/rho sinks into a half-space of modulus E over the width d, below what moves at the depth of 10 d:
/// 2 q/(pi E) (ln 20 + 1/2), Boussinesq's strip under its middle, plane stress. @returns [m]
double sunk(double tension, double rho, double modulus) { return 2.0 * tension / rho / (core::kPi * modulus) * (std::log(20.0) + 0.5); }

/// The softest material of table 5 that creeps less than the allowed share where a cutter makes the part; a printer keeps to its own.
const Material* stiffer(const Design& design, double modulus) {
    const Material* best = nullptr;
    if (is_printed(design.process) || design.process.material.modulus > 0.0) return best;
    for (const Material& m : material_table())
        if (m.creep_modulus >= modulus && (best == nullptr || m.creep_modulus < best->creep_modulus)) best = &m;
    return best;
}

core::Findings measure_groove_creep(const Design& design, const Allowed& allowed) {
    const Material material = material_of(design.process);
    const cam::Contact& rest = design.part.cam.working.front();
    if (!(rest.path.rho > 0.0)) return {};  // no floor: cam.convexity
    const double depth = sunk(rest.arm.tension, rest.path.rho, material.creep_modulus);
    core::Finding f = compare(100.0 * depth / rest.arm.arm, {allowed("review")});
    f.what = fmt::format("share of the {:.2f} mm arm at rest that creep takes over years: {:.1f} N sink the cable {:.3f} mm into {}",
                         mm_from_m(rest.arm.arm), rest.arm.tension, mm_from_m(depth), material.name);
    locate(f, design, rest.path, -0.5 * design.cable.diameter);
    // Longer arms carry the same torque with less tension on a wider floor: T, 1/rho and 1/arm are each as 1/factor.
    f.suggestion = scale_arms(design, 1.01 * std::cbrt(f.measured / f.allowed));
    if (const Material* other = stiffer(design, material.creep_modulus * f.measured / f.allowed))
        f.suggestion.or_else(change("material.kind", quoted(other->name)));
    f.suggestion.or_else("released cables when the joint rests");
    return {f};
}

core::Findings measure_groove_depth(const Design& design, const Allowed& allowed) {
    core::Finding f = compare(design.part.options.groove.depth_ratio, {allowed("required"), allowed("review")});
    f.what = "depth of the groove below its lips";
    f.suggestion = change("groove.depth_ratio", up(f.allowed));
    return {f};
}

constexpr double kWidest = 150.0;  // [deg] throat of a groove

/// Half the groove's width between the lips for another throat (docs/theory/cams.md, eq. 11) [m].
double half_width(const Design& design, double throat) {
    const solid::GrooveOptions& groove = design.part.options.groove;
    const double radius = groove.radius_ratio * design.cable.diameter, half = 0.5 * throat;
    const double flank = groove.depth_ratio * design.cable.diameter - radius * (1.0 - std::sin(half));
    return radius * std::cos(half) + flank * std::tan(half);
}

core::Findings measure_groove_flank_rub(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.working.size() < 2 || design.part.section.empty()) return {};
    const bool stacked = is_stacked(design) && cam.closed();  // otherwise stack.climb judges it
    const double half = 0.5 * (stacked ? solid::core_thickness(design.part) : groove_width(design.part)), lip = lip_offset(design.part),
                 radius = 0.5 * design.cable.diameter;
    // On a floor of radius rho the cable passes the lips sqrt((rho + lip)^2 - rho^2) behind its contact.
    const auto aside = [&](const cam::Contact& c) {
        const double slope = cam.closed() ? 0.0 : groove_slope(cam, c), past = std::sqrt(std::max(0.0, lip) * (2.0 * c.path.rho + lip));
        return past * std::tan(std::abs(std::atan(slope) - c.fleet));
    };
    const cam::Contact& worst = worst_contact(cam, aside);
    core::Finding f = compare(mm_from_m(half - radius - aside(worst)), {allowed("review")});
    f.what =
        fmt::format("clearance between a lip and the cable, which is {:.3f} mm off the groove's middle there", mm_from_m(aside(worst)));
    locate(f, design, worst.path, lip);
    const double needed = half + m_from_mm(f.allowed - f.measured);
    f.suggestion = change("groove.plate_mm", up(mm_from_m(2.0 * needed)));
    if (stacked) return {f};
    double throat = deg_from_rad(design.part.options.groove.throat);
    while (throat < kWidest && half_width(design, rad_from_deg(throat)) < needed) throat += 1.0;
    f.suggestion = change("groove.throat_deg", fmt::format("{:.0f}", std::min(std::ceil(throat), kWidest)));
    return {f};
}

core::Findings measure_groove_lip_height(const Design& design, const Allowed& allowed) {
    if (design.part.section.empty()) return {};
    const double d = design.cable.diameter, tolerance = process_limits(design.process).tolerance;
    core::Finding f = compare(mm_from_m(lip_offset(design.part) - 0.5 * d), {allowed("review", mm_from_m(tolerance))});
    f.what = "height of the lips above the outside of the cable";
    f.where = along_groove(design);
    f.suggestion = change("groove.depth_ratio", up(1.0 + m_from_mm(f.allowed) / d));
    return {f};
}

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

core::Findings measure_groove_pitch(const Design& design, const Allowed& allowed) {
    const Pitch pitch = least_pitch(design.part.cam);
    if (!pitch.turns || design.part.section.empty()) return {};
    const solid::GrooveOptions& groove = design.part.options.groove;
    const double width = groove_width(design.part), wall = process_limits(design.process).wall;
    const double rope = kRopePitch * groove.radius_ratio * design.cable.diameter;
    core::Finding f = compare(mm_from_m(pitch.least), {allowed("required", mm_from_m(std::max(rope, width + wall))),
                                                       allowed("review", mm_from_m(width + groove.rib))});
    f.what = fmt::format("height from one turn to the next; the groove is {:.3f} mm wide, the land between turns {:.2f} mm",
                         mm_from_m(width), mm_from_m(std::max(wall, groove.rib)));
    locate(f, design, pitch.at);
    f.suggestion = change(design, "path.pitch_mm", up(mm_from_m(design.part.cam.options.path.pitch) + f.allowed - f.measured));
    if (design.part.cam.options.path.lead == cam::Lead::kAimedAtGuide)
        f.suggestion = change(design, "guide.z_mm", up(mm_from_m(design.part.cam.options.guide.z) * f.allowed / f.measured))
                           .noted(fmt::format(": the groove then rises by {} mm per turn", up(f.allowed)));
    return {f};
}

constexpr double kGood = 0.53;  // [d]

core::Findings measure_groove_radius(const Design& design, const Allowed& allowed) {
    if (is_stacked(design)) return {};  // a plate's edge is flat: stack.groove_width
    const double ratio = design.part.options.groove.radius_ratio;
    core::Finding f = compare(ratio, {allowed("required"), allowed("low_review"), allowed("high_review")});
    f.what =
        "radius of the groove's floor: " + std::string(f.bound == core::Bound::kAtLeast ? "pinches the cable" : "lets the cable flatten");
    if (f.severity == core::Severity::kPass) f.what = "radius of the groove's floor";
    const double better = f.severity == core::Severity::kError ? kGood : f.allowed;
    f.suggestion = change("groove.radius_ratio", fmt::format("{:.2f}", better))
                       .noted(fmt::format(" ({:.3f} mm)", mm_from_m(better * design.cable.diameter)));
    return {f};
}

constexpr double kNarrow = 35.0, kWide = 45.0, kWithFleet = 60.0;  // [deg]
constexpr double kSmallFleet = 1.5;                                // [deg]

core::Findings measure_groove_throat(const Design& design, const Allowed& allowed) {
    if (is_stacked(design)) return {};  // plates have square edges
    double fleet = 0.0;
    for (const cam::Contact& c : design.part.cam.working)
        fleet = std::max(fleet, deg_from_rad(std::abs(fleet_from_groove(design.part.cam, c))));
    const bool fleeted = fleet > kSmallFleet;
    const double overhang = process_limits(design.process).overhang;
    // A printer that cannot build a rope throat (process.overhang) needs a wider one, which is accepted.
    const double printed = design.process.kind == ProcessKind::kFdm ? 180.0 - 2.0 * deg_from_rad(overhang) : 0.0;
    const double low = fleeted ? kWithFleet : kNarrow, high = std::max(fleeted ? kWithFleet : kWide, printed);
    const double throat = deg_from_rad(design.part.options.groove.throat);
    core::Finding f = compare(throat, {allowed("low_review", low), allowed("high_review", high)});
    f.what = fmt::format("throat angle of the groove at {:.1f} deg fleet", fleet);
    if (printed > kWithFleet) f.what += fmt::format("; a rope throat is 35 to 60 deg, printing without supports needs {:.0f}", printed);
    f.suggestion = change("groove.throat_deg", number(std::max(f.allowed, printed)));
    return {f};
}

}  // namespace

Rules groove_rules() {
    return {
        {"groove.creep",
         "a groove that creeps under the standing preload, so that its arm shrinks",
         "2 T/(pi rho E_creep) (ln 20 + 1/2) over the arm, at the law's lowest load",
         "Boussinesq's strip; Fischbach, Weinberg, arXiv 2302.11240: printed PLA creeps for years; a third of the modulus, 2 % of an arm "
         "(practice)",
         {review(kAtMost, "%", 2.0)},
         measure_groove_creep,
         works},
        {"groove.depth",
         "the cable jumping out of its groove",
         "depth of the lips above the floor",
         "Unirope/Python: drum at least 0.375 d, sheave about 1.5 d",
         {required(kAtLeast, "d", 0.375), review(kAtLeast, "d", 1.5)},
         measure_groove_depth},
        {"groove.flank_rub",
         "the free cable rubbing on a lip",
         "least clearance between the lips and the free cable, at its angle to the groove",
         "geometry: cable against the lips",
         {review(kAtLeast, "mm", 0.0)},
         measure_groove_flank_rub},
        {"groove.lip_height",
         "lips that the process may make lower than the cable",
         "height of the lips above the outside of the cable",
         "the process's tolerance of a contour",
         {of_process(review(kAtLeast, "mm", "the process's tolerance"))},
         measure_groove_lip_height},
        {"groove.neighbour_turns",
         "the free cable striking a larger neighbouring turn",
         "helix: least clearance between free cable and the other turns, 60 positions",
         "geometry: free cable against the groove's surface",
         {required(kAtLeast, "mm", 0.0)},
         measure_groove_neighbour_turns},
        {"groove.pitch",
         "turns that overlap",
         "helix: least height from turn to turn",
         "groove width and the process's wall; Unirope/Python: at least 2.065 groove radii",
         {of_process(required(kAtLeast, "mm", "groove width + the process's wall, at least 2.065 floor radii")),
          review(kAtLeast, "mm", "groove width + groove.rib_mm")},
         measure_groove_pitch},
        {"groove.radius",
         "a groove that pinches the cable or lets it flatten",
         "floor radius",
         "Unirope/Python: 0.53-0.55 d",
         {required(kAtLeast, "d", 0.5), review(kAtLeast, "d", kGood, "low_review"), review(kAtMost, "d", 0.55, "high_review")},
         measure_groove_radius},
        {"groove.throat",
         "flanks that guide the cable badly or rub on it",
         "throat angle",
         "Unirope/Python: 35-45 deg, 60 above 1.5 deg fleet",
         {review(kAtLeast, "deg", "35 deg, 60 above 1.5 deg of fleet", "low_review"),
          review(kAtMost, "deg", "45 deg, 60 above 1.5 deg of fleet; FDM: 180 deg - 2 overhang if larger", "high_review")},
         measure_groove_throat},
    };
}

}  // namespace fusee::checks
