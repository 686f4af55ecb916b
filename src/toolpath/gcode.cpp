#include "gcode.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::toolpath {

namespace {

using solid::Arc;
using solid::Point2;

constexpr double kLead = 1.0;      // radius of a lead-in, in cutter diameters; compensation needs more than 0.5
constexpr double kStepover = 0.6;  // in cutter diameters

/// A piece of a ring, in the direction of travel.
struct Piece {
    Arc arc;
    bool over_tab = false;
};

/// The ring against its direction, cut where tabs begin and end: `tabs` of them, each long enough for the cutter to leave its width.
std::vector<Piece> pieces_of(const std::vector<Arc>& ring, const Cutting& cutting, bool with_tabs) {
    double length = 0.0;
    for (const Arc& arc : ring) length += arc.radius_mm * (arc.end - arc.begin);
    const double zone = cutting.tab_width + cutting.cutter;
    const int count = with_tabs ? std::min(cutting.tabs, static_cast<int>(0.5 * length / zone)) : 0;
    std::vector<double> ends;  // along the path: a tab begins, ends, ...
    for (int i = 0; i < count; ++i)
        for (const double side : {-0.5, 0.5}) ends.push_back(length * (i + 0.5) / count + side * zone);
    std::vector<Piece> pieces;
    double travelled = 0.0;
    std::size_t next = 0;
    for (auto arc = ring.rbegin(); arc != ring.rend(); ++arc) {
        Arc rest = *arc;
        const double whole = rest.radius_mm * (rest.end - rest.begin), from = travelled;
        for (; next < ends.size() && ends[next] < from + whole; ++next) {
            const double at = arc->end - (ends[next] - from) / rest.radius_mm;
            Arc before = rest;
            before.begin = rest.end = at;
            pieces.push_back({before, next % 2 == 1});
        }
        pieces.push_back({rest, next % 2 == 1});
        travelled = from + whole;
    }
    return pieces;
}

Point2 moved(const Point2& from, double a, const Point2& along, double b = 0.0, const Point2& across = {}) {
    return {from[0] + a * along[0] + b * across[0], from[1] + a * along[1] + b * across[1]};
}

using core::cross;
using core::dot;
using core::kTurn;
using core::minus;

constexpr int kFirstPieces = 24;  // a piece is never wider than 15 degrees
constexpr int kDeepest = 12;      // halvings of a piece: 64 microradians, far below any allowed tolerance
constexpr int kProbes = 4;        // normals at which each of the two arcs is compared with the outline

Point2 normal(double psi) { return {std::cos(psi), std::sin(psi)}; }

/// The arc through `from` where its normal has the direction `begin`.
Arc arc_from(const Point2& from, double radius, double begin, double end) {
    const Point2 n = normal(begin);
    return {{from[0] - radius * n[0], from[1] - radius * n[1]}, radius, begin, end};
}

/// Eq. 1: r1 (n(m) - n(a)) + r2 (n(b) - n(m)) = Q - P.
std::array<Arc, 2> biarc(const ConvexOutline& outline, double a, double b) {
    const double m = 0.5 * (a + b);
    const Point2 P = outline(a), Q = outline(b), u = minus(normal(m), normal(a)), v = minus(normal(b), normal(m));
    const Point2 way = minus(Q, P);
    const double area = cross(u, v);
    const Arc first = arc_from(P, cross(way, v) / area, a, m);
    return {first, arc_from(first.at(m), cross(u, way) / area, m, b)};
}

double support_error(const ConvexOutline& outline, const Arc& arc) {
    double worst = arc.radius_mm > 0.0 ? 0.0 : 1e9;
    for (int i = 1; i <= kProbes; ++i) {
        const double psi = arc.begin + (arc.end - arc.begin) * i / kProbes;
        worst = std::max(worst, std::abs(dot(normal(psi), minus(outline(psi), arc.at(psi)))));
    }
    return worst;
}

void fit(const ConvexOutline& outline, double a, double b, double tolerance_mm, int depth, std::vector<Arc>& ring) {
    const auto pair = biarc(outline, a, b);
    if (depth < kDeepest && std::max(support_error(outline, pair[0]), support_error(outline, pair[1])) > tolerance_mm) {
        fit(outline, a, 0.5 * (a + b), tolerance_mm, depth + 1, ring);
        fit(outline, 0.5 * (a + b), b, tolerance_mm, depth + 1, ring);
        return;
    }
    ring.insert(ring.end(), pair.begin(), pair.end());
}

}  // namespace

double mm_per_min(double feed) { return 60.0 * core::mm_from_m(feed); }

Cutting::Cutting(const Settings& s)
    : cutter(core::mm_from_m(s.tool_diameter)),
      feed(mm_per_min(feed_of(s, s.feed, cutter, s.spindle_rpm))),
      plunge(s.plunge_feed > 0.0 ? mm_per_min(s.plunge_feed) : feed / 3.0),
      depth_per_pass(core::mm_from_m(s.depth_per_pass)),
      safe(core::mm_from_m(s.safe_height)),
      breakthrough(core::mm_from_m(s.breakthrough)),
      tabs(s.tabs),
      tab_width(core::mm_from_m(s.tab_width)),
      tab_height(core::mm_from_m(s.tab_height)) {}

void Gcode::begin(const Settings& settings) {
    comment("speeds and feeds for {}, {} teeth; {}", to_string(settings.stuff), settings.flutes,
            settings.stuff == Stuff::kPlastic ? "air blast, no coolant" : "mist or flood, by hand");
    line("G21 G90 G91.1 G17 G40 G49 G80 G94 G54");
    line("G64 P{0:.4f} Q{1:.4f}", core::mm_from_m(settings.blend), 0.5 * core::mm_from_m(settings.blend));
}

