#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body.h"
#include "fusee/solid/outline.h"
#include "tolerances.h"
#include "words.h"

namespace fusee::drawing {

namespace {

using core::mm_from_m;

constexpr double kHeightDimension = 9.0;  // of the overall height from the section
constexpr double kAxisBeyond = 4.0;

double boss_mm(const solid::Part& part) { return mm_from_m(part.options.hub.boss_height); }
double low_mm(const solid::Part& part) { return mm_from_m(part.z_low) - boss_mm(part); }

/// Height of the blind bore's end.
double blind_end_mm(const solid::Part& part) { return mm_from_m(part.z_low + part.options.groove.rib - part.options.hub.web); }

/// The span from the leftmost to the rightmost point of the cut at one of its levels.
core::Range span_at(const std::vector<Line>& cut, double z_mm) {
    core::Range span{1e9, -1e9};
    for (const Line& ring : cut)
        for (const Point& p : ring)
            if (std::abs(p[1] - z_mm) < 1e-3) span = {std::min(span.low, p[0]), std::max(span.high, p[0])};  // single precision's rounding
    return span;
}

/// Extent of the part behind the cut at a height.
core::Range span_behind(const solid::Mesh& mesh, double z_mm) {
    core::Range span;
    for (const Line& ring : solid::slice(mesh, z_mm))
        for (const Point& p : ring)
            if (p[1] >= 0.0) span = {std::min(span.low, p[0]), std::max(span.high, p[0])};
    return span;
}

/// A height in the part's frame with its description.
struct Level {
    double z_mm = 0.0;
    Words words;
    std::vector<Badge> badges = {};
};

std::string level_text(double z_mm, const char* what) { return fmt::format("z {} {}", decimals(z_mm), what); }

std::vector<Level> levels(const Subject& subject) {
    const solid::Part& part = subject.part;
    const Tolerances t = tolerances_of(subject);
    const double top = mm_from_m(part.z_high), bottom = mm_from_m(part.z_low);
    std::vector<Level> all{{top, {level_text(top, "top face")}}, {bottom, {level_text(bottom, "lower face")}}};
    if (part.cam.closed() && !part.cam.has_roller()) {
        const std::string flange = "flange " + decimals(mm_from_m(part.options.groove.rib)) + ", lip z ";
        all[0].words.push_back(flange + decimals(part.section.back().z_mm));
        all[1].words.push_back(flange + decimals(part.section.front().z_mm));
    }
    const solid::HubOptions& hub = part.options.hub;
    if (boss_mm(part) > 0.0)
        all.push_back({low_mm(part),
                       {level_text(low_mm(part), "end of the boss"),
                        fmt::format("\u00d8{}, {} high", decimals(mm_from_m(hub.boss_diameter)), decimals(boss_mm(part)))}});
    all.front().badges.push_back(frame(Symbol::kRunout, t.runout, kDatumA));
    all.back().badges.push_back(frame(Symbol::kPerpendicular, t.face, kDatumA));  // the face that rests on the shaft's shoulder
    return all;
}

/// A flange that extends farther behind the cut than in it, from its face to the inner lip.
void draw_flange_behind(Sheet& sheet, const solid::Part& part, const std::vector<Line>& cut, const View& view, double face, double lip) {
    constexpr double kSeen = 0.02;
    const core::Range here = span_at(cut, face), inside = span_at(cut, lip);
    const core::Range there = span_behind(part.mesh, face + 0.487 * (lip - face));  // at a height without vertices of the mesh
    if (there.low < here.low - kSeen)
        sheet.strokes.push_back({Pen::kOutline, view.at(Line{{here.low, face}, {there.low, face}, {there.low, lip}, {inside.low, lip}})});
    if (there.high > here.high + kSeen)
        sheet.strokes.push_back(
            {Pen::kOutline, view.at(Line{{here.high, face}, {there.high, face}, {there.high, lip}, {inside.high, lip}})});
}

/// The rims of the bore behind the cut, and the edge of its keyway.
void draw_bore_behind(Sheet& sheet, const solid::Part& part, const View& view) {
    const solid::HubOptions& hub = part.options.hub;
    const bool through = hub.kind == solid::HubKind::kThrough;
    const double radius = mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance)), half = mm_from_m(0.5 * hub.key_width);
    const double low = low_mm(part), high = through ? mm_from_m(part.z_high) : blind_end_mm(part);
    const double far = hub.lock == solid::HubLock::kKeyway  ? radius + mm_from_m(hub.key_depth)
                       : hub.lock == solid::HubLock::kDFlat ? radius - mm_from_m(hub.flat_depth)
                                                            : radius;
    sheet.strokes.push_back({Pen::kOutline, view.at(Line{{-radius, low}, {far, low}})});
    if (through) sheet.strokes.push_back({Pen::kOutline, view.at(Line{{-radius, high}, {far, high}})});
    if (hub.lock != solid::HubLock::kKeyway) return;
    const double edge = std::sqrt(radius * radius - half * half);
    sheet.strokes.push_back({Pen::kOutline, view.at(Line{{edge, low}, {edge, high}})});
}

}  // namespace

