#include "fusee/drawing/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>

#include "assembly/shown.h"
#include "fusee/assembly/motion.h"
#include "fusee/core/text.h"
#include "fusee/report/assembly.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::Body, assembly::Pose;
using core::coordinate;
using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kNameLetter = 0.62;           // width of a letter over its size
constexpr const char* kCover = "frame_plate";  // would hide the joint in all pictures but the exploded one

/// The mesh of every body in its own frame, once for all pictures.
std::vector<solid::Mesh> meshes_of(const Assembly& a) {
    std::vector<solid::Mesh> meshes;
    for (const Body& body : a.bodies) meshes.push_back(shown_mesh(a, body));
    return meshes;
}

/// Every body in a pose, and the free cables where nothing is moved apart. A spring is shown by its coils, where they are known.
std::vector<drawing::Object> scene_of(const Assembly& a, const std::vector<solid::Mesh>& meshes, const Pose& pose, bool exploded) {
    constexpr drawing::Colour kCable{160, 32, 32};
    std::vector<drawing::Object> objects;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const Body& body = a.bodies[i];
        if (!exploded && body.name == kCover) continue;
        Eigen::Isometry3d at = assembly::placement(a, body, pose);
        if (exploded) at.pretranslate(moved_apart(a, body));
        const std::optional<drawing::Coil> coil = coil_of(a, body, pose);
        solid::Mesh shown = coil ? assembly::moved(drawing::coil_mesh(*coil), body.shapes.front().frame) : meshes[i];
        objects.push_back({assembly::moved(std::move(shown), at), colour_of(body)});
    }
    if (!exploded)
        for (const assembly::FreeCable& cable : assembly::free_cables(a, pose))
            objects.push_back({drawing::tube({cable.from_mm, cable.to_mm}, 0.5 * a.cable_mm), kCable});
    return objects;
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

/// A name beside the picture and the place that it names, y downwards [mm].
struct Label {
    std::string name;
    Vector2d at;
    double y = 0.0;  ///< of the name
};

/// Moves the names of one column apart, each as near to its place as those above it allow. @param least_mm between two lines
void spread(std::vector<Label>& column, double least_mm, double top, double bottom) {
    std::sort(column.begin(), column.end(), [](const Label& a, const Label& b) { return a.at.y() < b.at.y(); });
    double y = top;
    for (Label& label : column) label.y = std::max(y, label.at.y()), y = label.y + least_mm;
    y = bottom;
    for (auto label = column.rbegin(); label != column.rend(); ++label) label->y = std::min(label->y, y), y = label->y - least_mm;
}

/// The names of the agonist's bodies and of the pulley, in a column on each side, with a line to each.
std::string named(const Assembly& a, const drawing::Picture& picture, Vector2d& low, Vector2d& high) {
    const double size = 0.018 * (high - low).maxCoeff(), middle = 0.5 * (low.x() + high.x());
    std::array<std::vector<Label>, 2> columns;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const drawing::Visible& seen = picture.visible[i];
        if (a.bodies[i].side == assembly::Side::kAntagonist || seen.pixels == 0) continue;
        const Vector2d at(seen.nearest_mm.x(), -seen.nearest_mm.y());
        columns[at.x() > middle ? 1 : 0].push_back({a.bodies[i].base_name(), at});
    }
    const std::array<double, 2> edge{low.x() - size, high.x() + size};
    std::string content;
    for (std::size_t c = 0; c < 2; ++c) {
        spread(columns[c], 1.6 * size, low.y() + size, high.y());
        for (const Label& label : columns[c]) {
            content += fmt::format(
                "<path d=\"M{} {} L{} {}\" stroke=\"#222\" stroke-width=\"{}\"/><circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>"
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\" font-family=\"sans-serif\"{}>{}</text>",
                coordinate(label.at.x()), coordinate(label.at.y()), coordinate(edge[c]), coordinate(label.y), coordinate(0.06 * size),
                coordinate(label.at.x()), coordinate(label.at.y()), coordinate(0.2 * size),
                coordinate(edge[c] + (c == 0 ? -0.3 : 0.3) * size), coordinate(label.y + 0.35 * size), coordinate(size),
                c == 0 ? " text-anchor=\"end\"" : "", core::escape(label.name));
            const double width = (kNameLetter * static_cast<double>(label.name.size()) + 0.3) * size;
            if (c == 0) low.x() = std::min(low.x(), edge[0] - width);
            if (c == 1) high.x() = std::max(high.x(), edge[1] + width);
        }
    }
    return content;
}

/// The eye of all shaded pictures of a joint.
drawing::Projection eye() { return drawing::from_direction(core::rad_from_deg(-55.0), core::rad_from_deg(32.0)); }

