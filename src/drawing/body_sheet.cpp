#include "fusee/drawing/body_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "marks.h"
#include "table.h"
#include "title.h"
#include "view.h"
#include "words.h"

namespace fusee::drawing {

namespace {

using Eigen::Vector3d;

constexpr double kSame_mm = 1e-3;
constexpr double kRing_mm = 0.005;  // tolerance of drawn circles

/// Directions of a view: right, up, towards the eye.
struct Axes {
    Vector3d right, up, towards;
    [[nodiscard]] Point flat(const Vector3d& p) const { return {right.dot(p), up.dot(p)}; }
};

/// A shape as a view shows it: what it covers, from which depth to which.
struct Seen {
    Line rim;
    std::vector<Line> holes;         ///< seen round
    std::vector<Box> boxes;          ///< around these
    std::vector<Point> centres;      ///< of these
    std::vector<Line> hidden_holes;  ///< seen from their side: both edges of each
    double near = 0.0, far = 0.0;
};

bool covers(const Seen& shape, const Point& p) {
    if (!solid::holds(shape.rim, p)) return false;
    for (std::size_t i = 0; i < shape.holes.size(); ++i)
        if (shape.boxes[i].holds({p, p}) && solid::holds(shape.holes[i], p)) return false;
    return true;
}

/// The outline with a point wherever it is widest in a view, so that sizes are those of its arcs.
solid::Ring rim_of(const solid::Extrusion& s, const Axes& axes) {
    constexpr double kQuarter = 0.5 * core::kPi;
    const auto towards = [&](Eigen::Index axis, const Vector3d& e) { return s.frame.linear().col(axis).dot(e); };
    const Vector3d& e = std::abs(towards(2, axes.right)) < 0.99 ? axes.right : axes.up;
    const double widest = std::atan2(towards(1, e), towards(0, e));
    solid::Outline pieces;
    for (const solid::Arc& arc : s.outline.empty() && s.radius_mm > 0.0 ? solid::circle(s.radius_mm) : s.outline) {
        double from = arc.begin;
        do {
            const double next = widest + kQuarter * (std::floor((from - widest) / kQuarter + 1e-9) + 1.0);
            pieces.push_back({arc.centre_mm, arc.radius_mm, from, std::min(next, arc.end)});
            from = pieces.back().end;
        } while (from < arc.end);
    }
    return pieces.empty() ? solid::ring_of(s, kRing_mm) : solid::ring_of(pieces, kRing_mm);
}

Seen seen(const solid::Extrusion& s, const Axes& axes) {
    Seen out;
    const solid::Ring rim = rim_of(s, axes);
    const auto lined = [&](const solid::Ring& ring, double z) {
        Line line;
        for (const solid::Point2& p : ring) line.push_back(axes.flat(s.frame * Vector3d(p[0], p[1], z)));
        return line;
    };
    std::vector<Line> both{lined(rim, 0.0), lined(rim, s.length_mm)};
    out.near = -INFINITY, out.far = INFINITY;
    for (const solid::Point2& p : rim)
        for (const double z : {0.0, s.length_mm}) {
            const double depth = axes.towards.dot(s.frame * Vector3d(p[0], p[1], z));
            out.near = std::max(out.near, depth), out.far = std::min(out.far, depth);
        }
    const bool along = std::abs(s.frame.linear().col(2).dot(axes.towards)) > 0.99;
    if (along) {
        out.rim = both.front();
        const auto add = [&](const solid::Outline& outline, double x, double y) {
            out.holes.push_back(lined(solid::ring_of(outline, kRing_mm), 0.0));
            out.boxes.push_back(extent({out.holes.back()}));
            out.centres.push_back(axes.flat(s.frame * Vector3d(x, y, 0.0)));
        };
        for (const solid::RoundHole& h : s.holes) add(solid::circle(h.radius_mm, {h.x_mm, h.y_mm}), h.x_mm, h.y_mm);
        for (const solid::Outline& bore : s.bores) add(bore, 0.0, 0.0);
        return out;
    }
    const Box box = extent(both);
    out.rim = {box.low, {box.high[0], box.low[1]}, box.high, {box.low[0], box.high[1]}};
    for (const solid::RoundHole& h : s.holes) {
        const Vector3d begin = s.frame * Vector3d(h.x_mm, h.y_mm, 0.0), end = s.frame * Vector3d(h.x_mm, h.y_mm, s.length_mm);
        const Vector3d aside = h.radius_mm * s.frame.linear().col(2).cross(axes.towards);
        for (const double side : {-1.0, 1.0}) out.hidden_holes.push_back({axes.flat(begin + side * aside), axes.flat(end + side * aside)});
    }
    for (const solid::Outline& bore : s.bores) {
        const solid::Ring ring = solid::ring_of(bore, kRing_mm);
        const Box wide = extent({lined(ring, 0.0), lined(ring, s.length_mm)});
        out.hidden_holes.push_back({wide.low, {wide.low[0], wide.high[1]}}),
            out.hidden_holes.push_back({{wide.high[0], wide.low[1]}, wide.high});
    }
    return out;
}

constexpr double kDepth_mm = 0.01;  // surfaces nearer to one another are one

/// The nearest surface at a place; far away where there is none.
double front(const std::vector<Seen>& shapes, const Point& p) {
    double depth = -1e9;
    for (const Seen& shape : shapes)
        if (shape.near > depth && covers(shape, p)) depth = shape.near;
    return depth;
}

/// What of an edge at a depth is seen, in runs: where the surfaces on both sides of it differ, and none is before it.
void stroke_seen(Sheet& sheet, const View& view, const std::vector<Seen>& shapes, const Line& ring, double depth) {
    constexpr double kStep_mm = 0.5, kAside_mm = 0.05;
    Line run;
    const auto end_run = [&] {
        if (run.size() > 1) sheet.strokes.push_back({Pen::kOutline, view.at(run)});
        run.clear();
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        if (length < 1e-9) continue;
        const Point across{-kAside_mm * (b[1] - a[1]) / length, kAside_mm * (b[0] - a[0]) / length};
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / kStep_mm)));
        for (int k = 0; k < pieces; ++k) {
            const auto at = [&](double share) { return Point{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])}; };
            const Point middle = at((k + 0.5) / pieces);
            const double left = front(shapes, {middle[0] + across[0], middle[1] + across[1]}),
                         right = front(shapes, {middle[0] - across[0], middle[1] - across[1]});
            const bool edge = std::abs(left - right) > kDepth_mm, hidden = std::max(left, right) > depth + kDepth_mm;
            if (!edge || hidden) {
                end_run();
                continue;
            }
            if (run.empty()) run.push_back(at(static_cast<double>(k) / pieces));
            run.push_back(at((k + 1.0) / pieces));
        }
    }
    end_run();
}

