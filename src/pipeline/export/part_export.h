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

/// One part on its way into files. A format is a function that takes it, writes what the profile asks for and states what it wrote.
struct PartExport {
    const solid::Part& part;
    spring::BaseSpring spring;
    const profile::Profile& profile;
    core::Provenance provenance;
    Via via;
    std::filesystem::path base;  ///< folder and name: "out/pnrvsa/k_se"

    // The bodies that files are made from: what is there already is not made again (a mirror image has its own from the other side).
    solid::Mesh mesh = {};                 ///< of the STL and 3MF files: the part's, or OpenSCAD's rendering; empty = not made yet
    std::optional<brep::Brep> exact = {};  ///< of the STEP file

    std::vector<FileRow> stated = {};  ///< carry the law: PART.json names them, and they are read back
    std::vector<FileRow> beside = {};  ///< are not what the law says: compensated for a process
    core::Findings findings = {};

    [[nodiscard]] std::string name() const { return base.filename().string(); }
    /// "out/pnrvsa/k_se" and ".stl", or "_kerf.dxf".
    [[nodiscard]] std::filesystem::path path(const std::string& ending) const { return std::filesystem::path(base) += ending; }
    /// A file that carries the law, as it now stands.
    void state(const std::filesystem::path& file, std::size_t triangles = 0, double chordal_error_mm = 0.0) {
        stated.push_back(file_row(file, triangles, chordal_error_mm));
    }
};

/// "readback.arm" of one file. @param cam that it has to carry
[[nodiscard]] core::Finding judge(const readback::ArmError& error, const cam::Cam& cam);

/// "readback.sliced" of a print: something to accept, not a fault of the files.
[[nodiscard]] core::Finding judge_print(const readback::ArmError& error, const solid::Part& part);
/// OpenSCAD's own rendering of the SCAD file, by way of `stl`, without the slivers that its rounding leaves, and held to what fusee's own
/// solids are held to. @throws core::IoError
[[nodiscard]] solid::Mesh rendered(const std::filesystem::path& scad, const std::filesystem::path& stl);

void write_meshes(PartExport& out);    ///< SCAD, STL, 3MF
void write_rendered(PartExport& out);  ///< OpenSCAD's STL
void write_sliced(PartExport& out);    ///< PrusaSlicer's G-code of the mesh, or the finding that it is not installed
void write_drawing(PartExport& out);   ///< DXF of a planar part
void write_plates(PartExport& out);    ///< DXF of each plate of a stack; their kerf's beside the law
void write_exact(PartExport& out);     ///< STEP, or the finding why OpenCASCADE makes no solid of the part
void write_programs(PartExport& out);  ///< G-code
void write_kerf(PartExport& out);      ///< DXF of a planar part, moved by half the kerf: beside the law
void write_sheets(PartExport& out);    ///< shop drawing, SVG and PDF: beside the law

}  // namespace fusee::pipeline
