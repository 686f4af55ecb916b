#include <boost/geometry/algorithms/append.hpp>
#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <limits>

#include "fusee/core/kept.h"
#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false>;

constexpr double kChordalShare = 0.01;  // of the radius of wires and small holes

double chordal_mm(double radius_mm) { return std::min(kChordal_mm, kChordalShare * radius_mm); }

solid::Ring outline_of(const Extrusion& shape) {
    return solid::ring_of(shape, shape.outline.empty() ? chordal_mm(shape.radius_mm) : kChordal_mm);
}

/// The regular polygon around a circle, within 0.02 mm.
solid::Ring around_circle(double radius_mm) {
    solid::Ring ring = solid::ring_of(solid::circle(radius_mm), chordal_mm(radius_mm));
    const double wider = 1.0 / std::cos(core::kPi / static_cast<double>(ring.size()));
    for (solid::Point2& p : ring) p[0] *= wider, p[1] *= wider;
    return ring;
}

/// The polygon of the supporting lines in 48 directions, which holds all points: larger than the hull by at most 0.3 % of its radius.
solid::Ring supports_of(const std::vector<solid::Point2>& points) {
    constexpr int kDirections = 48;
    std::vector<double> support;
    const auto angle = [](int i) { return 2.0 * core::kPi * i / kDirections; };
    for (int i = 0; i < kDirections; ++i) {
        double most = -std::numeric_limits<double>::infinity();
        for (const solid::Point2& p : points) most = std::max(most, p[0] * std::cos(angle(i)) + p[1] * std::sin(angle(i)));
        support.push_back(most);
    }
    solid::Ring ring;
    const double step = angle(1), sine = std::sin(step), cosine = std::cos(step);
    for (int i = 0; i < kDirections; ++i) {  // where the lines of two directions cross: along the first one's tangent
        const double along =
            (support[static_cast<std::size_t>((i + 1) % kDirections)] - support[static_cast<std::size_t>(i)] * cosine) / sine;
        const double c = std::cos(angle(i)), s = std::sin(angle(i)), h = support[static_cast<std::size_t>(i)];
        ring.push_back({h * c - along * s, h * s + along * c});
    }
    return ring;
}

Polygon polygon_of(const solid::Ring& ring) {
    Polygon polygon;
    for (const solid::Point2& p : ring) polygon.outer().emplace_back(p[0], p[1]);
    if (!ring.empty()) polygon.outer().emplace_back(ring.front()[0], ring.front()[1]);
    return polygon;
}

/// Distance of the rectangles around two rings: at most the rings' distance.
double box_distance_mm(const solid::Ring& a, const solid::Ring& b) {
    double squared = 0.0;
    for (const std::size_t k : {0U, 1U}) {
        const auto less = [k](const solid::Point2& p, const solid::Point2& q) { return p[k] < q[k]; };
        const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), less);
        const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), less);
        squared += std::pow(std::max({(*low_b)[k] - (*high_a)[k], (*low_a)[k] - (*high_b)[k], 0.0}), 2);
    }
    return std::sqrt(squared);
}

double gap(double low_a, double high_a, double low_b, double high_b) { return std::max({low_b - high_a, low_a - high_b, 0.0}); }

/// In its own frame.
solid::Mesh upright_mesh(const Extrusion& shape) {
    solid::Mesh mesh;
    const solid::Ring outline = outline_of(shape);
    const solid::VertexRing low = solid::add_ring(mesh, outline, 0.0), high = solid::add_ring(mesh, outline, shape.length_mm);
    std::vector<solid::VertexRing> low_holes, high_holes;
    std::vector<solid::Ring> holes;
    for (const solid::Outline& bore : shape.bores) holes.push_back(solid::ring_of(bore, kChordal_mm));
    for (const RoundHole& hole : shape.holes)
        holes.push_back(solid::ring_of(solid::circle(hole.radius_mm, {hole.x_mm, hole.y_mm}), chordal_mm(hole.radius_mm)));
    for (const solid::Ring& ring : holes) {
        low_holes.push_back(solid::add_ring(mesh, ring, 0.0));
        high_holes.push_back(solid::add_ring(mesh, ring, shape.length_mm));
        solid::add_wall_between(mesh, low_holes.back(), high_holes.back(), false);
    }
    solid::add_wall_between(mesh, low, high, true);
    const std::size_t first = mesh.triangles.size();
    solid::fill_face(mesh, low, low_holes, false);
    // The upper end is the lower one upside down: each upper ring follows its lower one.
    std::vector<std::uint32_t> above(mesh.points_mm.size());
    const auto pair = [&above](const solid::VertexRing& lower, const solid::VertexRing& upper) {
        for (std::size_t i = 0; i < lower.size(); ++i) above[lower[i]] = upper[i];
    };
    pair(low, high);
    for (std::size_t i = 0; i < holes.size(); ++i) pair(low_holes[i], high_holes[i]);
    for (std::size_t i = first, last = mesh.triangles.size(); i < last; ++i) {
        const solid::Triangle t = mesh.triangles[i];
        mesh.triangles.push_back({above[t[0]], above[t[2]], above[t[1]]});
    }
    return mesh;
}