void Gcode::tool(int number, const std::string& words, const std::string& shape, double flute_mm, double shank_mm, double rpm,
                 const Settings& settings) {
    const double stick_out = core::mm_from_m(settings.stick_out);
    comment("T{}: {}; stick-out {:.1f} mm; check its length in the tool table, H{}", number, words, stick_out, number);
    comment("tool {} {} {:.5f} {:.5f} {:.5f} {:.5f}", number, shape, flute_mm, shank_mm, stick_out,
            core::mm_from_m(settings.holder_diameter));
    line("M5");
    line("G53 G0 Z0");
    line("T{} M6", number);
    line("G43 H{}", number);
    line("S{:.0f} M3", rpm);
}

void Gcode::end() {
    line("M5");
    line("G53 G0 Z0");
    line("M2");
}

std::string left_out(const solid::Part& part) {
    std::vector<std::string> rest;
    if (part.options.hub.lock != solid::HubLock::kPlain) rest.emplace_back("the hub's lock");
    if (part.options.features.anchor_hole_diameter > 0.0) rest.emplace_back("anchor hole");
    if (part.options.features.leg_slot_width > 0.0) rest.emplace_back("leg slot");
    if (part.options.features.mark_width > 0.0) rest.emplace_back("timing mark");
    return rest.empty() ? "nothing" : fmt::format("{}", fmt::join(rest, ", "));
}

void retract(Gcode& code, const Cutting& cutting) {
    code.line("G1 Z{:.5f} F{:.5f}", kClearance_mm, cutting.feed);
    code.line("G0 Z{:.5f}", cutting.safe);
}

void mill_bore(Gcode& code, const Cutting& cutting, double x, double radius, double depth) {
    const double step = kStepover * cutting.cutter;
    const int inner = std::max(0, static_cast<int>(std::ceil((radius - cutting.cutter) / step)));
    const int turns = std::max(1, static_cast<int>(std::ceil(depth / cutting.depth_per_pass)));
    for (int k = inner; k >= 0; --k) {
        // The cutter's centre as an expression of the one number that a worn cutter changes.
        const std::string way = fmt::format("{:.5f}-#<cutter>/2", std::max(radius - k * step, 0.55 * cutting.cutter));
        code.line("G0 X[{:.5f}+{}] Y0", x, way);
        code.line("G0 Z{:.5f}", kClearance_mm);
        code.line("G1 Z0 F{:.5f}", cutting.plunge);
        code.line("G3 X[{0:.5f}+{1}] Y0 I[0-[{1}]] J0 Z{2:.5f} P{3}", x, way, -depth, turns);
        code.line("G3 X[{0:.5f}+{1}] Y0 I[0-[{1}]] J0 F{2:.5f}", x, way, cutting.feed);
        code.line("G1 X{:.5f}", x);
        retract(code, cutting);
    }
}

double lead_length(double cutter) { return 2.0 * kLead * cutter; }

void mill_ring(Gcode& code, const Cutting& cutting, const std::vector<Arc>& ring, double depth, double over_tabs) {
    const double lead = kLead * cutting.cutter, psi = ring.front().begin;
    const Point2 start = ring.front().at(psi), out{std::cos(psi), std::sin(psi)}, travel{out[1], -out[0]};
    const auto to = [](const Point2& p) { return fmt::format("X{:.5f} Y{:.5f}", p[0], p[1]); };
    const auto about = [](double a, const Point2& n) { return fmt::format("I{:.5f} J{:.5f}", a * n[0], a * n[1]); };
    const Point2 in = moved(start, lead, out, -lead, travel), away = moved(start, lead, out, lead, travel);
    code.line("G0 {}", to(moved(in, lead, out)));
    code.line("G0 Z{:.5f}", kClearance_mm);
    code.line("G1 Z{:.5f} F{:.5f}", -depth, cutting.plunge);
    code.line("G41.1 D#<cutter> G1 {} F{:.5f}", to(in), cutting.feed);
    code.line("G3 {} {}", to(start), about(lead, travel));
    bool lifted = false;
    for (const auto& [arc, over_tab] : pieces_of(ring, cutting, over_tabs < depth)) {
        if (over_tab != lifted) code.line("G1 Z{:.5f} F{:.5f}", over_tab ? -over_tabs : -depth, over_tab ? cutting.feed : cutting.plunge);
        lifted = over_tab;
        code.line("G2 {} {} F{:.5f}", to(arc.at(arc.begin)), about(-arc.radius_mm, {std::cos(arc.end), std::sin(arc.end)}), cutting.feed);
    }
    code.line("G3 {} {}", to(away), about(lead, out));
    code.line("G40 G1 {}", to(moved(away, lead, out)));
    retract(code, cutting);
}

std::vector<Arc> fit_arcs(const ConvexOutline& outline, double start, double tolerance_mm) {
    std::vector<Arc> ring;
    for (int i = 0; i < kFirstPieces; ++i)
        fit(outline, start + kTurn * i / kFirstPieces, start + kTurn * (i + 1) / kFirstPieces, tolerance_mm, 0, ring);
    return ring;
}

std::vector<Arc> parallel(std::vector<Arc> ring, double offset_mm) {
    for (Arc& arc : ring) arc.radius_mm += offset_mm;
    return ring;
}

std::vector<Arc> turned_over(const std::vector<Arc>& ring) {
    std::vector<Arc> result;
    for (auto arc = ring.rbegin(); arc != ring.rend(); ++arc)
        result.push_back({{arc->centre_mm[0], -arc->centre_mm[1]}, arc->radius_mm, -arc->end, -arc->begin});
    return result;
}

}  // namespace fusee::toolpath
