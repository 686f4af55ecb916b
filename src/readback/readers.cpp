#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "compare.h"
#include "floor.h"
#include "fusee/core/error.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/readback/readback.h"
#include "fusee/toolpath/read_back.h"

namespace fusee::readback {

namespace {

/// The body as made from a file with `mesh`: for a compensated file, every coordinate times 1 - shrinkage.
solid::Mesh as_made(solid::Mesh mesh, const exchange::PartFile& part) {
    if (!part.compensated) return mesh;
    for (auto& point : mesh.points_mm)
        for (std::size_t axis = 0; axis < 3; ++axis) point[axis] *= 1.0 - part.compensated->shrink_percent[axis] / 100.0;
    return mesh;
}

constexpr double kHalfWindow = 0.1;  // [rad] to each side, for the mean slope
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A point of the rim with the distance of the roller's centre (a print's beads have a half width).
struct RimPoint {
    Point xy_mm{};
    double azimuth = 0.0, reach_mm = 0.0;
};
using Rim = std::vector<RimPoint>;

/// The rim's points in order around the axis.
Rim rim_of(const Floor& floor, double radius_mm) {
    Rim rim;
    for (std::size_t i = 0; i < floor.points.size(); ++i) {
        const Point& p = floor.points[i].xy_mm;
        rim.push_back({p, std::atan2(p[1], p[0]), radius_mm + (floor.reach_mm.empty() ? 0.0 : floor.reach_mm[i])});
    }
    std::sort(rim.begin(), rim.end(), [](const RimPoint& a, const RimPoint& b) { return a.azimuth < b.azimuth; });
    const auto same = [](const RimPoint& a, const RimPoint& b) { return b.azimuth - a.azimuth < 1e-9; };
    rim.erase(std::unique(rim.begin(), rim.end(), same), rim.end());
    return rim;
}

/// Top of the parabola through three points, whose middle one is the highest.
double top(const std::array<double, 3>& x, const std::array<double, 3>& y) {
    const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]), curvature = (right - left) / (x[2] - x[0]);
    if (!(curvature < 0.0)) return y[1];
    const double slope = left + curvature * (x[1] - x[0]);  // at the middle point
    return y[1] - slope * slope / (4.0 * curvature);
}

constexpr double kNowhere = -std::numeric_limits<double>::infinity();

/// The roller's place against one point of the rim, as its path counts it.
using Place = std::function<double(const RimPoint&)>;

/// Its centre along the line of its slide [mm].
Place on_slide(const exchange::PartFile& part, double back) {
    return [along = turned(part.guide.direction, back), offset = part.guide.offset_mm, sign = part.torque_sign](const RimPoint& p) {
        const double beside = sign * (p.xy_mm[1] * along[0] - p.xy_mm[0] * along[1]) - offset;
        const double square = p.reach_mm * p.reach_mm - beside * beside;
        return square < 0.0 ? kNowhere : p.xy_mm[0] * along[0] + p.xy_mm[1] * along[1] + std::sqrt(square);
    };
}

/// The turn of its arm since cam angle 0 [rad], by the triangle of pivot, point and roller centre.
Place on_arm(const exchange::PartFile& part, double back) {
    const exchange::PartGuide& guide = part.guide;
    return [pivot = turned(guide.position_mm, back), start = turned(guide.direction, back), arm = guide.arm_mm,
            sense = guide.sense](const RimPoint& p) {
        const double x = p.xy_mm[0] - pivot[0], y = p.xy_mm[1] - pivot[1], away = std::hypot(x, y);
        const double cosine = (arm * arm + away * away - p.reach_mm * p.reach_mm) / (2.0 * arm * away);
        if (!(std::abs(cosine) <= 1.0)) return kNowhere;
        return sense * std::atan2(start[0] * y - start[1] * x, start[0] * x + start[1] * y) + std::acos(cosine);
    };
}

/// Travel of the spring since cam angle 0 with the roller in its place [mm].
double lift_at(double place, const exchange::PartGuide& guide) {
    if (guide.kind == "roller") return place - guide.start_mm;
    const double seat = std::hypot(guide.lever_mm, guide.spring_mm), angle = std::atan2(guide.spring_mm, guide.lever_mm) - place;
    return guide.spring_mm - std::sqrt(guide.lever_mm * guide.lever_mm + seat * seat - 2.0 * guide.lever_mm * seat * std::cos(angle));
}

