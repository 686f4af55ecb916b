#include "fusee/inspect/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <span>

#include "fusee/core/disjoint_sets.h"
#include "fusee/core/lists.h"
#include "fusee/core/parallel.h"
#include "fusee/core/progress.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

/// The triangles of one body: ascending.
struct Part {
    std::size_t item = 0;
    bool closed = true;
    std::vector<std::uint32_t> triangles;
};

/// A triangle at an edge of more than two.
struct Leaf {
    std::uint32_t low, high, triangle;
    bool up;  ///< it runs from low to high
    double angle = 0.0;
};

std::vector<Leaf> leaves(const solid::Mesh& mesh, const Topology& topology) {
    std::vector<Leaf> all;
    for (const std::uint32_t t : topology.crowded)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            if (a != b && topology.neighbour[t][k] == kNone) all.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    std::sort(all.begin(), all.end(), [](const Leaf& a, const Leaf& b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    return all;
}

constexpr double kSameAngle = 1e-6;  // [rad]: of two faces that lie on each other

/// Joins the triangles of one edge that have material between them: about the edge, upward, material begins behind a triangle that runs
/// down and ends at one that runs up. Where faces lie on each other, one body ends before the next one begins.
/// @returns false if there are not as many beginnings as ends
bool join_about(const solid::Mesh& mesh, std::span<Leaf> edge, core::DisjointSets& sets) {
    const Vec3 &low = mesh.points_mm[edge.front().low], &high = mesh.points_mm[edge.front().high];
    const Frame frame = frame_about(unit(high - low));
    for (Leaf& leaf : edge) {
        const solid::Triangle& t = mesh.triangles[leaf.triangle];
        const std::uint32_t third = t[0] != leaf.low && t[0] != leaf.high ? t[0] : t[1] != leaf.low && t[1] != leaf.high ? t[1] : t[2];
        const Vec3 away = mesh.points_mm[third] - low;
        leaf.angle = std::atan2(dot(away, frame.v), dot(away, frame.u));
    }
    std::stable_sort(edge.begin(), edge.end(), [](const Leaf& a, const Leaf& b) { return a.angle < b.angle; });
    for (std::size_t i = 0, j = 0; i < edge.size(); i = j) {
        for (j = i + 1; j < edge.size() && edge[j].angle - edge[j - 1].angle < kSameAngle; ++j) {
        }
        std::stable_partition(edge.begin() + static_cast<std::ptrdiff_t>(i), edge.begin() + static_cast<std::ptrdiff_t>(j),
                              [](const Leaf& leaf) { return leaf.up; });
    }
    std::deque<std::uint32_t> begun;
    std::size_t joined = 0;
    for (std::size_t i = 0; i < 2 * edge.size(); ++i) {
        const Leaf& leaf = edge[i % edge.size()];
        if (!leaf.up && i < edge.size()) begun.push_back(leaf.triangle);
        if (!leaf.up || begun.empty()) continue;
        sets.join(begun.front(), leaf.triangle);
        begun.pop_front(), ++joined;
    }
    return 2 * joined == edge.size();
}

/// Connected surfaces, by their first triangle.
struct Surface {
    std::vector<std::uint32_t> triangles;
    bool closed = true;
    double volume_mm3 = 0.0, largest_mm2 = -1.0;
    std::uint32_t largest = kNone;
    std::size_t item = 0;
};

std::vector<Surface> surfaces_of(const solid::Mesh& mesh, const Topology& topology, std::span<const Item> items,
                                 std::vector<std::uint32_t>& number) {
    core::DisjointSets sets(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t n : topology.neighbour[t])
            if (n != kNone) sets.join(t, n);
    std::vector<bool> open(mesh.triangles.size(), false);
    for (const std::uint32_t t : topology.open) open[t] = true;
    std::vector<Leaf> all = leaves(mesh, topology);
    for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
        for (j = i; j < all.size() && all[j].low == all[i].low && all[j].high == all[i].high; ++j) {
        }
        if (j - i > 2 && !join_about(mesh, {all.data() + i, j - i}, sets))
            for (std::size_t k = i; k < j; ++k) open[all[k].triangle] = true;
    }
    std::vector<Surface> surfaces;
    number.assign(mesh.triangles.size(), kNone);
    std::size_t item = 0, end = items.front().triangles;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        while (t >= end && item + 1 < items.size()) end += items[++item].triangles;
        const std::uint32_t root = sets.find(t);
        if (number[root] == kNone) number[root] = static_cast<std::uint32_t>(surfaces.size()), surfaces.emplace_back().item = item;
        number[t] = number[root];
        Surface& surface = surfaces[number[t]];
        const solid::Triangle& c = mesh.triangles[t];
        const Vec3 &p = mesh.points_mm[c[0]], &q = mesh.points_mm[c[1]], &r = mesh.points_mm[c[2]];
        surface.triangles.push_back(t);
        surface.volume_mm3 += dot(p, cross(q, r)) / 6.0;
        if (const double area = length(cross(q - p, r - p)); area > surface.largest_mm2) surface.largest_mm2 = area, surface.largest = t;
        if (open[t]) surface.closed = false;
    }
    return surfaces;
}

