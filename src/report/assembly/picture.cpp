#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "fusee/assembly/motion.h"
#include "fusee/core/markup.h"
#include "fusee/report/assembly.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::Body, assembly::Pose, assembly::Prism;
using core::coordinate;
using Eigen::Vector2d, Eigen::Vector3d;
using Colour = std::array<std::uint8_t, 3>;

/// A parallel projection: x to the right, y downwards, as SVG has it.
struct View {
    Vector3d right, up, towards;  ///< towards the eye
    [[nodiscard]] Vector2d operator()(const Vector3d& p) const { return {right.dot(p), -up.dot(p)}; }
};
const View kFromAbove{Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};

View from_the_side() {
    const double azimuth = core::rad_from_deg(-55.0), elevation = core::rad_from_deg(32.0);
    const Vector3d right(-std::sin(azimuth), std::cos(azimuth), 0.0);
    const Vector3d towards(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    return {right, towards.cross(right), towards};
}

/// How far a body is moved in the exploded view [mm]: along z, and along K_PE's cable.
Vector3d moved_apart(const Assembly& a, const Body& body) {
    struct Move {
        double up, along;
    };
    static const std::map<std::string, Move> kMoves{
        {"rods", {-40.0, 0.0}},         {"axle", {30.0, 0.0}},         {"k_se", {60.0, 0.0}},  {"k_se_spring", {85.0, 0.0}},
        {"capstan", {40.0, 0.0}},       {"joint_pulley", {40.0, 0.0}}, {"k_pe", {-55.0, 0.0}}, {"k_pe_seat", {-55.0, 0.0}},
        {"k_pe_spring", {-55.0, 25.0}}, {"k_pe_cap", {-55.0, 50.0}}};
    const auto found = kMoves.find(body.base_name());
    if (found == kMoves.end()) return Vector3d::Zero();
    const double side = body.side == assembly::Side::kAntagonist ? -1.0 : 1.0, direction = a.options.k_pe_direction;
    return Vector3d(side * std::cos(direction), std::sin(direction), 0.0) * found->second.along + found->second.up * Vector3d::UnitZ();
}

/// What is drawn: SVG elements behind one another, and the space that they take.
class Canvas {
public:
    explicit Canvas(View view) : view_(std::move(view)) {}

    void draw(const Prism& prism, const Colour& colour) {
        const auto corner = [&](std::size_t i, double z) {
            const solid::Point2& p = prism.outline_mm[i % prism.outline_mm.size()];
            return Vector3d(p[0], p[1], z);
        };
        const std::size_t n = prism.outline_mm.size();
        const double low = prism.z_low_mm, high = prism.z_high_mm;
        for (std::size_t i = 0; i < n; ++i) {
            const Vector3d edge = corner(i + 1, low) - corner(i, low);
            const double facing = Vector3d(edge.y(), -edge.x(), 0.0).normalized().dot(view_.towards);
            if (facing <= 1e-9) continue;
            polygon({corner(i, low), corner(i + 1, low), corner(i + 1, high), corner(i, high)}, colour, 0.55 + 0.3 * facing, false);
        }
        std::vector<Vector3d> top;
        for (std::size_t i = 0; i < n; ++i) top.push_back(corner(i, high));
        polygon(top, colour, 1.0, true);
    }
    void line(const Vector3d& from, const Vector3d& to) {
        const Vector2d a = seen(from), b = seen(to);
        body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"#a02020\" stroke-width=\".8\"/>", coordinate(a.x()),
                             coordinate(a.y()), coordinate(b.x()), coordinate(b.y()));
    }
    void name(const Vector3d& at, const std::string& text) {
        constexpr double kSize_mm = 6.0, kLetter = 0.62;  // width of a letter over its size
        const Vector2d p = seen(at);
        high_ = high_.cwiseMax(p + Vector2d(kLetter * kSize_mm * static_cast<double>(text.size()), 0.0));
        body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"6\" font-family=\"sans-serif\">{}</text>", coordinate(p.x()),
                             coordinate(p.y()), core::escape(text));
    }
    /// What was drawn, moved to the right by `x` [mm].
    [[nodiscard]] std::string group(double x) const { return fmt::format("<g transform=\"translate({} 0)\">{}</g>", coordinate(x), body_); }
    [[nodiscard]] Vector2d low() const { return low_; }
    [[nodiscard]] Vector2d high() const { return high_; }

