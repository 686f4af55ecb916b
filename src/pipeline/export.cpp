#include "fusee/pipeline/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/brep/brep.h"
#include "fusee/cam/certificate.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/openscad.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/scad.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/solid/cut.h"
#include "fusee/solid/validity.h"
#include "programs.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

fs::path with_ending(const fs::path& base, const char* ending) { return fs::path(base) += ending; }

/// OpenSCAD's own rendering of the SCAD file, without the slivers that its rounding leaves, and held to what fusee's own solids are held
/// to.
solid::Mesh rendered(const fs::path& scad, const fs::path& stl) {
    exchange::render_scad(scad, stl);
    const solid::Mesh raw = exchange::read_stl_openmesh(stl);
    solid::Mesh mesh = solid::without_slivers(raw).value_or(raw);
    if (const solid::Validity validity = solid::validate(mesh); !validity.good())
        throw core::IoError(scad.filename().string(), "OpenSCAD's solid is not valid: " + validity.line());
    return mesh;
}

using FileRows = std::vector<report::FileRow>;

/// Every format asked for. Through OpenSCAD the mesh comes from the SCAD file by way of an STL file; what was not asked for goes again.
FileRows write_files(const solid::Part& part, const profile::Outputs& outputs, const std::string& provenance, Via via,
                     const fs::path& base) {
    const fs::path scad = with_ending(base, ".scad"), stl = with_ending(base, ".stl"), three_mf = with_ending(base, ".3mf"),
                   dxf = with_ending(base, ".dxf");
    const bool direct = via == Via::kCgal;
    if (outputs.scad || !direct) exchange::write_scad(scad, part, provenance);
    const solid::Mesh mesh = direct ? part.mesh : rendered(scad, stl);
    if (outputs.stl) exchange::write_stl(stl, mesh, provenance);
    if (outputs.three_mf) exchange::write_3mf(three_mf, mesh, base.filename().string(), provenance);
    const bool drawn = outputs.dxf && part.cam.closed();
    if (drawn) exchange::write_dxf(dxf, exchange::spool_drawing(part, provenance));
    if (!outputs.scad) fs::remove(scad);
    if (!outputs.stl) fs::remove(stl);

    FileRows rows;
    const auto list = [&](bool written, const fs::path& path, std::size_t triangles, double chordal_error_mm) {
        if (written) rows.push_back(file_row(path, triangles, chordal_error_mm));
    };
    list(outputs.stl, stl, mesh.triangles.size(), part.chordal_error_mm);
    list(outputs.three_mf, three_mf, mesh.triangles.size(), part.chordal_error_mm);
    list(outputs.scad, scad, 0, part.chordal_error_mm);
    list(drawn, dxf, 0, exchange::kDrawingChord_mm);
    return rows;
}

/// STEP, or why OpenCASCADE makes no solid of the part.
core::Findings write_solid(const solid::Part& part, const std::string& provenance, const fs::path& base, FileRows& rows) {
    const auto solid = brep::build(part);
    if (!solid) return solid.refusal();
    const fs::path step = with_ending(base, ".step");
    exchange::write_step(step, *solid, base.filename().string(), provenance);
    rows.push_back(file_row(step, 0, solid->deviation_mm));
    return {};
}

/// A mesh keeps its chordal error, and no arm is off by more: the suggested one suits the least arm. Where no cable can be laid at all, the
/// guide is in the part's way.
std::string nearest_change(const readback::ArmError& error, const cam::Cam& cam) {
    double least = cam.working.front().path.h, farthest = 0.0;
    for (const cam::Contact& c : cam.working)
        least = std::min(least, c.path.h), farthest = std::max(farthest, std::hypot(c.path.h, c.path.slope));
    if (std::isfinite(error.worst_relative))
        return fmt::format("tolerances.chordal_error_mm = {:.2g}", 0.8 * error.allowed * core::mm_from_m(least));
    const cam::Guide& guide = cam.options.guide;
    return fmt::format("{}.guide.distance_mm = {:.1f}: the guide lies within the part", to_string(cam.kind),
                       core::mm_from_m(farthest + guide.radius + 2.0 * cam.options.cable_diameter));
}

core::Finding judge(const readback::ArmError& error, const cam::Cam& cam) {
    core::Finding f;
    f.rule = "readback.arm";
    f.what = fmt::format("the lever arm recomputed from {} (read by {}) is the one asked for", error.file, error.reader);
    f.measured = 100.0 * error.worst_relative;
    f.bound = core::Bound::kAtMost;
    f.allowed = 100.0 * error.allowed;
    f.unit = "%";
    f.where = fmt::format("{} at cam angle {:.1f} deg, worst of {} positions", to_string(cam.kind),
                          core::deg_from_rad(error.worst_angle_rad), error.rows);
    f.suggestion = nearest_change(error, cam);
    f.source = "docs/part-file.md: turn the part, lay a taut cable over the groove's floor";
    return core::judged(f, core::Severity::kRequired);
}

}  // namespace

const char* to_string(Via via) { return via == Via::kCgal ? "cgal" : "openscad"; }

report::FileRow file_row(const fs::path& path, std::size_t triangles, double chordal_error_mm) {
    const std::string bytes = core::read_file(path);
    return {{path.filename().string(), core::sha256_hex(bytes), triangles, chordal_error_mm}, bytes.size()};
}

report::PartReport export_part(const DesignedPart& designed, const profile::Profile& profile, const core::Provenance& provenance, Via via,
                               const fs::path& folder) {
    const solid::Part& part = designed.part;
    const profile::PartSpec& spec = part.cam.kind == cam::PartKind::kSeries ? profile.k_se : profile.k_pe;
    const fs::path base = folder / to_string(part.cam.kind), json = with_ending(base, ".json");
    FileRows rows = write_files(part, profile.outputs, provenance.line(), via, base);
    const core::Findings exact = profile.outputs.step ? write_solid(part, provenance.line(), base, rows) : core::Findings{};
    const core::Findings milling =
        profile.outputs.ngc ? write_programs(part, profile.machining, provenance.line(), base, rows) : core::Findings{};
    std::vector<exchange::FileEntry> entries;
    for (const report::FileRow& row : rows) entries.push_back(row.entry);
    exchange::write_part_file(json, exchange::describe_part(part, spec.spring, entries, provenance));

    report::PartReport report;
    report.part = &part;
    report.spring = spec.spring;
    report.findings = designed.findings;
    core::append(report.findings, exact);
    core::append(report.findings, milling);
    report.arm_errors = readback::read_back(folder, exchange::read_part_file(json));
    for (const readback::ArmError& error : report.arm_errors) report.findings.push_back(judge(error, part.cam));
    report.certificate = cam::certify(part.cam);
    if (const auto doubt = cam::doubt(report.certificate, part.cam.kind)) report.findings.push_back(*doubt);
    rows.push_back(file_row(json));
    if (profile.outputs.dxf && profile.outputs.kerf > 0.0 && part.cam.closed()) {  // compensated: not in PART.json, which states the law
        const fs::path kerf = with_ending(base, "_kerf.dxf");
        exchange::write_dxf(kerf, exchange::kerf_drawing(part, core::mm_from_m(profile.outputs.kerf), provenance.line()));
        rows.push_back(file_row(kerf, 0, exchange::kDrawingChord_mm));
    }
    report.files = std::move(rows);
    report.quality = solid::measure_quality(part.mesh);
    return report;
}

}  // namespace fusee::pipeline
