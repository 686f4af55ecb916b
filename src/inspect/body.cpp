#include "fusee/inspect/body.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "fusee/core/error.h"
#include "fusee/core/parallel.h"
#include "fusee/core/progress.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

constexpr double kParallel = core::rad_from_deg(1.0);
constexpr double kEdge = 0.1, kAngle = 0.02;  // of the first width: nearly nothing is left; the angle is measured
constexpr double kBlunt = 0.1;                // of the width there: the way that is left to the end. An edge of 157 deg has as much
constexpr double kWider = 1.02;               // facets of a curved face differ from it
constexpr int kSteps = 24;                    // each goes half of the way that is left

/// Follows the material between two faces from a ball that touches both, to where they come nearer: do they meet in an edge, or does the
/// wall end in a face or a rounding, stay parallel or become thicker again? The faces may be curved.
/// @param width_mm diameter of the ball @param one, other unit vectors from its middle to its contacts
std::optional<SharpEdge> edge_ahead(const Body& body, Vec3 middle, Vec3 one, Vec3 other, double width_mm) {
    std::optional<SharpEdge> edge;
    Vec3 ahead{};
    double way = 0.0, width = width_mm;
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 sum = one + other;
        const double half_sine = std::min(1.0, 0.5 * length(sum)), half_width = 0.5 * width;
        if (i == 0 && half_sine < 0.5 * kParallel) return std::nullopt;
        if (i == 0 || dot(sum, ahead) > 0.0) ahead = unit(sum);                    // single facets may be inclined the other way
        const double to_edge = half_width / std::max(half_sine, 0.5 * kParallel);  // if the faces were flat
        if (width <= kEdge * width_mm) edge = SharpEdge{2.0 * std::asin(half_sine), width_mm, way + to_edge};
        if (width <= kAngle * width_mm) return edge;
        const auto end = body.rays().first(middle, ahead, kNone);
        if (!end || end->distance_mm < kBlunt * width) return edge;
        const double step = 0.5 * std::min(end->distance_mm, to_edge);
        middle = middle + step * ahead, way += step;
        const Vec3 across = unit(one - other);
        const auto there = body.rays().first(middle, across, kNone), back = body.rays().first(middle, -1.0 * across, kNone);
        if (!there || !back || there->distance_mm + back->distance_mm > kWider * width) return edge;
        middle = middle + 0.5 * (there->distance_mm - back->distance_mm) * across;
        one = body.normals()[there->triangle], other = body.normals()[back->triangle];
        width = there->distance_mm + back->distance_mm;
    }
    return edge;
}

/// k-th point of the R2 sequence (M. Roberts, 2018: the plastic number's powers), folded into the triangle.
Vec3 place_in(const solid::Mesh& mesh, const solid::Triangle& t, std::size_t k) {
    constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
    double whole = 0.0;
    double u = std::modf(0.5 + kFirst * static_cast<double>(k), &whole), v = std::modf(0.5 + kSecond * static_cast<double>(k), &whole);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    const Vec3 &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]], &c = mesh.points_mm[t[2]];
    return (1.0 - u - v) * a + u * b + v * c;
}

/// About `count` points: half of them in proportion to area, half to the number of triangles, so that small facets have points too. Within
/// a triangle they follow a low-discrepancy sequence. Nothing is random.
std::vector<Sample> spread(const Body& body, std::size_t count) {
    const std::vector<double>& areas = body.areas_mm2();
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
    const auto facets = static_cast<double>(areas.size());
    std::vector<Sample> samples;
    samples.reserve(count + 1);
    double sum = 0.0;  // of the triangles' shares of the count, so far
    for (std::uint32_t t = 0; t < areas.size(); ++t) {
        if (!(areas[t] > 0.0)) continue;
        const double expected = 0.5 * static_cast<double>(count) * (areas[t] / area + 1.0 / facets);
        sum += expected;
        while (static_cast<double>(samples.size()) + 0.5 < sum) {
            Sample sample;
            sample.triangle = t;
            sample.at_mm = place_in(body.mesh(), body.mesh().triangles[t], samples.size());
            sample.share_mm2 = areas[t] / expected;
            samples.push_back(sample);
        }
    }
    return samples;
}

solid::Mesh sound(solid::Mesh mesh) {
    require_sound(mesh);
    return mesh;
}

/// Number of other components that contain the triangle's middle: surfaces left minus surfaces entered on the way out.
int held_by(const Body& body, std::uint32_t triangle) {
    const solid::Triangle& t = body.mesh().triangles[triangle];
    const auto& p = body.mesh().points_mm;
    const Vec3 middle = (1.0 / 3.0) * (p[t[0]] + p[t[1]] + p[t[2]]);
    const std::vector<std::uint32_t>& component = body.topology().component_of;
    int held = 0;
    for (const std::uint32_t hit : body.rays().all(middle, kAskew))
        if (component[hit] != component[triangle]) held += dot(body.normals()[hit], kAskew) > 0.0 ? 1 : -1;
    return held;
}