/// All that the mesh in its own frame depends on.
std::vector<double> sizes_of(const Extrusion& shape) {
    std::vector<double> sizes{shape.radius_mm, shape.half_x_mm, shape.half_y_mm, shape.length_mm, static_cast<double>(shape.holes.size())};
    for (const RoundHole& hole : shape.holes) sizes.insert(sizes.end(), {hole.x_mm, hole.y_mm, hole.radius_mm});
    const auto add = [&sizes](const solid::Outline& outline) {
        sizes.push_back(-static_cast<double>(outline.size()));
        for (const solid::Arc& a : outline) sizes.insert(sizes.end(), {a.centre_mm[0], a.centre_mm[1], a.radius_mm, a.begin, a.end});
    };
    add(shape.outline);
    for (const solid::Outline& bore : shape.bores) add(bore);
    return sizes;
}

}  // namespace

solid::Ring hull_of(const solid::Ring& points) {
    bg::model::multi_point<Point> all;
    for (const solid::Point2& p : points) bg::append(all, Point(p[0], p[1]));
    Polygon hull;
    bg::convex_hull(all, hull);
    solid::Ring ring;
    for (std::size_t i = 0; i + 1 < hull.outer().size(); ++i) ring.push_back({hull.outer()[i].x(), hull.outer()[i].y()});
    return ring;
}

Extrusion rod(const Eigen::Vector3d& from, const Eigen::Vector3d& axis, double radius_mm, double length_mm, double bore_radius_mm) {
    Extrusion shape;
    shape.frame = Eigen::Translation3d(from) * Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis);
    shape.radius_mm = radius_mm, shape.length_mm = length_mm;
    if (bore_radius_mm > 0.0) shape.holes.push_back({0.0, 0.0, bore_radius_mm});
    return shape;
}

Extrusion round(double radius_mm, double z_low_mm, double z_high_mm, double bore_radius_mm) {
    return rod({0.0, 0.0, z_low_mm}, Eigen::Vector3d::UnitZ(), radius_mm, z_high_mm - z_low_mm, bore_radius_mm);
}

Extrusion box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, std::vector<RoundHole> holes) {
    Extrusion shape;
    const Eigen::Vector3d middle = 0.5 * (low + high);
    shape.frame.translation() = Eigen::Vector3d(middle.x(), middle.y(), low.z());
    shape.half_x_mm = 0.5 * (high.x() - low.x()), shape.half_y_mm = 0.5 * (high.y() - low.y()), shape.length_mm = high.z() - low.z();
    for (RoundHole& hole : holes) hole.x_mm -= middle.x(), hole.y_mm -= middle.y();
    shape.holes = std::move(holes);
    return shape;
}

solid::Mesh mesh_of(const Extrusion& shape) {
    constexpr std::size_t kMeshes = 128;  // of a joint: files, pictures and pages ask for each, the other side for most of them again
    static core::Kept<std::vector<double>, solid::Mesh> meshes(kMeshes);
    std::vector<double> sizes = sizes_of(shape);
    auto mesh = meshes.find(sizes);
    if (!mesh) meshes.keep(std::move(sizes), *(mesh = upright_mesh(shape)));
    return moved(std::move(*mesh), shape.frame);
}

solid::Mesh moved(solid::Mesh mesh, const Eigen::Isometry3d& placement) {
    for (solid::Vec3& p : mesh.points_mm) {
        const Eigen::Vector3d at = placement * Eigen::Vector3d(p[0], p[1], p[2]);
        p = {at.x(), at.y(), at.z()};
    }
    return mesh;
}

Extrusion mirrored(const Extrusion& shape) {
    const Eigen::DiagonalMatrix<double, 3> flip(-1.0, 1.0, 1.0);
    Extrusion image = shape;  // a disc or box is its own mirror image; both frames are right-handed
    image.frame.linear() = flip * shape.frame.linear() * flip;
    image.frame.translation() = flip * shape.frame.translation();
    if (shape.outline.empty() && shape.bores.empty()) {
        for (RoundHole& hole : image.holes) hole.x_mm = -hole.x_mm;
        return image;
    }
    // A flat or key towards +x of its frame stays there: the frame is turned by half a turn, and the outline is mirrored in y instead.
    image.frame.linear().col(0) *= -1.0, image.frame.linear().col(1) *= -1.0;
    for (RoundHole& hole : image.holes) hole.y_mm = -hole.y_mm;
    image.outline = solid::mirrored_in_y(shape.outline);
    for (solid::Outline& bore : image.bores) bore = solid::mirrored_in_y(bore);
    return image;
}

