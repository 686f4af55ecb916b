#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "fusee/core/disjoint_sets.h"
#include "seam.h"

namespace fusee::inspect {

namespace {

constexpr double kSharpest = core::rad_from_deg(75.0);  // turn between two facets of one hole
constexpr double kAlong = 0.035;                        // sine of 2 deg: of a facet's normal with the axis' plane
constexpr double kWidths = 3.0;                         // a facet much wider than its neighbours is a wall beside a rounding
constexpr double kRound = 0.02, kRound_mm = 0.02;       // corners off the circle: share of its radius, and at least [mm]
constexpr std::size_t kLargestFacet = 1000;             // triangles; a larger facet does not belong to a hole
constexpr std::size_t kLeastFacets = 3;
constexpr double kHole = core::rad_from_deg(200.0);
constexpr double kRing = 0.01;       // of the diameter: one ring of facets of a ball or a torus is shorter
constexpr double kTip = 0.6;         // diameters added by a drill's tip beyond the wall
constexpr double kOneAxis = 0.9994;  // cosine of 2 deg: between the axes of two arcs of one hole

/// A facet is the triangles in one plane, and has a seam to each facet beside it in which the surface turns inward. Facets are numbered by
/// their first triangles.
class Facets {
public:
    using FacetSeam = std::pair<std::uint32_t, std::uint32_t>;  ///< triangle here, triangle there

    explicit Facets(const Body& body) {
        core::DisjointSets planes(body.mesh().triangles.size());
        for_each_seam(body, [&](const Seam& s) {
            if (s.turn < kSamePlane)
                planes.join(s.a, s.b);
            else if (s.concave && s.turn <= kSharpest)
                seams_.insert(seams_.end(), {{s.a, s.b}, {s.b, s.a}});
        });
        for (std::uint32_t t = 0; t < body.mesh().triangles.size(); ++t) {
            const std::uint32_t first = planes.find(t);
            facet_of_.push_back(first == t ? count_++ : facet_of_[first]);
        }
        group_triangles();
        group_seams();
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }
    [[nodiscard]] std::uint32_t of(std::uint32_t triangle) const { return facet_of_[triangle]; }
    [[nodiscard]] std::span<const std::uint32_t> triangles(std::uint32_t facet) const { return part(triangles_, triangles_end_, facet); }
    [[nodiscard]] std::span<const FacetSeam> seams(std::uint32_t facet) const { return part(seams_, seams_end_, facet); }

private:
    template <class T>
    static std::span<const T> part(const std::vector<T>& all, const std::vector<std::uint32_t>& ends, std::uint32_t facet) {
        const std::uint32_t begin = facet == 0 ? 0 : ends[facet - 1];
        return {all.data() + begin, ends[facet] - begin};
    }
    /// Where the items of each facet end, from their numbers; then puts them in place, those of a facet in their order.
    template <class T, class FacetOf>
    [[nodiscard]] std::vector<std::uint32_t> group(std::vector<T>& items, const FacetOf& facet_of) const {
        std::vector<std::uint32_t> next(count_ + 1, 0);
        for (const T& item : items) ++next[facet_of(item) + 1];
        std::partial_sum(next.begin(), next.end(), next.begin());
        std::vector<T> placed(items.size());
        for (const T& item : items) placed[next[facet_of(item)]++] = item;
        items = std::move(placed);
        next.pop_back();
        return next;
    }
    void group_triangles() {
        triangles_.resize(facet_of_.size());
        std::iota(triangles_.begin(), triangles_.end(), 0U);
        triangles_end_ = group(triangles_, [this](std::uint32_t t) { return facet_of_[t]; });
    }
    void group_seams() {
        const auto facet_of = [this](const FacetSeam& seam) { return facet_of_[seam.first]; };
        (void)group(seams_, facet_of);
        keep_one_seam_to_each();
        seams_end_ = group(seams_, facet_of);
    }
    /// Two planes meet along one line: their first seam says all. A fine mesh has planes of a thousand triangles with as many seams, and
    /// growth from each would take time by the square of their number.
    void keep_one_seam_to_each() {
        std::vector<std::uint32_t> met_by(count_, kNone);  // of each facet: the last one that has a seam to it
        std::erase_if(seams_, [&](const FacetSeam& seam) {
            return std::exchange(met_by[facet_of_[seam.second]], facet_of_[seam.first]) == facet_of_[seam.first];
        });
    }

    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> facet_of_, triangles_, triangles_end_, seams_end_;  ///< facet_of_: of each triangle
    std::vector<FacetSeam> seams_;
};

class Grower {
public:
    explicit Grower(const Body& body)
        : body_(body), facets_(body), used_(facets_.count(), false), reached_(facets_.count()), seen_(body.mesh().points_mm.size()) {}