/// The highest of the roller's places by each point of the rim. Between points the rim is interpolated by a parabola.
double highest(const Rim& rim, const exchange::PartFile& part, double angle) {
    const double back = -part.rotation_sign * angle;
    const Place place = part.guide.kind == "arm" ? on_arm(part, back) : on_slide(part, back);
    const auto best = std::max_element(rim.begin(), rim.end(), [&](const RimPoint& a, const RimPoint& b) { return place(a) < place(b); });
    if (best == rim.end() || std::isinf(place(*best))) return kNaN;
    const std::size_t count = rim.size(), i = static_cast<std::size_t>(best - rim.begin());
    const RimPoint &before = rim[(i + count - 1) % count], &after = rim[(i + 1) % count];
    const auto apart = [&](const RimPoint& p) { return std::hypot(p.xy_mm[0] - best->xy_mm[0], p.xy_mm[1] - best->xy_mm[1]); };
    const double low = place(before), high = place(after);
    return std::isinf(low) || std::isinf(high) ? place(*best) : top({-apart(before), 0.0, apart(after)}, {low, place(*best), high});
}

/// Least-squares slope of the deviations over the rows within the window.
double slope_near(const std::vector<exchange::TargetRow>& rows, const std::vector<double>& deviation, std::size_t i) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double away = rows[k].angle_rad - rows[i].angle_rad;
        if (std::abs(away) > kHalfWindow) continue;
        n += 1.0, x += away, y += deviation[k], xx += away * away, xy += away * deviation[k];
    }
    const double spread = n * xx - x * x;
    return spread > 0.0 ? (n * xy - x * y) / spread : kNaN;
}

/// The lever arm [mm] at every target row that gives the found torque: the body is turned to the row's angle and the roller pushed against
/// the rim along its line or about its pivot. The arm is the slope of the spring's travel over the angle, times the spring's force there
/// over the requested force (docs/part-file.md). The slope is a mean over 0.2 rad, which averages the facets of a mesh. NaN if the roller
/// touches no point.
/// @pre part.guide.has_roller()
std::vector<double> pushed_arms(const Floor& rim, const exchange::PartFile& part) {
    const Rim ordered = rim_of(rim, part.guide.radius_mm);
    const std::vector<exchange::TargetRow>& rows = part.target;
    std::vector<double> deviation, arms;
    for (const exchange::TargetRow& row : rows)
        deviation.push_back(lift_at(highest(ordered, part, row.angle_rad), part.guide) - row.lift_mm);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double force = 1.0 + part.spring_rate * 1e-3 * deviation[i] / rows[i].load;
        arms.push_back((rows[i].arm_mm + slope_near(rows, deviation, i)) * force);
    }
    return arms;
}

constexpr double kSplineAllowed = 1e-4;  // of an arm: splines are ten times as exact as a mesh's chords

/// The same corners in the same order: the same arms.
bool same_triangles(const solid::Mesh& a, const solid::Mesh& b) {
    const auto same = [&](const solid::Triangle& s, const solid::Triangle& t) {
        for (std::size_t i = 0; i < 3; ++i)
            if (a.points_mm[s[i]] != b.points_mm[t[i]]) return false;
        return true;
    };
    return std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end(), same);
}

/// A flange of a stack of plates: no cable touches its outline.
bool is_flange(const exchange::DxfDrawing& drawing) {
    return drawing.layer("FLANGE") && !drawing.layer("FLOOR") && !drawing.layer("PITCH");
}

/// A workshop drills the frame by the drawing: the cross of a roller's pivot has to be where the law has the pivot.
void require_pivot(const exchange::DxfDrawing& drawing, const LawFile& file) {
    if (file.part.guide.kind != "arm") return;
    const Point& wanted = file.part.guide.position_mm;
    const exchange::DxfLayer* layer = drawing.layer("PIVOT");
    if (layer == nullptr || layer->lines.size() != 2)
        throw core::IoError(file.path.string(), "has no cross of two lines on the layer PIVOT, the pivot of the roller's arm");
    for (const exchange::DxfLine& line : layer->lines) {
        const Point middle{0.5 * (line.from_mm[0] + line.to_mm[0]), 0.5 * (line.from_mm[1] + line.to_mm[1])};
        if (!(std::hypot(middle[0] - wanted[0], middle[1] - wanted[1]) <= exchange::kDrawingChord_mm))
            throw core::IoError(file.path.string(),
                                fmt::format("layer PIVOT: the pivot of the roller's arm is at ({:.3f}, {:.3f}) mm, not at "
                                            "({:.3f}, {:.3f}) mm as PART.json states",
                                            middle[0], middle[1], wanted[0], wanted[1]));
    }
}

/// The arm that an error is relative to, at least [mm]: a roller's arm may cross 0, and a tenth of its largest stands for those near it.
double least_reference(const exchange::PartFile& part) {
    constexpr double kShare = 0.1;
    double largest = 0.0;
    for (const exchange::TargetRow& row : part.target) largest = std::max(largest, std::abs(row.arm_mm));
    return part.guide.has_roller() ? kShare * largest : 0.0;
}

}  // namespace

