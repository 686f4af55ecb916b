#include <gtest/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <set>

#include "fixture.h"
#include "fusee/assembly/motion.h"

namespace fusee::assembly {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point>;
using Shadow = bg::model::multi_polygon<Polygon>;

/// A shape or a layer of a cam, seen along a direction: the area that it covers, and from where to where it is along it.
struct Seen {
    std::string body;
    int shape = 0;
    Shadow shadow;
    double low = 0.0, high = 0.0;
};

/// Axes of the picture: two across and the direction itself.
Eigen::Matrix3d axes_along(const Eigen::Vector3d& d) {
    Eigen::Matrix3d axes;
    const Eigen::Vector3d x = std::abs(d.x()) > 0.5 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
    axes << x.transpose(), d.cross(x).transpose(), d.transpose();
    return axes;
}

Polygon polygon_of(const solid::Ring& ring, const Eigen::Isometry3d& at) {
    Polygon polygon;
    for (const solid::Point2& p : ring) {
        const Eigen::Vector3d q = at * Eigen::Vector3d(p[0], p[1], 0.0);
        bg::append(polygon.outer(), Point(q.x(), q.y()));
    }
    bg::correct(polygon);
    return polygon;
}

void cut(Shadow& shadow, const Polygon& hole) {
    Shadow rest;
    bg::difference(shadow, hole, rest);
    shadow = std::move(rest);
}

solid::Ring outline_of(const Extrusion& s) {
    if (!s.outline.empty()) return solid::ring_of(s.outline, 0.02);
    if (s.radius_mm > 0.0) return solid::ring_of(solid::circle(s.radius_mm), 0.02);
    return {{-s.half_x_mm, -s.half_y_mm}, {s.half_x_mm, -s.half_y_mm}, {s.half_x_mm, s.half_y_mm}, {-s.half_x_mm, s.half_y_mm}};
}

/// Exact along the shape's own axis, with its holes; across it the hull of its corners.
Seen seen(const Extrusion& shape, const Eigen::Isometry3d& at) {
    Seen all;
    const Eigen::Isometry3d whole = at * shape.frame;
    bg::model::multi_point<Point> points;
    std::array<double, 2> ends{INFINITY, -INFINITY};
    for (const solid::Point2& p : outline_of(shape))
        for (const double z : {0.0, shape.length_mm}) {
            const Eigen::Vector3d q = whole * Eigen::Vector3d(p[0], p[1], z);
            bg::append(points, Point(q.x(), q.y()));
            ends = {std::min(ends[0], q.z()), std::max(ends[1], q.z())};
        }
    all.low = ends[0], all.high = ends[1];
    if (std::abs(whole.linear()(2, 2)) < 0.99) {
        Polygon hull;
        bg::convex_hull(points, hull);
        all.shadow.push_back(hull);
        return all;
    }
    all.shadow.push_back(polygon_of(outline_of(shape), whole));
    for (const RoundHole& hole : shape.holes)
        cut(all.shadow, polygon_of(solid::ring_of(solid::circle(hole.radius_mm, {hole.x_mm, hole.y_mm}), 0.02), whole));
    for (const solid::Outline& bore : shape.bores) cut(all.shadow, polygon_of(solid::ring_of(bore, 0.02), whole));
    return all;
}

/// The pieces of a body seen along a direction; a cam by its layers, with its bore.
std::vector<Seen> seen(const Assembly& a, const Body& body, int shape, const Eigen::Matrix3d& axes) {
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.linear() = axes;
    at = at * placement(a, body, {});
    std::vector<Seen> all;
    for (std::size_t i = 0; i < body.shapes.size(); ++i)
        if (shape < 0 || static_cast<std::size_t>(shape) == i) all.push_back(seen(body.shapes[i], at));
    if (!body.cam) return all;
    const solid::HubOptions& hub = (body.base_name() == "k_se" ? a.drive.k_se : a.drive.k_pe)->options.hub;
    for (const Prism& prism : body.prisms) {
        Extrusion layer;
        layer.outline = {};
        for (const solid::Point2& p : prism.outline_mm) layer.outline.push_back({p, 0.0, 0.0, 0.0});
        layer.frame.translation().z() = prism.z_low_mm, layer.length_mm = prism.z_high_mm - prism.z_low_mm;
        solid::Outline bore = solid::bore_outline(hub);
        layer.bores = {body.side == Side::kAntagonist ? solid::mirrored_in_y(bore) : bore};
        all.push_back(seen(layer, at));
    }
    return all;
}

/// Mean width of what two shadows have in common [mm]; polygons of circles that touch share slivers of 0.02 mm.
double common_mm(const Shadow& a, const Shadow& b) {
    Shadow common;
    bg::intersection(a, b, common);
    const auto around = static_cast<double>(bg::perimeter(common));
    return around > 0.0 ? 2.0 * bg::area(common) / around : 0.0;
}

/// Pairs that the shapes do not show: a leg in the slot of the cam, and in a bore that ends.
bool is_fitted(const std::string& a, const std::string& b) {
    const std::set<std::string> pair{a.substr(0, a.rfind('_')), b.substr(0, b.rfind('_'))};
    return pair == std::set<std::string>{"leg_in_k_se", "k_se"};
}

class Order : public testing::TestWithParam<const char*> {
protected:
    using Placed = std::vector<std::pair<const Body*, int>>;
    static Placed bodies_of(const Assembly& a, const Step& step, const std::string& side) {
        Placed all;
        for (const Piece& piece : step.pieces) {
            const Body* body = a.find(piece.body);
            if (body == nullptr) body = a.find(piece.body + "_" + side);
            EXPECT_NE(body, nullptr) << piece.body;
            if (body != nullptr) all.emplace_back(body, piece.shape);
        }
        return all;
    }
    /// What stands in the way of a step; "" nothing.
    static std::string blocked(const Assembly& a, const Placed& there, const Placed& moving, const Eigen::Vector3d& along) {
        const Eigen::Matrix3d axes = axes_along(along);
        for (const auto& [body, shape] : moving)
            for (const Seen& one : seen(a, *body, shape, axes))
                for (const auto& [other, part] : there)
                    for (const Seen& fixed : seen(a, *other, part, axes)) {
                        if (fixed.low >= one.high - 0.01 || is_fitted(body->name, other->name)) continue;  // beyond its place
                        if (common_mm(one.shadow, fixed.shadow) > 0.05) return body->name + " meets " + other->name;
                    }
        return "";
    }
};

// A step's bodies come from afar: they must pass whatever is before their place along the way. Nothing is left over.
TEST_P(Order, EveryStepHasAFreePath) {
    const Assembly& a = shipped_joint(GetParam()).assembly;
    const std::vector<Step> steps = assembly_steps(a);
    ASSERT_FALSE(steps.empty());
    std::map<std::string, Placed> subassemblies;  // by subassembly and side
    std::size_t placed = 0;
    for (const Step& step : steps)
        for (const char* side : {"agonist", "antagonist"}) {
            const Placed moving = bodies_of(a, step, side);
            if (std::string(side) == "antagonist" && moving.front().first->side == Side::kBoth) continue;
            Placed& there = subassemblies[step.subassembly + (step.subassembly == "carriage" ? side : "")];
            if (step.along.norm() > 0.0) {
                EXPECT_EQ(blocked(a, there, moving, step.along), "") << step.subassembly << ": " << step.pieces.front().body;
            }
            there.insert(there.end(), moving.begin(), moving.end());
            if (!step.subassembly.empty()) continue;
            for (const auto& [body, shape] : moving) placed += shape < 0 ? std::max<std::size_t>(body->shapes.size(), 1) : 1;
        }
    std::size_t all = 0;
    for (const Body& body : a.bodies) all += std::max<std::size_t>(body.shapes.size(), 1);
    EXPECT_EQ(placed, all);
}

INSTANTIATE_TEST_SUITE_P(Shipped, Order, testing::Values("pnrvsa", "free_curve", "paper/new_cams", "init"),
                         [](const auto& one) { return std::filesystem::path(one.param).filename().string(); });

}  // namespace
}  // namespace fusee::assembly