    std::vector<Hollow> all() {
        std::vector<Arc> found;
        for (std::uint32_t facet = 0; facet < facets_.count(); ++facet)
            for (const auto& [here, there] : facets_.seams(facet)) {
                if (used_[facet] || used_[facets_.of(there)]) continue;
                const Vec3 axis = unit(cross(body_.normals()[here], body_.normals()[there]));
                if (auto hollow = measured(axis, grown(facet, axis))) found.push_back({std::move(*hollow)});
            }
        join_arcs(found);
        std::vector<Hollow> hollows;
        hollows.reserve(found.size());
        for (Arc& arc : found) hollows.push_back(std::move(arc.hollow));
        return hollows;
    }

private:
    struct Arc {
        Hollow hollow;
        std::vector<Vec3> corners = {};  ///< by rising coordinate `across`, once they were asked for
        std::size_t across = 0;
    };

    [[nodiscard]] double width(std::uint32_t facet, const Vec3& axis) const {
        const auto triangles = facets_.triangles(facet);
        const Vec3 across = cross(axis, body_.normals()[triangles.front()]);
        double low = INFINITY, high = -INFINITY;
        for (const std::uint32_t t : triangles)
            for (const std::uint32_t p : body_.mesh().triangles[t]) {
                const double x = dot(body_.mesh().points_mm[p], across);
                low = std::min(low, x), high = std::max(high, x);
            }
        return high - low;
    }
    [[nodiscard]] bool runs_along(std::uint32_t facet, const Vec3& axis) const {
        const auto triangles = facets_.triangles(facet);
        return triangles.size() <= kLargestFacet && std::abs(dot(body_.normals()[triangles.front()], axis)) < kAlong;
    }

    /// The connected facets about the axis.
    std::vector<std::uint32_t> grown(std::uint32_t seed, const Vec3& axis) {
        if (!runs_along(seed, axis)) return {};
        ++growth_;
        std::vector<std::uint32_t> facets;
        std::vector<std::uint32_t> next{seed};
        reached_[seed] = {growth_, width(seed, axis)};
        while (!next.empty()) {
            const std::uint32_t facet = next.back();
            next.pop_back();
            facets.push_back(facet);
            for (const auto& [here, there] : facets_.seams(facet)) {
                const std::uint32_t other = facets_.of(there);
                if (reached_[other].by == growth_ || used_[other] || !runs_along(other, axis)) continue;
                const double a = reached_[facet].width, b = width(other, axis);
                if (a > kWidths * b || b > kWidths * a) continue;
                reached_[other] = {growth_, b};
                next.push_back(other);
            }
        }
        return facets;
    }

    /// The facets' corners seen along the axis, each once, and in the order of the triangles, where most of them come several times.
    struct Outline {
        std::vector<std::array<double, 2>> points;
        std::vector<std::uint32_t> order;  ///< numbers of these points
        double low = INFINITY, high = -INFINITY;
    };
    [[nodiscard]] Outline outline(const Vec3& axis, const Frame& frame, const std::vector<std::uint32_t>& facets) {
        Outline outline;
        ++look_;
        for (const std::uint32_t facet : facets)
            for (const std::uint32_t t : facets_.triangles(facet))
                for (const std::uint32_t p : body_.mesh().triangles[t]) {
                    auto& [look, number] = seen_[p];
                    if (look != look_) {
                        look = look_, number = static_cast<std::uint32_t>(outline.points.size());
                        const Vec3& at = body_.mesh().points_mm[p];
                        outline.points.push_back({dot(at, frame.u), dot(at, frame.v)});
                        const double along = dot(at, axis);
                        outline.low = std::min(outline.low, along), outline.high = std::max(outline.high, along);
                    }
                    outline.order.push_back(number);
                }
        return outline;
    }

