#include "fusee/pipeline/export.h"

#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/openscad.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/scad.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

exchange::FileEntry entry_of(const fs::path& path, std::size_t triangles, double chordal_error_mm) {
    return {path.filename().string(), core::sha256_hex(core::read_file(path)), triangles, chordal_error_mm};
}

/// The mesh that goes into the files: fusee's own, or OpenSCAD's rendering of the SCAD file.
solid::Mesh exported_mesh(const solid::Part& part, Via via, const fs::path& scad, const fs::path& stl, const std::string& provenance) {
    if (via == Via::kCgal) {
        exchange::write_stl(stl, part.mesh, provenance);
        return part.mesh;
    }
    exchange::render_scad(scad, stl);
    return exchange::read_stl_openmesh(stl);
}

core::Finding judge(const readback::ArmError& error, const std::string& part, double chordal_error_mm) {
    core::Finding f;
    f.rule = "readback.arm";
    f.what = fmt::format("the lever arm recomputed from {} (read by {}) is the one asked for", error.file, error.reader);
    f.measured = 100.0 * error.worst_relative;
    f.bound = core::Bound::kAtMost;
    f.allowed = 100.0 * error.allowed;
    f.unit = "%";
    f.where = fmt::format("{} at cam angle {:.1f} deg, worst of {} positions", part, core::deg_from_rad(error.worst_angle_rad), error.rows);
    f.suggestion = fmt::format("tolerances.chordal_error_mm = {:.2g}, unless something stands in the cable's way there", 0.5 * chordal_error_mm * std::min(1.0, error.allowed / error.worst_relative));
    f.source = "docs/part-file.md: turn the part, lay a taut cable over the groove's floor";
    return core::judged(f, core::Severity::kRequired);
}

}  // namespace

const char* to_string(Via via) { return via == Via::kCgal ? "cgal" : "openscad"; }

report::PartReport export_part(const DesignedPart& designed, const profile::Profile& profile, const core::Provenance& provenance, Via via,
                               const fs::path& folder) {
    const solid::Part& part = designed.part;
    const std::string name = to_string(part.cam.kind);
    const profile::Outputs& outputs = profile.outputs;
    const fs::path base = folder / name, stl = fs::path(base) += ".stl", scad = fs::path(base) += ".scad";
    std::vector<exchange::FileEntry> entries;
    if (outputs.scad || via == Via::kOpenScad) {
        exchange::write_scad(scad, part, provenance.line());
        entries.push_back(entry_of(scad, 0, part.chordal_error_mm));
    }
    const solid::Mesh mesh = exported_mesh(part, via, scad, stl, provenance.line());
    entries.push_back(entry_of(stl, mesh.triangles.size(), part.chordal_error_mm));
    if (outputs.three_mf) {
        const fs::path path = fs::path(base) += ".3mf";
        exchange::write_3mf(path, mesh, name, provenance.line());
        entries.push_back(entry_of(path, mesh.triangles.size(), part.chordal_error_mm));
    }
    if (outputs.dxf && part.cam.kind == cam::PartKind::kSeries && part.cam.closed()) {
        const fs::path path = fs::path(base) += ".dxf";
        exchange::write_dxf(path, exchange::spool_drawing(part, provenance.line()));
        entries.push_back(entry_of(path, 0, 1e-3));
    }
    const profile::PartSpec& spec = part.cam.kind == cam::PartKind::kSeries ? profile.k_se : profile.k_pe;
    const fs::path json = fs::path(base) += ".json";
    exchange::write_part_file(json, exchange::describe_part(part, spec.spring, entries, provenance));

    report::PartReport report;
    report.part = &part;
    report.spring = spec.spring;
    report.findings = designed.findings;
    report.arm_errors = readback::read_back(folder, exchange::read_part_file(json));
    for (const readback::ArmError& error : report.arm_errors) report.findings.push_back(judge(error, name, part.chordal_error_mm));
    for (exchange::FileEntry& entry : entries) report.files.push_back({entry, fs::file_size(folder / entry.name)});
    report.files.push_back({entry_of(json, 0, 0.0), fs::file_size(json)});
    report.quality = solid::measure_quality(part.mesh);
    return report;
}

}  // namespace fusee::pipeline