/// A pose of the cycle at `share` of it, 0 to 1: both capstans wind to the greatest turn and back while the joint swings to each side once,
/// as far as they allow.
Pose cycle_pose(const Assembly& a, double share) {
    const double most = std::min(a.greatest_turn, a.greatest_payout_mm / a.capstan_radius_mm);
    const double turn = most * 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * share));
    return assembly::pose_of(a, turn, turn, assembly::greatest_joint_angle(a, turn) * std::sin(2.0 * std::numbers::pi * share));
}

/// A shaded picture inside an SVG, where names are text.
std::string shaded(const Assembly& a, const std::vector<solid::Mesh>& meshes, const Pose& pose, bool exploded, int longest_px) {
    const drawing::Picture picture = drawing::draw(scene_of(a, meshes, pose, exploded), eye(), longest_px);
    Vector2d low(picture.low_mm.x(), -picture.high_mm.y()), high(picture.high_mm.x(), -picture.low_mm.y());
    std::string content =
        fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"{}\"/>", coordinate(low.x()), coordinate(low.y()),
                    coordinate(high.x() - low.x()), coordinate(high.y() - low.y()), drawing::data_uri(drawing::png(picture)));
    if (exploded) content += named(a, picture, low, high);
    return svg(low, high, content);
}

/// The joint seen along its axis: outlines of hulls, the highest last, and free cables.
struct Plan {
    std::string content;
    Vector2d low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};

    Vector2d seen(const Vector3d& p) {
        const Vector2d at(p.x(), -p.y());
        low = low.cwiseMin(at), high = high.cwiseMax(at);
        return at;
    }
};

Plan plan_of(const Assembly& a, const Pose& pose) {
    struct Outline {
        assembly::Prism prism;
        drawing::Colour colour;
    };
    std::vector<Outline> outlines;
    for (const Body& body : a.bodies)
        for (const assembly::Prism& own : body.prisms)
            if (body.name != kCover) outlines.push_back({assembly::placed(own, assembly::placement(a, body, pose)), colour_of(body)});
    std::stable_sort(outlines.begin(), outlines.end(),
                     [](const Outline& p, const Outline& q) { return p.prism.z_high_mm < q.prism.z_high_mm; });
    Plan plan;
    for (const auto& [prism, colour] : outlines) {
        std::string points;
        for (const solid::Point2& corner : prism.outline_mm) {
            const Vector2d p = plan.seen({corner[0], corner[1], 0.0});
            points += (points.empty() ? "" : " ") + coordinate(p.x()) + "," + coordinate(p.y());
        }
        plan.content +=
            fmt::format("<polygon points=\"{}\" fill=\"#{:02x}{:02x}{:02x}\" fill-opacity=\".7\" stroke=\"#333\" stroke-width=\".25\"/>",
                        points, colour[0], colour[1], colour[2]);
    }
    for (const assembly::FreeCable& cable : assembly::free_cables(a, pose)) {
        const Vector2d from = plan.seen(cable.from_mm), to = plan.seen(cable.to_mm);
        plan.content += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"#a02020\" stroke-width=\".8\"/>",
                                    coordinate(from.x()), coordinate(from.y()), coordinate(to.x()), coordinate(to.y()));
    }
    return plan;
}

}  // namespace

std::string assembly_plan(const Assembly& a) {
    const double turn = std::min(a.greatest_turn, a.greatest_payout_mm / a.capstan_radius_mm);
    const Plan lowest = plan_of(a, {}), highest = plan_of(a, assembly::pose_of(a, turn, turn, 0.0));
    const Vector2d shift(lowest.high.x() - highest.low.x() + 20.0, 0.0);
    return svg(lowest.low.cwiseMin(highest.low + shift), lowest.high.cwiseMax(highest.high + shift),
               fmt::format("{}<g transform=\"translate({} 0)\">{}</g>", lowest.content, coordinate(shift.x()), highest.content));
}

std::string assembly_motion(const Assembly& a, int longest_px) {
    constexpr int kFrames = 24, kFrame_ms = 125;  // three seconds a cycle
    const std::vector<solid::Mesh> meshes = meshes_of(a);
    std::vector<std::vector<drawing::Object>> scenes;
    for (int k = 0; k < kFrames; ++k) scenes.push_back(scene_of(a, meshes, cycle_pose(a, static_cast<double>(k) / kFrames), false));
    return drawing::animated_png(drawing::draw_frames(scenes, eye(), longest_px), kFrame_ms);
}

std::string assembly_view(const Assembly& a, const Pose& pose, int longest_px) { return shaded(a, meshes_of(a), pose, false, longest_px); }
std::string assembly_exploded(const Assembly& a, int longest_px) { return shaded(a, meshes_of(a), {}, true, longest_px); }

std::array<std::string, 2> assembly_pictures(const Assembly& a) {
    const std::vector<solid::Mesh> meshes = meshes_of(a);
    const auto exploded = [&] { return shaded(a, meshes, {}, true, kPicture_px); };
    auto beside = std::async(std::launch::async | std::launch::deferred, exploded);
    std::string view = shaded(a, meshes, {}, false, kPicture_px);
    return {std::move(view), beside.get()};
}

}  // namespace fusee::report