Prism prism_of(const Extrusion& shape, const Eigen::Isometry3d& placement) {
    const Eigen::Isometry3d whole = placement * shape.frame;
    solid::Ring points;
    Prism prism{{}, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    solid::Ring outline = outline_of(shape);
    if (shape.radius_mm > 0.0) outline = around_circle(shape.radius_mm);  // a flat's whole shaft
    for (const solid::Point2& p : outline)
        for (const double z : {0.0, shape.length_mm}) {
            const Eigen::Vector3d at = whole * Eigen::Vector3d(p[0], p[1], z);
            points.push_back({at.x(), at.y()});
            prism.z_low_mm = std::min(prism.z_low_mm, at.z());
            prism.z_high_mm = std::max(prism.z_high_mm, at.z());
        }
    prism.outline_mm = hull_of(points);
    return prism;
}

std::vector<Prism> layers_of(const solid::Mesh& mesh, const std::vector<double>& z_levels_mm) {
    constexpr double kRounding_mm = 1e-6;
    std::vector<Prism> layers;
    for (std::size_t i = 0; i + 1 < z_levels_mm.size(); ++i) {
        const double low = z_levels_mm[i], high = z_levels_mm[i + 1];
        std::vector<solid::Point2> points;
        for (const solid::Triangle& triangle : mesh.triangles) {
            const auto [least, most] =
                std::minmax({mesh.points_mm[triangle[0]][2], mesh.points_mm[triangle[1]][2], mesh.points_mm[triangle[2]][2]});
            if (most <= low + kRounding_mm || least >= high - kRounding_mm) continue;
            for (const std::uint32_t corner : triangle) points.push_back({mesh.points_mm[corner][0], mesh.points_mm[corner][1]});
        }
        if (!points.empty()) layers.push_back({supports_of(points), low, high});
    }
    return layers;
}

Prism placed(const Prism& prism, const Eigen::Isometry3d& placement) {
    Prism moved;
    for (const solid::Point2& p : prism.outline_mm) {
        const Eigen::Vector3d at = placement * Eigen::Vector3d(p[0], p[1], 0.0);
        moved.outline_mm.push_back({at.x(), at.y()});
    }
    if (placement.linear().determinant() * placement.linear()(2, 2) < 0.0) std::reverse(moved.outline_mm.begin(), moved.outline_mm.end());
    const double a = (placement * Eigen::Vector3d(0.0, 0.0, prism.z_low_mm)).z(),
                 b = (placement * Eigen::Vector3d(0.0, 0.0, prism.z_high_mm)).z();
    moved.z_low_mm = std::min(a, b), moved.z_high_mm = std::max(a, b);
    return moved;
}

Prism disc_around(const Prism& prism) {
    double radius = 0.0;
    for (const solid::Point2& p : prism.outline_mm) radius = std::max(radius, std::hypot(p[0], p[1]));
    return {around_circle(radius), prism.z_low_mm, prism.z_high_mm};
}

Prism hull_between(const Prism& prism, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    solid::Ring points;
    for (const solid::Point2& p : prism.outline_mm)
        for (const Eigen::Vector3d* by : {&from, &to}) points.push_back({p[0] + by->x(), p[1] + by->y()});
    return {hull_of(points), prism.z_low_mm, prism.z_high_mm};
}

double distance_mm(const Prism& a, const Prism& b, double most_mm) {
    if (box_distance_mm(a.outline_mm, b.outline_mm) >= most_mm) return most_mm;
    const double height = gap(a.z_low_mm, a.z_high_mm, b.z_low_mm, b.z_high_mm);
    if (height >= most_mm) return most_mm;
    return std::min(std::hypot(bg::distance(polygon_of(a.outline_mm), polygon_of(b.outline_mm)), height), most_mm);
}

double distance_mm(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Prism& prism, double most_mm) {
    const auto [low, high] = std::minmax(from.z(), to.z());
    const double height = gap(low, high, prism.z_low_mm, prism.z_high_mm);
    if (height >= most_mm) return most_mm;
    const bg::model::linestring<Point> line{{from.x(), from.y()}, {to.x(), to.y()}};
    return std::min(std::hypot(bg::distance(line, polygon_of(prism.outline_mm)), height), most_mm);
}

}  // namespace fusee::assembly