/// Is it one for certain? Each edge has one triangle, or two that run along it to and fro, and each point one fan.
bool is_manifold(const solid::Mesh& mesh, const Topology& topology) {
    const auto has_sides = [](const solid::Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; };
    return topology.crowded_edges + topology.flipped_edges + topology.pinched_points == 0 &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(), has_sides);
}

constexpr int kShrinkings = 40;                    // each at most halves the radius
constexpr double kTouches = 1e-3;                  // of the radius; a ball in a sphere is near to each of its triangles
constexpr double kOpposite = -0.8660254037844386;  // cosine of 150 degrees: a wall inside, a slot outside
constexpr double kRounding = 1e-9;  // of the coordinates: a nearer hit is the neighbouring triangle at the edge where the ray starts

constexpr std::size_t kOverlapping = 100'000;  // visits for a sample
constexpr std::size_t kOverlappingShare = 4, kComponentsShare = 16;

/// A step with which i * step % count visits every number below `count` once, spread from the start: near the golden section.
std::size_t coprime_step(std::size_t count) {
    auto step = static_cast<std::size_t>(0.6180339887 * static_cast<double>(count)) + 1;
    while (std::gcd(step, count) != 1) ++step;
    return step;
}

double farthest(const solid::Box& box) {
    double most = 0.0;
    for (const Vec3& corner : {box.low_mm, box.high_mm})
        for (const double x : corner) most = std::max(most, std::abs(x));
    return most;
}

}  // namespace

void require_sound(const solid::Mesh& mesh) {
    for (const solid::Triangle& t : mesh.triangles)
        for (const std::uint32_t point : t)
            if (point >= mesh.points_mm.size())
                throw core::InvalidInput("mesh.triangles", fmt::format("{}", point), fmt::format("below {}", mesh.points_mm.size()));
}

Body::Body(solid::Mesh mesh, std::size_t samples, unsigned jobs, std::size_t most_visits, std::optional<Topology> topology,
           const std::function<void(const std::string&)>& stage)
    : mesh_(sound(std::move(mesh))), jobs_(jobs), box_(solid::bounding_box(mesh_)), rays_({}) {
    const auto side_by_side = [jobs](const auto& first, const auto& second) {
        core::parallel_for(2, jobs, [&](std::size_t i) { i == 0 ? first() : second(); });
    };
    const auto say = [&stage](const char* name) {
        if (core::interrupted()) throw core::Stopped();
        if (stage) stage(name);
    };
    say("tree of boxes");
    side_by_side([&] { topology_ = topology ? std::move(*topology) : topology_of(mesh_); }, [this] { rays_ = Rays(mesh_, jobs_); });
    if (rays_.empty())
        throw core::InvalidInput("mesh.triangles", fmt::format("{} without area", mesh_.triangles.size()), "at least one with an area");
    measure_facets();
    place_components(most_visits);
    say("walls and slots");
    samples_ = spread(*this, samples);
    measure_samples(most_visits);
    say("holes and crossing triangles");
    side_by_side(
        [this] { hollows_ = find_hollows(*this); },
        [this] { crossings_ = solid::crossings(mesh_, flat_triangles(mesh_), solid::kMostNearPairs, is_manifold(mesh_, topology_)); });
}

/// Measures in batches. The remaining budget and the mean cost so far bound the samples of a batch, so that nothing depends on threads.
void Body::measure_samples(std::size_t most_visits) {
    const std::size_t count = samples_.size(), step = coprime_step(count);
    std::vector<bool> measured(count, false);
    std::size_t looks = 0, done = 0;
    for (std::size_t batch = 1, most = most_visits; done < count && looks < most;) {
        const std::size_t now = std::min(batch, count - done);
        std::vector<std::size_t> cost(now);
        core::parallel_for(now, jobs_, [&](std::size_t i) {
            if (core::interrupted()) throw core::Stopped();
            const std::size_t before = Rays::visited();
            measure_sample(samples_[(done + i) * step % count]);
            cost[i] = Rays::visited() - before;
        });
        for (std::size_t i = 0; i < now; ++i) measured[(done + i) * step % count] = true;
        looks = std::accumulate(cost.begin(), cost.end(), looks);
        done += now;
        most = looks / done > kOverlapping ? most_visits / kOverlappingShare : most_visits;
        const std::size_t paid_for = (most - std::min(looks, most)) / (looks / done + 1);
        batch = std::clamp<std::size_t>(paid_for, 1, 2 * batch);
    }
    if (done < count) keep_measured(measured);
}