    struct Circle {
        double x = 0.0, y = 0.0, radius = 0.0;
    };
    /// Least squares of x^2 + y^2 = 2 a x + 2 b y + c about the points' middle (I. Kasa, 1976).
    static Circle circle_through(const Outline& outline) {
        const auto n = static_cast<double>(outline.order.size());
        std::vector<std::array<double, 3>> at;  // x, y and their squares' sum
        at.reserve(outline.points.size());
        for (const auto& p : outline.points) at.push_back({p[0] / n, p[1] / n, 0.0});
        double mx = 0.0, my = 0.0;
        for (const std::uint32_t i : outline.order) mx += at[i][0], my += at[i][1];
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double x = outline.points[i][0] - mx, y = outline.points[i][1] - my;
            at[i] = {x, y, x * x + y * y};
        }
        double xx = 0.0, xy = 0.0, yy = 0.0, xq = 0.0, yq = 0.0, q = 0.0;
        for (const std::uint32_t i : outline.order) {
            const auto& [x, y, s] = at[i];
            xx += x * x, xy += x * y, yy += y * y, xq += x * s, yq += y * s, q += s;
        }
        const double determinant = xx * yy - xy * xy;
        const double a = 0.5 * (xq * yy - yq * xy) / determinant, b = 0.5 * (yq * xx - xq * xy) / determinant;
        return {mx + a, my + b, std::sqrt(q / n + a * a + b * b)};
    }
    static double angle_covered(const std::vector<std::array<double, 2>>& points, const Circle& circle) {
        std::vector<double> angles;
        angles.reserve(points.size());
        for (const auto& p : points) angles.push_back(std::atan2(p[1] - circle.y, p[0] - circle.x));
        std::sort(angles.begin(), angles.end());
        double gap = angles.front() + 2.0 * core::kPi - angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
        return 2.0 * core::kPi - gap;
    }

    std::optional<Hollow> measured(const Vec3& axis, const std::vector<std::uint32_t>& facets) {
        if (facets.size() < kLeastFacets) return std::nullopt;
        const Frame frame = frame_about(axis);
        const Outline all = outline(axis, frame, facets);
        const Circle circle = circle_through(all);
        const double slack = std::max(kRound * circle.radius, std::min(kRound_mm, 0.1 * circle.radius));
        double radius = 0.0;  // corners stand on the circle, cuts across a facet lie inside it
        for (const auto& p : all.points) {
            const double from_middle = std::hypot(p[0] - circle.x, p[1] - circle.y);
            if (!(std::abs(from_middle - circle.radius) <= slack)) return std::nullopt;
            radius = std::max(radius, from_middle);
        }
        Hollow hollow;
        hollow.axis = axis;
        hollow.diameter_mm = 2.0 * radius;
        hollow.length_mm = all.high - all.low;
        hollow.covers = angle_covered(all.points, circle);
        hollow.middle_mm = circle.x * frame.u + circle.y * frame.v + 0.5 * (all.low + all.high) * axis;
        for (const std::uint32_t facet : facets) {
            used_[facet] = true;
            hollow.triangles.insert(hollow.triangles.end(), facets_.triangles(facet).begin(), facets_.triangles(facet).end());
        }
        std::sort(hollow.triangles.begin(), hollow.triangles.end());
        const double reach = 0.5 * hollow.length_mm + kTip * hollow.diameter_mm;
        for (const int end : {0, 1}) {
            const auto hit = body_.rays().first(hollow.middle_mm, end == 0 ? -1.0 * axis : axis, kNone);
            hollow.open[end] = !hit || hit->distance_mm > reach;
        }
        return hollow;
    }