ArmError compare(const fs::path& path, const std::string& reader, const Floor& floor, const exchange::PartFile& part) {
    ArmError error;
    error.file = path.filename().string();
    error.reader = reader;
    error.rows = part.target.size();
    error.arms_mm = part.guide.has_roller() ? pushed_arms(floor, part) : taut_arms(floor, part);
    const std::vector<double>& arms = error.arms_mm;
    const double least = least_reference(part);
    for (std::size_t i = 0; i < arms.size(); ++i) {
        const double wanted = part.target[i].arm_mm, relative = std::abs(arms[i] - wanted) / std::max(std::abs(wanted), least);
        if (relative <= error.worst_relative) continue;  // false for NaN, which becomes and stays the worst
        error.worst_relative = relative;
        error.worst_angle_rad = part.target[i].angle_rad;
        if (std::isnan(relative)) break;
    }
    return error;
}

ArmError compare_mesh(const LawFile& file, const std::string& reader, const solid::Mesh& mesh) {
    if (mesh.triangles.size() != file.entry.triangles)
        throw core::IoError(file.path.string(),
                            fmt::format("{} finds {} triangles, not {} as stated", reader, mesh.triangles.size(), file.entry.triangles));
    return compare(file.path, reader, find_floor(as_made(mesh, file.part), file.part), file.part);
}

std::vector<ArmError> read_stl(const LawFile& file) {
    const solid::Mesh first = exchange::read_stl_assimp(file.path), second = exchange::read_stl_openmesh(file.path);
    std::vector<ArmError> errors{compare_mesh(file, "assimp", first)};
    if (same_triangles(first, second)) {
        errors.push_back(errors.front());
        errors.back().reader = "openmesh";
    } else {
        errors.push_back(compare_mesh(file, "openmesh", second));
    }
    return errors;
}

std::vector<ArmError> read_3mf(const LawFile& file) { return {compare_mesh(file, "lib3mf", exchange::read_3mf(file.path))}; }

std::vector<ArmError> read_drawing(const LawFile& file) {
    const exchange::DxfDrawing drawing = exchange::read_dxf(file.path);
    if (is_flange(drawing)) return {};
    require_pivot(drawing, file);
    const auto compared = [&](const char* reader, Drawn drawn) {
        return compare(file.path, reader, drawn_floor(drawing, drawn, file.part, file.path.string()), file.part);
    };
    std::vector<ArmError> errors{compared("dxflib", Drawn::kPolyline), compared("dxflib, spline", Drawn::kSpline)};
    errors.back().allowed = kSplineAllowed;
    return errors;
}

std::vector<ArmError> read_step(const LawFile& file) {
    const exchange::StepFile step(file.path);
    const auto ray = [&step](double azimuth, double z_mm) { return step.outermost(azimuth, z_mm); };
    ArmError error = compare(file.path, "opencascade", find_floor(ray, file.part), file.part);
    error.allowed = kSplineAllowed;
    return {error};
}

std::vector<ArmError> read_program(const LawFile& file) {
    if (!toolpath::can_interpret()) return {};
    const toolpath::Interpreted program = toolpath::interpret(file.path);
    if (const auto faults = toolpath::faults(program); !faults.empty()) throw core::IoError(file.path.string(), faults.front());
    std::vector<ArmError> errors;
    for (const toolpath::CutFloor& cut : toolpath::cut_floors(program)) {
        const auto ray = [&cut](double azimuth, double z_mm) { return cut.radius(azimuth, z_mm); };
        errors.push_back(compare(file.path, "rs274", find_floor(ray, file.part), file.part));
        errors.back().reader += " " + cut.name();
    }
    return errors;
}

std::vector<ArmError> read_print(const LawFile& file) {
    const Sliced print = read_sliced(file.path);
    ArmError error = compare(file.path, "perimeters", sliced_floor(print, file.part), file.part);
    double least_mm = file.part.target.front().arm_mm;
    for (const exchange::TargetRow& row : file.part.target) least_mm = std::min(least_mm, row.arm_mm);
    error.allowed = 0.5 * print.layer_mm / least_mm;
    error.when_broken = core::Severity::kWarning;
    return {error};
}

double bore_mm(const std::filesystem::path& stl, const exchange::PartFile& part) {
    constexpr double kFlat_mm = 1e-4;  // single precision at 1 m
    const solid::Mesh mesh = as_made(exchange::read_stl_assimp(stl), part);
    double low = std::numeric_limits<double>::infinity(), radius = low;
    for (const auto& p : mesh.points_mm) low = std::min(low, p[2]);
    for (const auto& p : mesh.points_mm)
        if (p[2] < low + kFlat_mm) radius = std::min(radius, std::hypot(p[0], p[1]));  // the corners of its polygon lie on the hole
    if (!(radius > kFlat_mm)) throw core::IoError(stl.string(), "its lowest face has no hole about the axis");
    return 2.0 * radius - (part.compensated ? part.compensated->bore_offset_mm : 0.0);
}

}  // namespace fusee::readback