void Body::keep_measured(const std::vector<bool>& measured) {
    std::vector<Sample> kept;
    for (std::size_t i = 0; i < samples_.size(); ++i)
        if (measured[i]) kept.push_back(samples_[i]);
    samples_left_out_ = samples_.size() - kept.size();
    for (Sample& s : kept) s.share_mm2 *= static_cast<double>(samples_.size()) / static_cast<double>(kept.size());
    samples_ = std::move(kept);
}

void Body::measure_sample(Sample& s) const {
    const Vec3 outward = normals_[s.triangle];
    if (const auto outside = ball_at(*this, s.triangle, s.at_mm, outward, kOpposite)) s.gap_mm = outside->opposite_mm;
    const auto inside = ball_at(*this, s.triangle, s.at_mm, -1.0 * outward, kOpposite);
    if (!inside) return;
    s.ball_mm = inside->touching_mm, s.middle_mm = inside->middle_mm;
    if (std::isnan(inside->opposite_mm)) return;
    s.edge = edge_ahead(*this, inside->middle_mm, outward, inside->opposite, inside->opposite_mm);
    if (!s.edge) s.wall_mm = inside->opposite_mm;
}

void Body::measure_facets() {
    const std::vector<std::uint32_t> flat = flat_triangles(mesh_);
    normals_.reserve(mesh_.triangles.size());
    areas_.reserve(mesh_.triangles.size());
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
        const solid::Triangle& t = mesh_.triangles[i];
        const auto& p = mesh_.points_mm;
        const bool none = std::binary_search(flat.begin(), flat.end(), i);
        const Vec3 twice = none ? Vec3{} : cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
        areas_.push_back(0.5 * length(twice));
        normals_.push_back(unit(twice));
    }
}

void Body::place_components(std::size_t most_visits) {
    const std::vector<Component>& all = topology_.components;
    const std::size_t before = Rays::visited();
    cavity_.assign(all.size(), false), turned_.assign(all.size(), false);
    for (std::size_t c = 0; c < all.size(); ++c) {
        if (!all[c].closed || !(all[c].volume_mm3 < 0.0)) continue;
        if (Rays::visited() - before > most_visits / kComponentsShare) {
            ++components_left_out_;
            continue;
        }
        cavity_[c] = held_by(*this, all[c].largest) > 0;
        turned_[c] = !cavity_[c];
    }
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        if (!turned_[topology_.component_of[t]]) continue;
        std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
        std::swap(topology_.neighbour[t][0], topology_.neighbour[t][2]);
        normals_[t] = -1.0 * normals_[t];
    }
}

std::optional<Ball> ball_at(const Body& body, std::uint32_t triangle, const Vec3& at, const Vec3& side, double least_apart) {
    const double least = kRounding * farthest(body.box());
    const auto hit = body.rays().first(at, side, triangle);
    if (!hit || !(hit->distance_mm > least)) return std::nullopt;
    double radius = 0.5 * hit->distance_mm, apart = 1.0;  // cosine between the two contacts, seen from the ball's middle
    Vec3 second = side, chord{};
    for (int i = 0; i < kShrinkings; ++i) {
        const auto inside = body.rays().nearest(at + radius * side, radius * (1.0 - kTouches));
        if (!inside) break;
        chord = inside->first - at;
        const double ahead = dot(chord, side);
        if (!(ahead > 0.0) || !(length(chord) > least)) return std::nullopt;  // by rounding the point itself, or its neighbour, is nearest
        radius = dot(chord, chord) / (2.0 * ahead);
        const Vec3 to_second = inside->first - (at + radius * side);
        apart = -dot(side, to_second) / radius;
        second = unit(to_second);
    }
    Ball ball;
    ball.touching_mm = 2.0 * radius;
    if (apart <= least_apart) return Ball{2.0 * radius, length(chord), at + radius * side, second};
    if (dot(body.normals()[hit->triangle], body.normals()[triangle]) > least_apart) return ball;
    // Only an edge is nearer. The width is that from face to face, across the middle between both.
    const Vec3& facing = body.normals()[hit->triangle];
    second = (dot(facing, side) > 0.0 ? 1.0 : -1.0) * facing;
    const Vec3 across = unit(side + second);
    const auto there = body.rays().first(at, across, triangle);
    if (!there || !(there->distance_mm > least) || dot(body.normals()[there->triangle], body.normals()[triangle]) > least_apart)
        return ball;
    return Ball{2.0 * radius, there->distance_mm, at + 0.5 * there->distance_mm * across, second};
}

}  // namespace fusee::inspect