void draw_view(Sheet& sheet, const std::vector<solid::Extrusion>& all, const Axes& axes, const View& view) {
    std::vector<Seen> shapes;
    for (const solid::Extrusion& s : all) shapes.push_back(seen(s, axes));
    for (const Seen& shape : shapes) {
        stroke_seen(sheet, view, shapes, shape.rim, shape.near);
        for (std::size_t i = 0; i < shape.holes.size(); ++i) {
            const Line& hole = shape.holes[i];
            stroke_seen(sheet, view, shapes, hole, shape.near);
            const Box& box = shape.boxes[i];
            const Point& middle = shape.centres[i];
            if (front(shapes, {box.high[0] + 0.05, middle[1]}) > shape.near + kDepth_mm)
                sheet.strokes.push_back({Pen::kHidden, view.at(hole), true});
            const double half = 0.5 * (box.high[0] - box.low[0]) + 1.0;
            sheet.strokes.push_back({Pen::kCentre, view.at(Line{{middle[0] - half, middle[1]}, {middle[0] + half, middle[1]}})});
            sheet.strokes.push_back({Pen::kCentre, view.at(Line{{middle[0], middle[1] - half}, {middle[0], middle[1] + half}})});
        }
        for (const Line& edge : shape.hidden_holes) sheet.strokes.push_back({Pen::kHidden, view.at(edge)});
    }
}

