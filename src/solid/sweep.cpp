#include "fusee/solid/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "columns.h"
#include "fusee/core/units.h"

namespace fusee::solid {

namespace {

constexpr double kTurn = 2.0 * core::kPi;

/// Vertex numbers of one column.
struct Column {
    std::vector<std::uint32_t> lower, upper;
    std::vector<std::vector<std::uint32_t>> slots;

    [[nodiscard]] std::vector<std::uint32_t> rails() const {
        std::vector<std::uint32_t> all = lower;
        for (const auto& slot : slots) all.insert(all.end(), slot.begin(), slot.end());
        all.insert(all.end(), upper.begin(), upper.end());
        return all;
    }
};

std::vector<std::uint32_t> add_points(Mesh& mesh, const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> numbers;
    for (const Vec3& p : points) {
        numbers.push_back(static_cast<std::uint32_t>(mesh.points_mm.size()));
        mesh.points_mm.push_back(p);
    }
    return numbers;
}

Column add_column(Mesh& mesh, const ColumnPoints& points) {
    Column column{add_points(mesh, points.lower), add_points(mesh, points.upper), {}};
    for (const auto& slot : points.slots) column.slots.push_back(add_points(mesh, slot));
    return column;
}

/// Two triangles for each pair of rails; outward because t x z = n.
void add_strip(Mesh& mesh, const std::vector<std::uint32_t>& left, const std::vector<std::uint32_t>& right) {
    for (std::size_t k = 0; k + 1 < left.size(); ++k) {
        mesh.triangles.push_back({left[k], right[k], right[k + 1]});
        mesh.triangles.push_back({left[k], right[k + 1], left[k + 1]});
    }
}

/// The wall where a turn's groove begins (material before it) or ends (material after it): below, section bottom to top, above.
void add_wall(Mesh& mesh, std::uint32_t below, const std::vector<std::uint32_t>& slot, std::uint32_t above, bool begins) {
    std::vector<Triangle> wall{{below, slot.front(), slot.back()}, {below, slot.back(), above}};
    for (std::size_t k = 1; k + 1 < slot.size(); ++k) wall.push_back({slot.front(), slot[k], slot[k + 1]});
    for (Triangle& t : wall)
        if (!begins) std::swap(t[1], t[2]);
    mesh.triangles.insert(mesh.triangles.end(), wall.begin(), wall.end());
}

/// Closes the seam of a helix: past the last column comes the first one, without the turn that begins there.
Column without_first_slot(const Column& column) {
    Column rest = column;
    rest.slots.erase(rest.slots.begin());
    return rest;
}

}  // namespace

SweptBody sweep(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges, double tolerance_mm) {
    const ColumnMaker maker(cam, section, flanges);
    const double low = cam.groove_psi.low;
    const int most_turns = maker.turns_at(low);
    // Where the topmost turn ends; a planar groove ends nowhere.
    const double end = cam.closed() ? low + kTurn : cam.groove_psi.high - kTurn * (most_turns - 1);
    SweptBody body;
    body.z_low_mm = maker.z_low_mm();
    body.z_high_mm = maker.z_high_mm();
    body.lower_lip_mm = body.z_low_mm + flanges.rib_mm;

    std::vector<Column> columns;
    for (const double u : place_columns(maker, low, end, tolerance_mm)) {
        if (cam.closed() && u >= end) break;  // the first column again
        columns.push_back(add_column(body.mesh, maker.at(u, cam.closed() ? 1 : most_turns)));
        body.columns_psi.push_back(u);
        if (columns.size() > 1) add_strip(body.mesh, columns[columns.size() - 2].rails(), columns.back().rails());
    }
    if (cam.closed()) {
        add_strip(body.mesh, columns.back().rails(), columns.front().rails());
    } else {
        Column last = columns.back();
        const std::vector<std::uint32_t> ended = last.slots.back();
        last.slots.pop_back();
        add_wall(body.mesh, last.slots.empty() ? last.lower.back() : last.slots.back().back(), ended, last.upper.front(), false);
        for (const double u : place_columns(maker, end, low + kTurn, tolerance_mm)) {
            if (u <= end || u >= low + kTurn) continue;
            columns.push_back(add_column(body.mesh, maker.at(u, most_turns - 1)));
            body.columns_psi.push_back(u);
            add_strip(body.mesh, last.rails(), columns.back().rails());
            last = columns.back();
        }
        const Column seam = without_first_slot(columns.front());
        add_strip(body.mesh, last.rails(), seam.rails());
        add_wall(body.mesh, seam.lower.back(), columns.front().slots.front(), seam.slots.empty() ? seam.upper.front() : seam.slots.front().front(), true);
    }
    for (const Column& c : columns) {
        body.lower_ring.push_back(c.lower.front());
        body.upper_ring.push_back(c.upper.back());
    }
    return body;
}

double least_turn_gap_mm(const cam::Cam& cam, const std::vector<SectionPoint>& section) {
    double least = std::numeric_limits<double>::infinity();
    if (cam.closed()) return least;
    for (double psi = cam.groove_psi.low; psi + kTurn <= cam.groove_psi.high; psi += 0.01)
        least = std::min(least, core::mm_from_m(cam.path(psi + kTurn).z - cam.path(psi).z) - (section.back().z_mm - section.front().z_mm));
    return least;
}

}  // namespace fusee::solid
