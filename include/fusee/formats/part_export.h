#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fusee/brep/brep.h"
#include "fusee/checks/check.h"
#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/drawing/sheet.h"
#include "fusee/drawing/title_options.h"
#include "fusee/exchange/part_file.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"
#include "fusee/toolpath/settings.h"

namespace fusee::formats {

/// One file written.
struct FileRow {
    exchange::FileEntry entry;
    std::uintmax_t bytes = 0;
};
/// A file as written: name, SHA-256 and size of its bytes. @throws core::IoError
[[nodiscard]] FileRow file_row(const std::filesystem::path& path, std::size_t triangles = 0, double chordal_error_mm = 0.0);

/// What formats need of the profile.
struct Settings {
    std::string design;  ///< its name
    checks::Cable cable;
    checks::Process process;
    toolpath::Settings machining;
    double kerf = 0.0;            ///< of a beam or wire [m]; 0: none
    drawing::TitleOptions title;  ///< of the shop drawing
};

/// The export of one part: a format writes its files and records them here.
struct PartExport {
    const solid::Part& part;
    spring::BaseSpring spring;
    Settings settings;
    core::Provenance provenance;
    std::filesystem::path base;  ///< folder and name: "out/pnrvsa/k_se"

    // The bodies of the files, made once (those of a mirror image come from the other side).
    solid::Mesh mesh = {};                                   ///< of the STL and 3MF files: the part's, or OpenSCAD's rendering
    std::optional<brep::Brep> exact = {};                    ///< of the STEP file
    std::optional<std::vector<drawing::Sheet>> sheets = {};  ///< of the shop drawing

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

/// OpenSCAD's rendering of the part's SCAD file, without the slivers of its rounding, and validated as fusee's own solids are. Leaves no
/// file.
/// @throws core::IoError
[[nodiscard]] solid::Mesh rendered_by_openscad(const PartExport& out);

}  // namespace fusee::formats