private:
    Vector2d seen(const Vector3d& p) {
        const Vector2d at = view_(p);
        low_ = low_.cwiseMin(at), high_ = high_.cwiseMax(at);
        return at;
    }
    void polygon(const std::vector<Vector3d>& corners, const Colour& colour, double light, bool outlined) {
        std::string points;
        for (const Vector3d& corner : corners) {
            const Vector2d p = seen(corner);
            points += coordinate(p.x()) + "," + coordinate(p.y()) + " ";
        }
        points.pop_back();
        body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"{} stroke=\"{}\" stroke-width=\".25\"/>", points, shaded(colour, light),
                             view_.towards.z() == 1.0 ? " fill-opacity=\".7\"" : "", outlined ? "#333" : shaded(colour, light));
    }
    static std::string shaded(const Colour& colour, double light) {
        const auto channel = [&](std::size_t i) { return std::lround(light * colour[i]); };
        return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2));
    }

    View view_;
    std::string body_;
    Vector2d low_{INFINITY, INFINITY}, high_{-INFINITY, -INFINITY};
};

struct Drawn {
    Prism prism;
    Colour colour;
    double depth;
};

/// Every body as its prisms, the farthest first.
std::vector<Drawn> drawn(const Assembly& a, const Pose& pose, const View& view, bool exploded) {
    std::vector<Drawn> all;
    for (const Body& body : a.bodies) {
        Eigen::Isometry3d at = assembly::placement(a, body, pose);
        if (exploded) at.pretranslate(moved_apart(a, body));
        for (const Prism& own : body.prisms) {
            Prism prism = assembly::placed(own, at);
            Vector3d middle(0.0, 0.0, prism.z_high_mm);
            for (const solid::Point2& p : prism.outline_mm)
                middle += Vector3d(p[0], p[1], 0.0) / static_cast<double>(prism.outline_mm.size());
            all.push_back({std::move(prism), colour_of(body), view.towards.dot(middle)});
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const Drawn& p, const Drawn& q) { return p.depth < q.depth; });
    return all;
}

Canvas draw(const Assembly& a, const Pose& pose, const View& view, bool exploded) {
    Canvas canvas(view);
    for (const Drawn& one : drawn(a, pose, view, exploded)) canvas.draw(one.prism, one.colour);
    if (!exploded)
        for (const assembly::FreeCable& cable : assembly::free_cables(a, pose)) canvas.line(cable.from_mm, cable.to_mm);
    for (const Body& body : a.bodies) {
        if (!exploded || body.side == assembly::Side::kAntagonist || body.prisms.empty()) continue;
        Eigen::Isometry3d at = body.rest;
        at.pretranslate(moved_apart(a, body));
        Vector3d right(-INFINITY, 0.0, 0.0);
        for (const Prism& own : body.prisms) {
            const Prism prism = assembly::placed(own, at);
            for (const solid::Point2& p : prism.outline_mm)
                if (p[0] > right.x()) right = {p[0], p[1], prism.z_high_mm};
        }
        canvas.name(right + Vector3d(4.0, 0.0, 0.0), body.base_name());
    }
    return canvas;
}

std::string svg(const Vector2d& low, const Vector2d& high, const std::string& content) {
    constexpr double kMargin = 8.0;
    const Vector2d size = high - low + Vector2d(2.0 * kMargin, 2.0 * kMargin);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" width=\"{}mm\" height=\"{}mm\" "
        "style=\"max-width:100%;height:auto\">"
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#fff\"/>{}</svg>\n",
        coordinate(low.x() - kMargin), coordinate(low.y() - kMargin), coordinate(size.x()), coordinate(size.y()), coordinate(size.x()),
        coordinate(size.y()), coordinate(low.x() - kMargin), coordinate(low.y() - kMargin), coordinate(size.x()), coordinate(size.y()),
        content);
}

}  // namespace

std::string assembly_svg(const Assembly& a, Picture picture) {
    const Pose rest;
    if (picture != Picture::kPlan) {
        const Canvas canvas = draw(a, rest, from_the_side(), picture == Picture::kExploded);
        return svg(canvas.low(), canvas.high(), canvas.group(0.0));
    }
    const double turn = std::min(a.greatest_turn, a.greatest_payout_mm / a.capstan_radius_mm);
    const Canvas low = draw(a, rest, kFromAbove, false), high = draw(a, assembly::pose_of(a, turn, turn, 0.0), kFromAbove, false);
    const double shift = low.high().x() - high.low().x() + 20.0;
    return svg(low.low().cwiseMin(high.low() + Vector2d(shift, 0.0)), low.high().cwiseMax(high.high() + Vector2d(shift, 0.0)),
               low.group(0.0) + high.group(shift));
}

}  // namespace fusee::report
