#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "as_made.h"
#include "compare.h"
#include "fusee/core/error.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/readback/readback.h"
#include "fusee/toolpath/read_back.h"
#include "pushed_roller.h"
#include "sliced.h"
#include "taut_cable.h"

namespace fusee::readback {

namespace {

namespace fs = std::filesystem;

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

}  // namespace fusee::readback