constexpr std::size_t kMostLooks = kMostVisits / 16;

/// For each surface that faces inward the smallest body of its item that contains it, else kNone.
std::vector<std::uint32_t> containers(const solid::Mesh& mesh, const std::vector<Surface>& surfaces,
                                      const std::vector<std::uint32_t>& number, unsigned jobs) {
    std::vector<std::uint32_t> in(surfaces.size(), kNone);
    const auto inward = [](const Surface& s) { return s.closed && s.volume_mm3 < 0.0; };
    if (surfaces.size() < 2 || std::none_of(surfaces.begin(), surfaces.end(), inward)) return in;
    const Rays rays(mesh, jobs);
    const std::size_t before = Rays::visited();
    for (std::size_t s = 0; s < surfaces.size() && Rays::visited() - before < kMostLooks; ++s) {
        if (!inward(surfaces[s])) continue;
        const auto corner = [&](std::uint32_t t, std::size_t k) -> const Vec3& { return mesh.points_mm[mesh.triangles[t][k]]; };
        const std::uint32_t largest = surfaces[s].largest;
        const Vec3 from = (1.0 / 3.0) * (corner(largest, 0) + corner(largest, 1) + corner(largest, 2));
        std::map<std::uint32_t, int> around;
        for (const std::uint32_t t : rays.all(from, kAskew))
            around[number[t]] += dot(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)), kAskew) > 0.0 ? 1 : -1;
        for (const auto& [other, net] : around)
            if (net > 0 && other != s && surfaces[other].closed && surfaces[other].volume_mm3 > 0.0 &&
                surfaces[other].item == surfaces[s].item && (in[s] == kNone || surfaces[other].volume_mm3 < surfaces[in[s]].volume_mm3))
                in[s] = other;
    }
    return in;
}

/// Divides a file into its bodies. At an edge of more than two triangles those belong together that have material between them, so that
/// two bodies that touch are two. A closed surface that faces inward is a cavity of the smallest body that contains it.
/// O(triangles log triangles), and a ray for each cavity.
std::vector<Part> divide(const solid::Mesh& mesh, const Topology& topology, std::span<const Item> items, unsigned jobs) {
    std::vector<std::uint32_t> number;
    std::vector<Surface> surfaces = surfaces_of(mesh, topology, items, number);
    const std::vector<std::uint32_t> in = containers(mesh, surfaces, number, jobs);
    std::vector<std::uint32_t> part_of(surfaces.size(), kNone);
    std::vector<Part> parts;
    std::map<std::size_t, std::uint32_t> open_part;  // by item
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        if (in[s] != kNone) continue;
        part_of[s] = static_cast<std::uint32_t>(parts.size());
        if (!surfaces[s].closed) part_of[s] = open_part.try_emplace(surfaces[s].item, part_of[s]).first->second;
        if (part_of[s] == parts.size()) parts.push_back({surfaces[s].item, surfaces[s].closed, {}});
    }
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        std::vector<std::uint32_t>& to = parts[part_of[in[s] == kNone ? s : in[s]]].triangles;
        to.insert(to.end(), surfaces[s].triangles.begin(), surfaces[s].triangles.end());
        surfaces[s].triangles = {};
    }
    for (Part& part : parts) std::sort(part.triangles.begin(), part.triangles.end());
    return parts;
}