    /// The corners, each once, by rising coordinate `along`.
    [[nodiscard]] std::vector<Vec3> corners(const Hollow& hollow, std::size_t along) {
        std::vector<Vec3> at;
        ++look_;
        for (const std::uint32_t t : hollow.triangles)
            for (const std::uint32_t p : body_.mesh().triangles[t])
                if (std::exchange(seen_[p].look, look_) != look_) at.push_back(body_.mesh().points_mm[p]);
        std::sort(at.begin(), at.end(), [&](const Vec3& p, const Vec3& q) { return p[along] < q[along]; });
        return at;
    }
    /// Only corners that are near each other in one coordinate are compared: an arc of a fine mesh has thousands of them.
    [[nodiscard]] bool touch(Arc& a, Arc& b) {
        std::size_t along = 0;  // the cylinder's axis: its rings have their corners at a few coordinates
        for (const std::size_t i : {1U, 2U})
            if (std::abs(a.hollow.axis[i]) > std::abs(a.hollow.axis[along])) along = i;
        const std::size_t across = (along + 1) % 3;
        for (Arc* arc : {&a, &b})
            if (arc->corners.empty() || arc->across != across) arc->corners = corners(arc->hollow, arc->across = across);
        auto begin = b.corners.begin();
        for (const Vec3& p : a.corners) {
            while (begin != b.corners.end() && (*begin)[across] < p[across] - kRound_mm) ++begin;
            for (auto q = begin; q != b.corners.end() && (*q)[across] <= p[across] + kRound_mm; ++q)
                if (length(*q - p) <= kRound_mm) return true;
        }
        return false;
    }
    static bool on_one_cylinder(const Hollow& a, const Hollow& b) {
        const double slack = std::max(kRound * a.diameter_mm, kRound_mm);
        return std::abs(dot(a.axis, b.axis)) > kOneAxis && std::abs(a.diameter_mm - b.diameter_mm) <= slack &&
               length(cross(b.middle_mm - a.middle_mm, a.axis)) <= slack;
    }

    /// A sliver turned by rounding divides a hole of many facets into arcs. Arcs that touch and lie on one cylinder are one hole.
    void join_arcs(std::vector<Arc>& found) {
        for (std::size_t i = 0; i < found.size(); ++i)
            for (std::size_t k = i + 1; k < found.size() && !found[i].hollow.is_hole();) {
                const Hollow &one = found[i].hollow, &other = found[k].hollow;
                std::optional<Hollow> both;
                if (!other.is_hole() && on_one_cylinder(one, other) && touch(found[i], found[k])) both = joined(one, other);
                if (!both) {
                    ++k;
                    continue;
                }
                found[i] = {std::move(*both)};
                found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
                k = i + 1;  // an arc that did not touch the piece may touch the union
            }
    }
    std::optional<Hollow> joined(const Hollow& a, const Hollow& b) {
        std::set<std::uint32_t> facets;
        for (const Hollow* h : {&a, &b})
            for (const std::uint32_t t : h->triangles) facets.insert(facets_.of(t));
        return measured(a.axis, {facets.begin(), facets.end()});
    }

    const Body& body_;
    Facets facets_;
    std::vector<bool> used_;  ///< facets of a hollow
    struct Reached {
        std::uint32_t by = 0;  ///< the number of the growth
        double width = 0.0;    ///< across its axis
    };
    std::vector<Reached> reached_;  ///< of each facet, the last time
    std::uint32_t growth_ = 0;
    struct Seen {
        std::uint32_t look = 0, number = 0;  ///< in the outline of this look
    };
    std::vector<Seen> seen_;  ///< of each point, the last time
    std::uint32_t look_ = 0;
};

}  // namespace

bool Hollow::is_hole() const { return covers > kHole && length_mm > kRing * diameter_mm; }

std::vector<Hollow> find_hollows(const Body& body) { return Grower(body).all(); }

}  // namespace fusee::inspect
