#include "fusee/inspect/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "division.h"
#include "fusee/core/parallel.h"
#include "fusee/core/progress.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

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