/// These triangles with their own points. @param points of the result: their numbers in `mesh`
solid::Mesh taken(const solid::Mesh& mesh, std::span<const std::uint32_t> triangles, std::vector<std::uint32_t>& points) {
    for (const std::uint32_t t : triangles) points.insert(points.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    points = core::sorted_unique(std::move(points));
    solid::Mesh own;
    own.triangles.reserve(triangles.size());
    for (const std::uint32_t p : points) own.points_mm.push_back(mesh.points_mm[p]);
    const auto place = [&points](std::uint32_t p) {
        return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
    };
    for (const std::uint32_t t : triangles) {
        const solid::Triangle& c = mesh.triangles[t];
        own.triangles.push_back({place(c[0]), place(c[1]), place(c[2])});
    }
    return own;
}

constexpr std::size_t kLeastSamples = 200;
constexpr std::size_t kLeastShares = 5;  // a body has at most a fifth of all samples
constexpr double kDeep_mm = 0.01;        // a place of the surface this far inside another body: they overlap
constexpr double kScar_mm2 = 0.01;

/// "k_se", "item 2"; a name that two items have gets the number of its item.
std::vector<std::string> names_of(const std::vector<Item>& items) {
    std::map<std::string, std::size_t> count;
    for (const Item& item : items) ++count[item.name];
    std::vector<std::string> names;
    for (std::size_t i = 0; i < items.size(); ++i)
        names.push_back(items[i].name.empty()      ? fmt::format("item {}", i + 1)
                        : count[items[i].name] > 1 ? fmt::format("{} (item {})", items[i].name, i + 1)
                                                   : items[i].name);
    return names;
}

/// "" for the only body of the only item.
std::vector<std::string> names_of(const std::vector<Part>& parts, const std::vector<Item>& items) {
    const std::vector<std::string> of_items = names_of(items);
    std::vector<std::size_t> bodies(items.size(), 0), so_far(items.size(), 0);
    for (const Part& part : parts) ++bodies[part.item];
    std::vector<std::string> names;
    for (const Part& part : parts) {
        std::string name = items.size() > 1 ? of_items[part.item] : "";
        if (bodies[part.item] > 1) name += fmt::format("{}body {}", name.empty() ? "" : " ", ++so_far[part.item]);
        names.push_back(name);
    }
    return names;
}

bool meet(const solid::Box& a, const solid::Box& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.low_mm[i] > b.high_mm[i] || b.low_mm[i] > a.high_mm[i]) return false;
    return true;
}

/// More surfaces left than entered on the way out of the body, in two directions: a ray through an edge meets both of its triangles.
bool holds(const Body& body, const Vec3& at) {
    for (const Vec3& way : {kAskew, unit({-0.4142135624, 0.7390851332, 0.5671432904})}) {
        int net = 0;
        for (const std::uint32_t t : body.rays().all(at, way)) net += dot(body.normals()[t], way) > 0.0 ? 1 : -1;
        if (net <= 0) return false;
    }
    return true;
}

/// Surface of `a` that lies inside `b`, and a place of it.
std::pair<double, Vec3> inside(const Body& a, const Body& b, unsigned jobs) {
    std::vector<char> in(a.samples().size(), 0);
    core::parallel_for(in.size(), jobs, [&](std::size_t i) {
        const Sample& s = a.samples()[i];
        const Vec3 at = s.at_mm - kDeep_mm * a.normals()[s.triangle];
        if (meet({at, at}, b.box())) in[i] = holds(b, at) ? 1 : 0;
    });
    std::pair<double, Vec3> found{0.0, {}};
    for (std::size_t i = 0; i < in.size(); ++i) {
        if (in[i] == 0) continue;
        if (found.first == 0.0) found.second = a.samples()[i].at_mm;
        found.first += a.samples()[i].share_mm2;
    }
    return found;
}

