#include "floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <unsupported/Eigen/Splines>

#include "fusee/core/azimuth_bins.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/exchange/stl.h"

namespace fusee::readback {

namespace {

/// Intersects horizontal rays from the z axis with triangles, in bins of azimuth with height ranges.
class RaySearch {
public:
    /// Keeps the triangles with heights in [low_mm, high_mm].
    RaySearch(const solid::Mesh& mesh, double low_mm, double high_mm);

    /// Distance from the axis of the outermost hit at height z; nothing if the ray meets no surface.
    [[nodiscard]] std::optional<double> outermost(double azimuth, double z_mm) const;

private:
    struct Facet {
        std::array<solid::Vec3, 3> corner;
        double low, high;
    };
    std::vector<Facet> facets_;
    core::AzimuthBins bins_;  ///< of facets_
};

struct Direction {
    double x, y;
};

/// Farthest point along the ray of the horizontal segment pq; -1 for no hit. Closed at both ends: two facets with a common point
/// of the section compute it from the same numbers, so that no ray passes between them.
double hit(Direction u, const std::array<double, 2>& p, const std::array<double, 2>& q) {
    const double cp = u.x * p[1] - u.y * p[0], cq = u.x * q[1] - u.y * q[0];
    const double ap = u.x * p[0] + u.y * p[1], aq = u.x * q[0] + u.y * q[1];
    if (cp == 0.0 && cq == 0.0) return std::max(ap, aq);
    if ((cp > 0.0 && cq > 0.0) || (cp < 0.0 && cq < 0.0)) return -1.0;
    return ap + (aq - ap) * cp / (cp - cq);
}

/// Crossing of edge ab with height z; the lower end first, so that both facets of an edge round in the same way.
std::array<double, 2> crossing(const solid::Vec3& a, const solid::Vec3& b, double z) {
    const solid::Vec3 &low = a[2] <= b[2] ? a : b, &high = a[2] <= b[2] ? b : a;
    const double t = (z - low[2]) / (high[2] - low[2]);
    return {low[0] + (high[0] - low[0]) * t, low[1] + (high[1] - low[1]) * t};
}

double farthest_hit(const std::array<solid::Vec3, 3>& corner, Direction u, double z) {
    std::array<std::array<double, 2>, 6> cut{};  // corners on the plane, then proper crossings
    std::size_t n = 0;
    for (const solid::Vec3& c : corner)
        if (c[2] == z) cut[n++] = {c[0], c[1]};
    for (std::size_t i = 0; i < 3; ++i) {
        const solid::Vec3 &a = corner[i], &b = corner[(i + 1) % 3];
        if ((a[2] < z && b[2] > z) || (a[2] > z && b[2] < z)) cut[n++] = crossing(a, b, z);
    }
    double far = n == 1 ? hit(u, cut[0], cut[0]) : -1.0;
    for (std::size_t i = 0; i + 1 < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) far = std::max(far, hit(u, cut[i], cut[j]));
    return far;
}

RaySearch::RaySearch(const solid::Mesh& mesh, double low_mm, double high_mm) {
    for (const solid::Triangle& t : mesh.triangles) {
        Facet facet{{mesh.points_mm[t[0]], mesh.points_mm[t[1]], mesh.points_mm[t[2]]}, 0.0, 0.0};
        const auto& c = facet.corner;
        facet.low = std::min({c[0][2], c[1][2], c[2][2]});
        facet.high = std::max({c[0][2], c[1][2], c[2][2]});
        if (facet.high < low_mm || facet.low > high_mm) continue;
        bins_.add(static_cast<std::uint32_t>(facets_.size()),
                  std::array{std::array{c[0][0], c[0][1]}, std::array{c[1][0], c[1][1]}, std::array{c[2][0], c[2][1]}});
        facets_.push_back(facet);
    }
}

std::optional<double> RaySearch::outermost(double azimuth, double z_mm) const {
    const Direction u{std::cos(azimuth), std::sin(azimuth)};
    double far = -1.0;
    for (const std::uint32_t i : bins_.at(azimuth))
        if (const Facet& facet = facets_[i]; facet.low <= z_mm && z_mm <= facet.high)
            far = std::max(far, farthest_hit(facet.corner, u, z_mm));
    return far > 0.0 ? std::optional(far) : std::nullopt;
}

constexpr int kRaysPerRow = 5;
constexpr int kRaysRound = 512;          // around the rest of a planar outline, where no arm depends on a chord
constexpr int kPointsPerSpan = 32;       // of a drawn spline: spans are 0.2 rad at most, the chord error 5e-6 of the arm
constexpr double kSameHeight_mm = 1e-6;  // contacts of a planar part differ by less: the last digit of single precision at 10 mm

/// The target of a ray.
struct Aim {
    double azimuth = 0.0, z_mm = 0.0;
};

/// Direction from the neighbour before contact `i` to the next one: the tangent of the centreline from the rows.
Point tangent(const std::vector<exchange::TargetRow>& rows, std::size_t i) {
    const auto& a = rows[i == 0 ? 0 : i - 1].contact_mm;
    const auto& b = rows[std::min(i + 1, rows.size() - 1)].contact_mm;
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    return length > 0.0 ? Point{(b[0] - a[0]) / length, (b[1] - a[1]) / length} : Point{};
}

/// Where the floor is expected under each row: half a cable from the contact towards the axis, square to the centreline. It sets only the
/// places of the rays; the result depends on the file.
std::vector<Aim> aims(const exchange::PartFile& part) {
    std::vector<Aim> result;
    for (std::size_t i = 0; i < part.target.size(); ++i) {
        const auto& c = part.target[i].contact_mm;
        const Point t = tangent(part.target, i);
        Point n{t[1], -t[0]};
        if (n[0] * c[0] + n[1] * c[1] < 0.0) n = {-n[0], -n[1]};
        const double half = part.cable_diameter_mm / 2.0;
        double azimuth = std::atan2(c[1] - half * n[1], c[0] - half * n[0]);
        if (i > 0) azimuth = result.back().azimuth + std::remainder(azimuth - result.back().azimuth, core::kTurn);
        result.push_back({azimuth, c[2]});
    }
    return result;
}

/// kRaysPerRow aims from every row to the next, and one more row beyond both ends, for the last tangents.
std::vector<Aim> refined(const std::vector<Aim>& rows) {
    std::vector<Aim> result;
    const auto between = [](const Aim& a, const Aim& b, double s) {
        return Aim{a.azimuth + s * (b.azimuth - a.azimuth), a.z_mm + s * (b.z_mm - a.z_mm)};
    };
    const int last = static_cast<int>(rows.size()) - 1;
    for (int k = -2 * kRaysPerRow; k <= (last + 2) * kRaysPerRow; ++k) {
        const int i = std::clamp(k / kRaysPerRow, 0, std::max(last - 1, 0));
        const Aim &a = rows[static_cast<std::size_t>(i)], &b = rows[static_cast<std::size_t>(std::min(i + 1, last))];
        result.push_back(between(a, b, static_cast<double>(k) / kRaysPerRow - i));
    }
    return result;
}

core::Range heights(const std::vector<Aim>& places) {
    const auto [low, high] = std::minmax_element(places.begin(), places.end(), [](const Aim& a, const Aim& b) { return a.z_mm < b.z_mm; });
    return {low->z_mm, high->z_mm};
}

bool one_height(const std::vector<Aim>& rows) { return heights(rows).width() <= kSameHeight_mm; }

/// The search for the floor of a part.
struct Search {
    explicit Search(const exchange::PartFile& part) : rows(aims(part)), planar(one_height(rows)), rays(refined(rows)) {
        for (int i = 0; planar && i < kRaysRound; ++i) rays.push_back({core::kTurn * i / kRaysRound, rows.front().z_mm});
    }
    std::vector<Aim> rows;
    bool planar;            ///< all rows have one height
    std::vector<Aim> rays;  ///< along the rows, and all around if they have one height
};

Floor found_floor(const Search& search, const Ray& ray) {
    Floor floor;
    floor.planar = search.planar;
    for (const Aim& row : search.rows) floor.row_azimuth.push_back(row.azimuth);
    for (const Aim& aim : search.rays)
        if (const auto r = ray(aim.azimuth, aim.z_mm))
            floor.points.push_back({{*r * std::cos(aim.azimuth), *r * std::sin(aim.azimuth)}, aim.azimuth});
    return floor;
}

void add_points(Floor& floor, const exchange::brep::PlaneSpline& spline) {
    const auto count = static_cast<Eigen::Index>(spline.control_mm.size());
    Eigen::Matrix2Xd control(2, count);
    for (Eigen::Index i = 0; i < count; ++i)
        control.col(i) << spline.control_mm[static_cast<std::size_t>(i)][0], spline.control_mm[static_cast<std::size_t>(i)][1];
    const Eigen::Map<const Eigen::RowVectorXd> knots(spline.knots.data(), static_cast<Eigen::Index>(spline.knots.size()));
    const Eigen::Spline<double, 2, Eigen::Dynamic> curve(knots, control);
    for (std::size_t k = 1; k < spline.knots.size(); ++k)
        for (int i = 0; i < kPointsPerSpan && spline.knots[k] > spline.knots[k - 1]; ++i) {
            const double share = static_cast<double>(i) / kPointsPerSpan;
            const Eigen::Vector2d p = curve(spline.knots[k - 1] + share * (spline.knots[k] - spline.knots[k - 1]));
            floor.points.push_back({{p[0], p[1]}, 0.0});
        }
}

}  // namespace

Floor find_floor(const Ray& ray, const exchange::PartFile& part) { return found_floor(Search(part), ray); }

Floor find_floor(const solid::Mesh& mesh, const exchange::PartFile& part) {
    const Search search(part);
    const auto [low, high] = heights(search.rays);
    const RaySearch facets(mesh, low, high);
    return found_floor(search, [&facets](double azimuth, double z_mm) { return facets.outermost(azimuth, z_mm); });
}

Floor drawn_floor(const exchange::DxfDrawing& drawing, Drawn drawn, const exchange::PartFile& part, const std::string& file) {
    if (!one_height(aims(part))) throw core::IoError(file, "a flat drawing cannot hold the groove of a helix");
    const std::string name = drawn == Drawn::kPolyline ? "FLOOR" : "FLOOR_SPLINE";
    const exchange::DxfLayer* layer = drawing.layer(name);
    Floor floor;
    if (layer != nullptr && drawn == Drawn::kPolyline)
        for (const exchange::DxfPolyline& line : layer->polylines)
            for (const Point& p : line.points_mm) floor.points.push_back({p, 0.0});
    if (layer != nullptr && drawn == Drawn::kSpline)
        for (const exchange::brep::PlaneSpline& spline : layer->splines) add_points(floor, spline);
    if (floor.points.empty()) throw core::IoError(file, "has no curve on the layer " + name);
    return floor;
}

}  // namespace fusee::readback
