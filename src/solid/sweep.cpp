#include "fusee/solid/sweep.h"

#include <algorithm>
#include <limits>

#include "fusee/core/units.h"

namespace fusee::solid {

namespace {

using core::kTurn;
using Numbers = std::vector<std::uint32_t>;

/// Vertex numbers of one column; slots by turn.
struct Column {
    Numbers lower, upper;
    std::vector<Numbers> slots;

    [[nodiscard]] Numbers rails() const {
        Numbers all = lower;
        for (const Numbers& slot : slots) all.insert(all.end(), slot.begin(), slot.end());
        all.insert(all.end(), upper.begin(), upper.end());
        return all;
    }
    [[nodiscard]] const Numbers* slot(std::size_t turn) const { return turn < slots.size() ? &slots[turn] : nullptr; }
};

std::uint32_t add_point(Mesh& mesh, const Vec3& p) {
    mesh.points_mm.push_back(p);
    return static_cast<std::uint32_t>(mesh.points_mm.size() - 1);
}

Numbers add_points(Mesh& mesh, const std::vector<Vec3>& points) {
    Numbers numbers;
    for (const Vec3& p : points) numbers.push_back(add_point(mesh, p));
    return numbers;
}

void add_triangle(Mesh& mesh, const Triangle& t) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);  // merged rails have no area between them
}

/// Two triangles for each pair of rails. They face outward because t x z = n.
void add_strip(Mesh& mesh, const Numbers& left, const Numbers& right) {
    for (std::size_t k = 0; k + 1 < left.size(); ++k) {
        add_triangle(mesh, {left[k], right[k], right[k + 1]});
        add_triangle(mesh, {left[k], right[k + 1], left[k + 1]});
    }
}

/// The flat end of a groove: its section, which is convex and in one plane. @param begins true: the groove lies on the side of rising psi
void add_wall(Mesh& mesh, const Numbers& slot, bool begins) {
    for (std::size_t k = 1; k + 1 < slot.size(); ++k)
        add_triangle(mesh, begins ? Triangle{slot.front(), slot[k], slot[k + 1]} : Triangle{slot.front(), slot[k + 1], slot[k]});
}

/// Builds columns. Where two spans meet, both have a column at the same direction and share its common points.
class Builder {
public:
    Builder(const ColumnMaker& maker, Mesh& mesh) : maker_(maker), mesh_(mesh) {}

    Column column(double u, const AngularSpan& span, const Column* twin) {
        Column c;
        c.lower = twin ? twin->lower : add_points(mesh_, maker_.lower_rails(u));
        c.upper = twin ? twin->upper : add_points(mesh_, maker_.upper_rails(u));
        for (std::size_t turn = 0; turn < span.cut.size(); ++turn) {
            const Numbers* shared = twin ? twin->slot(turn) : nullptr;
            const double psi = u + kTurn * static_cast<double>(turn);
            c.slots.push_back(span.cut[turn] ? cut_slot(psi, shared) : lips(psi, shared, c));
        }
        return c;
    }

private:
    Numbers cut_slot(double psi, const Numbers* shared) {
        const std::vector<Vec3> points = maker_.section_at(psi);
        if (shared && shared->size() == points.size()) return *shared;
        if (!shared) return add_points(mesh_, points);
        Numbers slot = add_points(mesh_, {points.begin() + 1, points.end() - 1});
        slot.insert(slot.begin(), shared->front());
        slot.push_back(shared->back());
        return slot;
    }

    Numbers lips(double psi, const Numbers* shared, const Column& column) {
        if (shared) return {shared->front(), shared->back()};
        const ColumnMaker::Lips points = maker_.run_out(psi);
        if (points.merged) {
            const std::uint32_t edge =
                points.lower[2] < 0.5 * (maker_.z_low_mm() + maker_.z_high_mm()) ? column.lower.back() : column.upper.front();
            return {edge, edge};
        }
        return {add_point(mesh_, points.lower), add_point(mesh_, points.upper)};
    }

    const ColumnMaker& maker_;
    Mesh& mesh_;
};

void add_walls(Mesh& mesh, const Column& before, const Column& after) {
    for (std::size_t turn = 0; before.slot(turn); ++turn) {
        const Numbers *left = before.slot(turn), *right = after.slot(turn);
        if (!right || left->size() == right->size()) continue;
        add_wall(mesh, left->size() < right->size() ? *right : *left, left->size() < right->size());
    }
}

/// The first column as the last one meets it one turn later: its turn 1 is turn 0 there, and a groove that only begins there has no rails
/// yet.
Column one_turn_later(const Column& first, bool closed) {
    Column seam = first;
    if (closed) return seam;
    seam.slots.erase(seam.slots.begin());
    return seam;
}

}  // namespace

SweptBody sweep(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges, double tolerance_mm) {
    const ColumnMaker maker(cam, section, flanges);
    SweptBody body;
    body.z_low_mm = maker.z_low_mm();
    body.z_high_mm = maker.z_high_mm();
    body.lower_lip_mm = body.z_low_mm + flanges.rib_mm;

    Builder builder(maker, body.mesh);
    const std::vector<AngularSpan> spans = maker.spans();
    const double end = spans.back().high;
    Column first, last;
    for (const AngularSpan& span : spans) {
        for (const double u : place_columns(maker, span.low, span.high, tolerance_mm)) {
            if (u == end) break;  // the first column again
            const bool begins = u == span.low && !body.columns_psi.empty();
            Column column = builder.column(u, span, begins ? &last : nullptr);
            if (begins) {
                add_walls(body.mesh, last, column);
            } else {
                if (body.columns_psi.empty()) first = column;
                if (!body.columns_psi.empty()) add_strip(body.mesh, last.rails(), column.rails());
                body.columns_psi.push_back(u);
                body.lower_ring.push_back(column.lower.front());
                body.upper_ring.push_back(column.upper.back());
            }
            last = std::move(column);
        }
    }
    add_strip(body.mesh, last.rails(), one_turn_later(first, cam.closed()).rails());
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