std::vector<Line> axial_cut(const solid::Part& part) {
    solid::Mesh turned = part.mesh;
    for (solid::Vec3& p : turned.points_mm) p = {p[2], p[0], p[1]};  // a cyclic change of axes keeps the orientation
    std::vector<Line> cut = solid::slice(turned, 0.0);
    for (Line& ring : cut)
        for (Point& p : ring) std::swap(p[0], p[1]);
    return cut;
}

SectionCallouts section_callouts(const Subject& subject, const std::vector<Line>& cut, const View& view) {
    const solid::Part& part = subject.part;
    const solid::HubOptions& hub = part.options.hub;
    SectionCallouts callouts;
    for (const Level& level : levels(subject))
        callouts.right.push_back({view.at(span_at(cut, level.z_mm).high, level.z_mm), level.words, level.badges});
    if (hub.kind == solid::HubKind::kThrough) return callouts;
    const double radius = mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance)), low = low_mm(part), end = blind_end_mm(part);
    callouts.left.push_back(
        {view.at(-0.5 * radius, end), {fmt::format("bore ends at z {},", decimals(end)), fmt::format("{} deep", decimals(end - low))}});
    callouts.left.push_back({view.at(-radius, low + 0.6 * (end - low)), bore_words(subject), bore_badges(subject)});
    if (const Words lock = lock_words(subject); !lock.empty())
        callouts.left.push_back({view.at(radius, low + 0.2 * (end - low)), lock, lock_badges(subject)});
    return callouts;
}

void draw_section(Sheet& sheet, const Subject& subject, const std::vector<Line>& cut, const View& view, const Columns& columns) {
    const solid::Part& part = subject.part;
    hatch(sheet, view.at(cut));
    for (const Line& ring : cut) sheet.strokes.push_back({Pen::kOutline, view.at(ring), true});
    if (part.cam.closed() && !part.cam.has_roller()) {
        draw_flange_behind(sheet, part, cut, view, mm_from_m(part.z_high), part.section.back().z_mm);
        draw_flange_behind(sheet, part, cut, view, mm_from_m(part.z_low), part.section.front().z_mm);
    }
    draw_bore_behind(sheet, part, view);
    const double low = low_mm(part), high = mm_from_m(part.z_high), left = extent(cut).low[0];
    const Point foot = view.at(0.0, low), top = view.at(0.0, high);
    sheet.strokes.push_back({Pen::kCentre, {{foot[0], foot[1] + kAxisBeyond}, {top[0], top[1] - kAxisBeyond}}});
    const SectionCallouts callouts = section_callouts(subject, cut, view);
    write_callouts(sheet, callouts.left, Align::kRight, columns.left, columns.height);
    write_callouts(sheet, callouts.right, Align::kLeft, columns.right, columns.height);
    const double at_foot = span_at(cut, low).low, at_top = span_at(cut, high).low, x = view.at(left, 0.0)[0] - kHeightDimension;
    dimension_up(sheet, view.at(at_foot, low), view.at(at_top, high), x, decimals(high - low, 2));
}

}  // namespace fusee::drawing
