#include "isometric.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "body.h"
#include "fusee/core/units.h"
#include "view.h"

namespace fusee::drawing {

namespace {

using solid::Vec3;

constexpr int kPixels = 800;                   // along the longer side of the view
constexpr double kSharp = 0.9063077870366499;  // cos 25 deg
constexpr double kFold = 0.8;                  // cosine of the angle between two edges of a silhouette that folds back
constexpr double kNameOfView = 8.0;
constexpr double kFinest = 0.15;  // of points of a line on the sheet [mm]

/// An orthonormal frame: right and up on the sheet, and towards the eye.
struct Eye {
    Vec3 right, up, towards;
    explicit Eye(bool from_below) {
        const double s = 1.0 / std::sqrt(3.0), r = 1.0 / std::sqrt(2.0);
        right = {r, r, 0.0};
        towards = {s, -s, from_below ? -s : s};
        up = core::cross(towards, right);
    }
    [[nodiscard]] Vec3 operator()(const Vec3& p) const { return {core::dot(right, p), core::dot(up, p), core::dot(towards, p)}; }
};

/// Nearest depth of the mesh at every pixel.
class Depths {
public:
    Depths(const std::vector<Vec3>& points, const std::vector<solid::Triangle>& triangles) {
        Vec3 low = points.front(), high = low;
        for (const Vec3& p : points)
            for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
        size_ = std::max(high[0] - low[0], high[1] - low[1]) / kPixels;
        low_ = {low[0] - 2.0 * size_, low[1] - 2.0 * size_};
        columns_ = static_cast<int>((high[0] - low_[0]) / size_) + 3;
        rows_ = static_cast<int>((high[1] - low_[1]) / size_) + 3;
        nearest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -std::numeric_limits<double>::infinity());
        for (const solid::Triangle& t : triangles) fill(points[t[0]], points[t[1]], points[t[2]]);
    }
    [[nodiscard]] double pixel() const { return size_; }
    /// A point of an edge is hidden if the mesh is nearer at its pixel and at all those around it.
    [[nodiscard]] bool sees(const Vec3& p) const {
        const int column = index(p[0], 0), row = index(p[1], 1);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (nearest_[at(column + dx, row + dy)] < p[2] + 2.0 * size_) return true;
        return false;
    }

private:
    [[nodiscard]] int index(double value, std::size_t axis) const { return static_cast<int>((value - low_[axis]) / size_); }
    [[nodiscard]] std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(std::clamp(row, 0, rows_ - 1)) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(std::clamp(column, 0, columns_ - 1));
    }
    void fill(const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto side = [](const Vec3& p, const Vec3& q, double x, double y) {
            return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
        };
        const double area = side(a, b, c[0], c[1]);
        if (area <= 0.0) return;  // turned away from the eye, or seen edge-on
        const auto [x0, x1] = std::minmax({index(a[0], 0), index(b[0], 0), index(c[0], 0)});
        const auto [y0, y1] = std::minmax({index(a[1], 1), index(b[1], 1), index(c[1], 1)});
        for (int row = y0; row <= y1; ++row) {
            const double y = low_[1] + (row + 0.5) * size_;
            const auto [first, last] = columns_within(a, b, c, y, x0, x1);
            for (int column = first; column <= last; ++column) {
                const double x = low_[0] + (column + 0.5) * size_;
                const double u = side(b, c, x, y), v = side(c, a, x, y), w = side(a, b, x, y);
                if (u < 0.0 || v < 0.0 || w < 0.0) continue;
                double& nearest = nearest_[at(column, row)];
                nearest = std::max(nearest, (u * a[2] + v * b[2] + w * c[2]) / area);
            }
        }
    }
    /// Those between x0 and x1 where the triangle can hold the middle of a pixel of the row at y, one more to each side.
    [[nodiscard]] std::array<int, 2> columns_within(const Vec3& a, const Vec3& b, const Vec3& c, double y, int x0, int x1) const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
            const double rise = (*q)[1] - (*p)[1];
            if (std::min((*p)[1], (*q)[1]) > y + size_ || std::max((*p)[1], (*q)[1]) < y - size_) continue;
            const double share = rise == 0.0 ? 0.0 : std::clamp((y - (*p)[1]) / rise, 0.0, 1.0);
            const double x = std::lerp((*p)[0], (*q)[0], share);
            low = std::min(low, x), high = std::max(high, x);
        }
        if (low > high) return {1, 0};
        return {std::max(x0, index(low, 0) - 1), std::min(x1, index(high, 0) + 1)};
    }

    std::array<double, 2> low_{};
    double size_ = 1.0;
    int columns_ = 0, rows_ = 0;
    std::vector<double> nearest_;
};

using Edge = std::array<std::uint32_t, 2>;

/// Edges where the faces differ, and those between a face that is seen and one that is turned away.
std::vector<Edge> edges_of(const solid::Mesh& mesh, const Eye& eye) {
    std::vector<Edge> edges;
    std::map<Edge, Vec3> once;  // the first face's normal
    for (const solid::Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]], &c = mesh.points_mm[t[2]];
        Vec3 normal = core::cross(core::minus(b, a), core::minus(c, a));
        const double length = std::sqrt(core::dot(normal, normal));
        for (double& n : normal) n /= length > 0.0 ? length : 1.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Edge edge{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])};
            const auto [other, is_new] = once.try_emplace(edge, normal);
            if (is_new) continue;
            const bool turns = (core::dot(normal, eye.towards) > 0.0) != (core::dot(other->second, eye.towards) > 0.0);
            if (turns || core::dot(normal, other->second) < kSharp) edges.push_back(edge);
        }
    }
    return edges;
}