/// Numbers of the holes that a view shows round, one behind another together.
void write_numbers(Sheet& sheet, const std::vector<BodyHole>& holes, const Axes& axes, const View& view) {
    const auto is_round = [&](const BodyHole& h) { return std::abs((h.to_mm - h.from_mm).normalized().dot(axes.towards)) > 0.99; };
    const auto place = [&](const BodyHole& h) { return axes.flat(h.from_mm); };
    const auto behind = [&](const BodyHole& a, const BodyHole& b) {
        return is_round(b) && std::hypot(place(a)[0] - place(b)[0], place(a)[1] - place(b)[1]) < kSame_mm;
    };
    for (std::size_t i = 0; i < holes.size(); ++i) {
        std::string numbers;
        bool first = is_round(holes[i]);
        for (std::size_t j = 0; j < holes.size() && first; ++j) {
            if (!behind(holes[i], holes[j])) continue;
            first = j >= i;
            numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", j + 1);
        }
        if (!first) continue;
        const Point at = view.at(place(holes[i]));
        const double off = view.scale * holes[i].radius_mm + 1.6;
        std::vector<Text> places;
        for (const double far : {0.0, 3.0, 6.0})
            for (const auto& [x, y] : {std::pair(0.7, -0.7), std::pair(-0.7, -0.7), std::pair(0.7, 1.3), std::pair(-0.7, 1.3)})
                places.push_back(
                    {numbers, {at[0] + x * (off + far), at[1] + y * (off + far)}, x > 0 ? Align::kLeft : Align::kRight, Text::kSmall});
        sheet.write_clear(places);
    }
}

const Axes kFront{Vector3d::UnitX(), Vector3d::UnitZ(), -Vector3d::UnitY()},
    kAbove{Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};

Box box_of(const std::vector<solid::Extrusion>& shapes, const Axes& axes) {
    std::vector<Line> rims;
    for (const solid::Extrusion& s : shapes) rims.push_back(seen(s, axes).rim);
    return extent(rims);
}

/// From where places are counted: the middle plane, the joint's axis or the face towards the joint, and the upper face.
Vector3d datum(const Box& front, const Box& above) {
    return {0.0, above.low[1] < 0.0 && above.high[1] > 0.0 ? 0.0 : above.high[1], front.high[1]};
}

/// "-73.5 to 73.5"
std::string span_text(double low, double high) { return fmt::format("{} to {}", decimals(low, 2), decimals(high, 2)); }

