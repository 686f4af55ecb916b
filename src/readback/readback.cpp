#include "fusee/readback/readback.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "as_made.h"
#include "compare.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/toolpath/read_back.h"
#include "pushed_roller.h"
#include "sliced.h"
#include "taut_cable.h"

namespace fusee::readback {

namespace {

namespace fs = std::filesystem;

constexpr double kSplineAllowed = 1e-4;  // of an arm: splines are ten times as exact as a mesh's chords

void require_entry(const fs::path& path, const exchange::FileEntry& entry) {
    const std::string found = core::sha256_hex(core::read_file(path));
    if (found != entry.sha256) throw core::IoError(path.string(), fmt::format("SHA-256 is {}, not {} as stated", found, entry.sha256));
}

ArmError compare_mesh(const fs::path& path, const char* reader, const solid::Mesh& mesh, const exchange::FileEntry& entry,
                      const exchange::PartFile& part) {
    if (mesh.triangles.size() != entry.triangles)
        throw core::IoError(path.string(),
                            fmt::format("{} finds {} triangles, not {} as stated", reader, mesh.triangles.size(), entry.triangles));
    return compare(path, reader, find_floor(as_made(mesh, part), part), part);
}

ArmError compare_step(const fs::path& path, const exchange::PartFile& part) {
    const exchange::StepFile file(path);
    const auto ray = [&file](double azimuth, double z_mm) { return file.outermost(azimuth, z_mm); };
    ArmError error = compare(path, "opencascade", find_floor(ray, part), part);
    error.allowed = kSplineAllowed;
    return error;
}

/// A flange of a stack of plates: no cable touches its outline.
bool is_flange(const exchange::DxfDrawing& drawing) {
    return drawing.layer("FLANGE") && !drawing.layer("FLOOR") && !drawing.layer("PITCH");
}

/// A program as its controller interprets it, with the checks of its moves; one error for each groove that it cuts.
std::vector<ArmError> compare_program(const fs::path& path, const exchange::PartFile& part) {
    const toolpath::Interpreted program = toolpath::interpret(path);
    if (const auto faults = toolpath::faults(program); !faults.empty()) throw core::IoError(path.string(), faults.front());
    std::vector<ArmError> errors;
    for (const toolpath::CutFloor& cut : toolpath::cut_floors(program)) {
        const auto ray = [&cut](double azimuth, double z_mm) { return cut.radius(azimuth, z_mm); };
        errors.push_back(compare(path, "rs274", find_floor(ray, part), part));
        errors.back().reader += " " + cut.name();
    }
    return errors;
}

/// A print: its layers cause steps, which are a warning (docs/theory/read_back.md, eq. 6).
ArmError compare_print(const fs::path& path, const exchange::PartFile& part) {
    const Sliced print = read_sliced(path);
    ArmError error = compare(path, "perimeters", sliced_floor(print, part), part);
    double least_mm = part.target.front().arm_mm;
    for (const exchange::TargetRow& row : part.target) least_mm = std::min(least_mm, row.arm_mm);
    error.allowed = 0.5 * print.layer_mm / least_mm;
    error.when_broken = core::Severity::kWarning;
    return error;
}

}  // namespace

ArmError compare(const fs::path& path, const std::string& reader, const Floor& floor, const exchange::PartFile& part) {
    ArmError error;
    error.file = path.filename().string();
    error.reader = reader;
    error.rows = part.target.size();
    error.arms_mm = part.guide.kind == "roller" ? pushed_arms(floor, part) : taut_arms(floor, part);
    const std::vector<double>& arms = error.arms_mm;
    for (std::size_t i = 0; i < arms.size(); ++i) {
        const double relative = std::abs(arms[i] / part.target[i].arm_mm - 1.0);
        if (relative <= error.worst_relative) continue;  // false for NaN, which becomes and stays the worst
        error.worst_relative = relative;
        error.worst_angle_rad = part.target[i].angle_rad;
        if (std::isnan(relative)) break;
    }
    return error;
}

std::vector<ArmError> read_back(const fs::path& folder, const exchange::PartFile& part) {
    std::vector<ArmError> errors;
    for (const exchange::FileEntry& entry : part.files) {
        const fs::path path = folder / entry.name;
        require_entry(path, entry);
        const std::string extension = path.extension().string();
        if (extension == ".stl") {
            errors.push_back(compare_mesh(path, "assimp", exchange::read_stl_assimp(path), entry, part));
            errors.push_back(compare_mesh(path, "openmesh", exchange::read_stl_openmesh(path), entry, part));
        } else if (extension == ".3mf") {
            errors.push_back(compare_mesh(path, "lib3mf", exchange::read_3mf(path), entry, part));
        } else if (extension == ".dxf") {
            const exchange::DxfDrawing drawing = exchange::read_dxf(path);
            if (is_flange(drawing)) continue;
            errors.push_back(compare(path, "dxflib", drawn_floor(drawing, Drawn::kPolyline, part, path.string()), part));
            errors.push_back(compare(path, "dxflib, spline", drawn_floor(drawing, Drawn::kSpline, part, path.string()), part));
            errors.back().allowed = kSplineAllowed;
        } else if (extension == ".step") {
            errors.push_back(compare_step(path, part));
        } else if (extension == ".ngc") {
            if (!toolpath::can_interpret()) continue;
            for (ArmError& error : compare_program(path, part)) errors.push_back(std::move(error));
        } else if (extension == ".gcode") {
            errors.push_back(compare_print(path, part));
        } else if (extension != ".scad") {
            throw core::IoError(path.string(), "is a kind of file that cannot be read back");
        }
    }
    return errors;
}

}  // namespace fusee::readback