/// The edges without those that fold back at one of their ends: on a twisted strip the triangles turn this way and that.
std::vector<Edge> unfolded(const std::vector<Edge>& edges, const solid::Mesh& mesh) {
    std::multimap<std::uint32_t, std::size_t> at;
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (const std::uint32_t end : edges[i]) at.emplace(end, i);
    const auto away = [&](std::size_t i, std::uint32_t from) {
        Vec3 way = core::minus(mesh.points_mm[edges[i][0] == from ? edges[i][1] : edges[i][0]], mesh.points_mm[from]);
        const double length = std::sqrt(core::dot(way, way));
        for (double& w : way) w /= length;
        return way;
    };
    std::vector<bool> folds(edges.size(), false);
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (const std::uint32_t end : edges[i]) {
            const auto [first, last] = at.equal_range(end);
            for (auto other = first; other != last; ++other)
                if (other->second != i && core::dot(away(i, end), away(other->second, end)) > kFold) folds[i] = true;
        }
    std::vector<Edge> kept;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!folds[i]) kept.push_back(edges[i]);
    return kept;
}

/// The visible pieces of one edge.
void add_visible(std::vector<Line>& lines, const Vec3& a, const Vec3& b, const Depths& depths) {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / depths.pixel())));
    const auto at = [&](int i) {
        const double share = static_cast<double>(i) / steps;
        return Vec3{std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share), std::lerp(a[2], b[2], share)};
    };
    int from = -1;
    for (int i = 0; i <= steps; ++i) {
        const bool seen = depths.sees(at(i));
        if (seen && from < 0) from = i;
        const bool ends = from >= 0 && (!seen || i == steps);
        if (!ends) continue;
        const int to = seen ? i : i - 1;
        if (to > from) lines.push_back({{at(from)[0], at(from)[1]}, {at(to)[0], at(to)[1]}});
        from = -1;
    }
}

/// Joins pieces that begin where another ends, so that a curve is one line.
std::vector<Line> chained(const std::vector<Line>& pieces) {
    std::multimap<Point, std::size_t> ends;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const Point& p : {pieces[i].front(), pieces[i].back()}) ends.emplace(p, i);
    std::vector<bool> used(pieces.size(), false);
    const auto extend = [&](Line& line) {
        for (bool grew = true; grew;) {
            grew = false;
            const auto [first, last] = ends.equal_range(line.back());
            for (auto it = first; it != last && !grew; ++it) {
                if (used[it->second]) continue;
                const Line& piece = pieces[it->second];
                used[it->second] = grew = true;
                line.push_back(piece.front() == line.back() ? piece.back() : piece.front());
            }
        }
    };
    std::vector<Line> lines;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (used[i]) continue;
        used[i] = true;
        Line line = pieces[i];
        extend(line);
        std::reverse(line.begin(), line.end());
        extend(line);
        lines.push_back(std::move(line));
    }
    return lines;
}

/// The line without points that are nearer to the last one than can be drawn.
Line thinned(const Line& line) {
    Line out{line.front()};
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
        if (std::hypot(line[i][0] - out.back()[0], line[i][1] - out.back()[1]) > kFinest) out.push_back(line[i]);
    out.push_back(line.back());
    return out;
}

}  // namespace

std::vector<Line> isometric(const solid::Mesh& mesh, bool from_below) {
    const Eye eye(from_below);
    std::vector<Vec3> seen;
    seen.reserve(mesh.points_mm.size());
    for (const Vec3& p : mesh.points_mm) seen.push_back(eye(p));
    const Depths depths(seen, mesh.triangles);
    std::vector<Line> pieces;
    for (const Edge& edge : unfolded(edges_of(mesh, eye), mesh)) add_visible(pieces, seen[edge[0]], seen[edge[1]], depths);
    return chained(pieces);
}

void draw_isometric(Sheet& sheet, const Subject& subject, const Box& area) {
    const bool from_below = subject.part.options.hub.kind == solid::HubKind::kOverhung;
    const std::vector<Line> seen = isometric(subject.part.mesh, from_below);
    const Box mm = extent(seen);
    const double width = area.high[0] - area.low[0], height = area.high[1] - area.low[1] - kNameOfView;
    const double scale =
        largest_scale([&](double s) { return s * (mm.high[0] - mm.low[0]) <= width && s * (mm.high[1] - mm.low[1]) <= height; });
    const View view{{0.5 * (area.low[0] + area.high[0]) - 0.5 * scale * (mm.low[0] + mm.high[0]),
                     area.low[1] + kNameOfView + 0.5 * height + 0.5 * scale * (mm.low[1] + mm.high[1])},
                    scale};
    sheet.texts.push_back({fmt::format("isometric from {} ({})", from_below ? "below" : "above", scale_text(scale)),
                           {area.low[0], area.low[1] + 4.0},
                           Align::kLeft,
                           Text::kTitle});
    for (const Line& line : seen) sheet.strokes.push_back({Pen::kOutline, thinned(view.at(line)), false, "isometric"});
}

}  // namespace fusee::drawing