Table hole_table(const std::vector<BodyHole>& holes, const SheetBody& body, const Vector3d& zero) {
    Table table{{"Holes"}, {{"no", "x", "y", "z", "\u00d8", "for"}, {"", "[mm]", "[mm]", "[mm]", "[mm]", ""}}, {}};
    for (std::size_t i = 0; i < holes.size(); ++i) {
        const Vector3d from = holes[i].from_mm - zero, to = holes[i].to_mm - zero;
        std::vector<std::string> row{fmt::format("{}", i + 1)};
        for (Eigen::Index k = 0; k < 3; ++k)
            row.push_back(std::abs(from[k] - to[k]) < kSame_mm ? fmt::format("{:.2f}", from[k] + 0.0) : span_text(from[k], to[k]));
        row.push_back(decimals(2.0 * holes[i].radius_mm, 2)), row.push_back(body.use(holes[i]));
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// What the body is put together of: the extent of each shape, and the largest radius of its outline.
Table shape_table(const std::vector<solid::Extrusion>& shapes, const Vector3d& zero) {
    Table table{{"Solids that it is the sum of"}, {{"x", "y", "z", "R"}, {"[mm]", "[mm]", "[mm]", "[mm]"}}, {}};
    for (const solid::Extrusion& s : shapes) {
        const Box front = extent({seen(s, kFront).rim}), above = extent({seen(s, kAbove).rim});
        double radius = s.outline.empty() ? s.radius_mm : 0.0;
        for (const solid::Arc& arc : s.outline) radius = std::max(radius, arc.radius_mm);
        table.rows.push_back({span_text(front.low[0], front.high[0]), span_text(above.low[1] - zero.y(), above.high[1] - zero.y()),
                              span_text(front.low[1] - zero.z(), front.high[1] - zero.z()), radius > 0.0 ? decimals(radius, 2) : ""});
    }
    return table;
}

/// "Bore for a shaft of 6: 6.1 to 6.4, keyway DIN 6885-1, b 2, fitted by hand, t2 1 +0.1/0, bore + t2 = (7.2)."
std::string bore_note(const Subject& subject, bool locked) {
    const Words bore = bore_words(subject);
    std::string note = fmt::format("Bore {} {}", bore[1], bore[2]);
    const solid::HubOptions& hub = subject.part.options.hub;
    if (locked)  // beside a set screw the shaft has a flat
        for (const std::string& words : hub.lock == solid::HubLock::kSetScrew ? flat_words(hub) : lock_words(subject))
            note += (note.ends_with(",") ? " " : ", ") + words;
    return note + ".";
}

}  // namespace

std::vector<BodyHole> holes_of(const std::vector<solid::Extrusion>& shapes) {
    std::vector<BodyHole> all;
    const auto add = [&](BodyHole hole) {
        if (hole.to_mm.sum() > hole.from_mm.sum()) std::swap(hole.from_mm, hole.to_mm);
        for (BodyHole& known : all) {
            if (std::abs(known.radius_mm - hole.radius_mm) > kSame_mm) continue;
            if ((known.to_mm - hole.from_mm).norm() < kSame_mm) return void(known.to_mm = hole.to_mm);
            if ((known.from_mm - hole.to_mm).norm() < kSame_mm) return void(known.from_mm = hole.from_mm);
        }
        all.push_back(hole);
    };
    for (const solid::Extrusion& s : shapes) {
        for (const solid::RoundHole& h : s.holes)
            add({s.frame * Vector3d(h.x_mm, h.y_mm, 0.0), s.frame * Vector3d(h.x_mm, h.y_mm, s.length_mm), h.radius_mm});
    }
    std::stable_sort(all.begin(), all.end(), [](const BodyHole& a, const BodyHole& b) {
        const auto along_z = [](const BodyHole& h) { return std::abs(h.from_mm.z() - h.to_mm.z()) > kSame_mm; };
        return along_z(a) && !along_z(b);
    });
    return all;
}

Sheet draw_sheet(const Subject& subject, const SheetBody& body) {
    constexpr Box kRoom{{23.0, 13.0}, {262.0, 222.0}};
    constexpr double kAside = 14.0, kBetween = 24.0, kTableTop = 13.0, kTablesTo = 408.0, kTablesBottom = kTitleCorner[1] - 14.0;
    Sheet sheet{fmt::format("{} {}", subject.design, subject.name)};
    const Box front = box_of(body.shapes, kFront), above = box_of(body.shapes, kAbove);
    const double wide = front.high[0] - front.low[0], high = front.high[1] - front.low[1], deep = above.high[1] - above.low[1];
    const double scale = largest_scale([&](double s) {
        return s * wide + 2.0 * kAside < kRoom.high[0] - kRoom.low[0] &&
               s * (high + deep) + kBetween + 2.0 * kAside < kRoom.high[1] - kRoom.low[1];
    });
    const double x = kRoom.low[0] + kAside - scale * front.low[0] + 4.0, top = kRoom.low[1] + kAside;
    const View upper{{x, top + scale * front.high[1]}, scale}, lower{{x, top + scale * high + kBetween + scale * above.high[1]}, scale};
    draw_view(sheet, body.shapes, kFront, upper), draw_view(sheet, body.shapes, kAbove, lower);
    dimension_across(sheet, upper.at(front.low[0], front.high[1]), upper.at(front.high), upper.at(front.high)[1] - 8.0, decimals(wide, 2));
    dimension_up(sheet, upper.at(front.low), upper.at(front.low[0], front.high[1]), upper.at(front.low)[0] - 8.0, decimals(high, 2));
    dimension_up(sheet, lower.at(above.low), lower.at(above.low[0], above.high[1]), lower.at(above.low)[0] - 8.0, decimals(deep, 2));
    const std::vector<BodyHole> holes = holes_of(body.shapes);
    write_numbers(sheet, holes, kFront, upper), write_numbers(sheet, holes, kAbove, lower);
    const Vector3d zero = datum(front, above);
    const Table table = hole_table(holes, body, zero), solids = shape_table(body.shapes, zero);
    (void)write_table(sheet, table, 0, {kTablesTo - table.width(), kTableTop}, kTablesBottom);
    const double rows = 4.2 * static_cast<double>(table.rows.size() + 4);
    (void)write_table(sheet, solids, 0, {kTablesTo - solids.width(), kTableTop + rows}, kTablesBottom);
    draw_general_marks(sheet, subject);
    Words words{fmt::format("Places: x from the middle plane, y from {}, z from the upper face.",
                            zero.y() == 0.0 ? body.axis : "the face towards the joint")};
    if (std::any_of(body.shapes.begin(), body.shapes.end(), [](const solid::Extrusion& s) { return !s.bores.empty(); }))
        words.push_back(bore_note(subject, body.locked));
    words.insert(words.end(), body.notes.begin(), body.notes.end());
    write_notes(sheet, words, {{24.0, 226.0}, {226.0, 286.0}});
    draw_title(sheet, subject, {body.title, body.chordal_mm}, scale, 1, 1);
    return sheet;
}

}  // namespace fusee::drawing