/// A place where surfaces of the two intersect or lie on each other.
std::optional<Vec3> crossing(const solid::Mesh& a, const solid::Mesh& b) {
    solid::Mesh both = a;
    const auto points = static_cast<std::uint32_t>(a.points_mm.size()), first = static_cast<std::uint32_t>(a.triangles.size());
    both.points_mm.insert(both.points_mm.end(), b.points_mm.begin(), b.points_mm.end());
    for (const solid::Triangle& t : b.triangles) both.triangles.push_back({points + t[0], points + t[1], points + t[2]});
    const solid::Crossings found = solid::crossings(both, flat_triangles(both));
    for (const auto& [f, g] : found.pairs)
        if (f < first && g >= first) return both.points_mm[both.triangles[f][0]];
    return std::nullopt;
}

}  // namespace

File::File(solid::Mesh mesh, std::vector<Item> items, std::size_t samples, unsigned jobs,
           const std::function<void(const std::string&)>& progress)
    : items_(std::move(items)), box_(solid::bounding_box(mesh)), triangles_(mesh.triangles.size()) {
    if (items_.empty()) items_.push_back({"", mesh.triangles.size()});
    const auto say = [&progress](const std::string& stage) {
        if (core::interrupted()) throw core::Stopped();
        if (progress) progress(stage);
    };
    say("edges and bodies");
    require_sound(mesh);
    Topology topology = topology_of(mesh);
    std::vector<Part> parts = divide(mesh, topology, items_, jobs);
    const std::vector<std::string> names = names_of(parts, items_);
    const std::size_t each = std::max(samples / std::max(kLeastShares, parts.size()), kLeastSamples);
    if (parts.size() == 1) {
        pieces_.push_back({names.front(), 0, Body(std::move(mesh), each, jobs, kMostVisits, std::move(topology), say), {}});
        pieces_.front().triangles.resize(triangles_);
        std::iota(pieces_.front().triangles.begin(), pieces_.front().triangles.end(), 0U);
        return;
    }
    std::vector<std::vector<std::uint32_t>> corners(parts.size());
    pieces_.reserve(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto of_body = [&](const std::string& stage) { say(fmt::format("{}: {}", names[i], stage)); };
        solid::Mesh own = taken(mesh, parts[i].triangles, corners[i]);
        Topology of_own = topology_of(own);
        pieces_.push_back({names[i], parts[i].item,
                           Body(std::move(own), each, jobs, kMostVisits / parts.size(), std::move(of_own), of_body),
                           std::move(parts[i].triangles)});
    }
    say("where bodies meet");
    find_contacts(corners, jobs);
}

void File::find_contacts(const std::vector<std::vector<std::uint32_t>>& corners, unsigned jobs) {
    std::map<std::uint32_t, std::size_t> owner;  // of a corner of the file: the first body
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::uint32_t>> shared;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::uint32_t k = 0; k < corners[i].size(); ++k)
            if (const auto [at, fresh] = owner.try_emplace(corners[i][k], i); !fresh) {
                auto& [count, place] = shared[{at->second, i}];
                if (count++ == 0) place = k;
            }
    std::vector<std::size_t> order(pieces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto low_x = [this](std::size_t i) { return pieces_[i].body.box().low_mm[0]; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return low_x(i) < low_x(k); });
    for (std::size_t m = 0; m < order.size(); ++m)
        for (std::size_t n = m + 1; n < order.size() && low_x(order[n]) <= pieces_[order[m]].body.box().high_mm[0]; ++n) {
            const auto [a, b] = std::minmax(order[m], order[n]);
            const Body &one = pieces_[a].body, &other = pieces_[b].body;
            if (!meet(one.box(), other.box())) continue;
            if (core::interrupted()) throw core::Stopped();
            const auto first = inside(one, other, jobs), second = inside(other, one, jobs);
            const auto& [area, at] = first.first > second.first ? first : second;
            if (area > kScar_mm2)
                contacts_.push_back({a, b, Contact::Kind::kOverlap, 0, area, at});
            else if (const auto same = shared.find({a, b}); same != shared.end())
                contacts_.push_back({a, b, Contact::Kind::kShare, same->second.first, 0.0, other.mesh().points_mm[same->second.second]});
            else if (const auto place = crossing(one.mesh(), other.mesh()))
                contacts_.push_back({a, b, Contact::Kind::kTouch, 0, 0.0, *place});
        }
    std::sort(contacts_.begin(), contacts_.end(),
              [](const Contact& x, const Contact& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
}

}  // namespace fusee::inspect
