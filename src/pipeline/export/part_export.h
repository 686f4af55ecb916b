#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "fusee/brep/brep.h"
#include "fusee/core/finding.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/export.h"
#include "fusee/profile/profile.h"

namespace fusee::pipeline {

/// The export of one part. A format is a function that takes it, writes the files that the profile asks for and records them.
struct PartExport {
    const solid::Part& part;
    spring::BaseSpring spring;
    const profile::Profile& profile;
    core::Provenance provenance;
    Via via;
    std::filesystem::path base;  ///< folder and name: "out/pnrvsa/k_se"

    // The bodies of the files, made once (those of a mirror image come from the other side).
    solid::Mesh mesh = {};                 ///< of the STL and 3MF files: the part's, or OpenSCAD's rendering; empty = not made yet
    std::optional<brep::Brep> exact = {};  ///< of the STEP file

    std::vector<FileRow> law_files = {};    ///< carry the law: PART.json names them, and they are read back
    std::vector<FileRow> other_files = {};  ///< do not carry the law: drawings, files compensated for a process
    core::Findings findings = {};

    [[nodiscard]] std::string name() const { return base.filename().string(); }
    /// "out/pnrvsa/k_se" and ".stl", or "_kerf.dxf".
    [[nodiscard]] std::filesystem::path path(const std::string& ending) const { return std::filesystem::path(base) += ending; }
    /// Records a file that carries the law.
    void state(const std::filesystem::path& file, std::size_t triangles = 0, double chordal_error_mm = 0.0) {
        law_files.push_back(file_row(file, triangles, chordal_error_mm));
    }
};

/// "readback.arm" of one file. @param cam that the file must carry
[[nodiscard]] core::Finding judge(const readback::ArmError& error, const cam::Cam& cam);

/// "readback.sliced" of a print: a warning, since the files are right.
[[nodiscard]] core::Finding judge_print(const readback::ArmError& error, const solid::Part& part);
/// OpenSCAD's rendering of the SCAD file through `stl`, without the slivers of its rounding, and validated as fusee's own solids are.
/// @throws core::IoError
[[nodiscard]] solid::Mesh rendered(const std::filesystem::path& scad, const std::filesystem::path& stl);

void write_meshes(PartExport& out);    ///< SCAD, STL, 3MF
void write_rendered(PartExport& out);  ///< OpenSCAD's STL
void write_sliced(PartExport& out);    ///< PrusaSlicer's G-code of the mesh, or the finding that it is not installed
void write_drawing(PartExport& out);   ///< DXF of a planar part
void write_plates(PartExport& out);    ///< DXF of each plate of a stack; also with kerf, which do not carry the law
void write_exact(PartExport& out);     ///< STEP, or the finding why OpenCASCADE makes no solid of the part
void write_programs(PartExport& out);  ///< G-code
void write_kerf(PartExport& out);      ///< DXF of a planar part, moved by half the kerf: does not carry the law
void write_sheets(PartExport& out);    ///< shop drawing, SVG and PDF: does not carry the law

}  // namespace fusee::pipeline
