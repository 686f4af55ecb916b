#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/core/finding.h"
#include "fusee/core/path.h"
#include "fusee/core/provenance.h"
#include "fusee/drawing/sheet.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/part_file.h"
#include "fusee/readback/readback.h"
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
    std::optional<exchange::brep::Brep> exact = {};          ///< of the STEP file
    std::optional<std::vector<drawing::Sheet>> sheets = {};  ///< of the shop drawing
    std::optional<exchange::OnShaft> shaft = {};             ///< of one of two cables

    std::vector<FileRow> law_files = {};    ///< carry the law: PART.json names them, and they are read back
    std::vector<FileRow> other_files = {};  ///< do not carry the law: drawings, files compensated for a process
    core::Findings findings = {};

    [[nodiscard]] std::string name() const { return base.filename().string(); }
    /// "out/pnrvsa/k_se" and ".stl", or "_kerf.dxf".
    [[nodiscard]] std::filesystem::path path(const std::string& ending) const { return std::filesystem::path(base) += ending; }
    /// Its PART.json with these files.
    [[nodiscard]] exchange::PartFile described(std::vector<exchange::FileEntry> files) const {
        exchange::PartFile file = exchange::describe_part(part, spring, std::move(files), provenance);
        file.shaft = shaft;
        return file;
    }
    /// Records a file that carries the law.
    void state(const std::filesystem::path& file, std::size_t triangles = 0, double chordal_error_mm = 0.0) {
        law_files.push_back(file_row(file, triangles, chordal_error_mm));
    }
};

/// OpenSCAD's rendering of the part's SCAD file, without the slivers of its rounding, and validated as fusee's own solids are. Leaves no
/// file.
/// @throws core::IoError
[[nodiscard]] solid::Mesh rendered_by_openscad(const PartExport& out);

inline constexpr const char* kOpenScadRenders = "OpenSCAD renders the solids";  ///< the note of what runs OpenSCAD

/// One export format: one file of src/formats, which registers it.
struct Format {
    using WriteMesh = void (*)(const std::filesystem::path&, const solid::Mesh&, const std::string& name, const std::string& provenance);

    const char* name;                                      ///< in `outputs.formats`; the name of its source file
    const char* extension;                                 ///< of its files: ".stl"
    const char* meaning = "";                              ///< for `fusee keys`
    const char* note = "";                                 ///< announced before the export, if it takes long
    int place = 100;                                       ///< in PART.json and in lists, lowest first; formats with the same place by name
    bool (*by_default)(const checks::Process&) = nullptr;  ///< without `outputs.formats`: is it written? nullptr: no
    WriteMesh write_mesh = nullptr;                        ///< of a mesh: writes it as NAME.extension, and as NAME_compensated.extension
    void (*write)(PartExport&) = nullptr;                  ///< of other formats: writes the files and records them
    readback::LawReader read_back = nullptr;  ///< of files with this extension; nullptr: another format's, or they are not read
    /// Do the bytes of two such files prove that the first is the mirror image of the second? nullptr: not known, so that both are read.
    bool (*is_mirror_image)(std::string_view image, std::string_view file) = nullptr;
};

/// All formats, by place.
[[nodiscard]] std::span<const Format> all_formats();
/// Names of the formats that a profile without `outputs.formats` gets, by place.
[[nodiscard]] std::vector<std::string> default_formats(const checks::Process& process);
/// Writes the part in each of the formats `names`, by place.
void write_formats(PartExport& out, const std::vector<std::string>& names);

/// Reads every file of `part.files` in `folder` with the readers of its format and recomputes the arm. Also demands that the bytes have the
/// stated SHA-256. Files of a format without a reader are passed over.
/// @throws IoError if a file cannot be read, does not match its entry or has no format
[[nodiscard]] std::vector<readback::ArmError> read_back(const std::filesystem::path& folder, const exchange::PartFile& part);

/// What a read-back found in the files of a part.
struct ReadPart {
    exchange::PartFile file;
    std::vector<readback::ArmError> errors;
};
/// The same for the other side of a part that was read: a file whose bytes prove it to be the mirror image of the part's file in the same
/// place takes over the arms found there (`ArmError::mirror_of`). Every other file is read. @throws as read_back
[[nodiscard]] std::vector<readback::ArmError> read_back_image(const std::filesystem::path& folder, const exchange::PartFile& image,
                                                              const ReadPart& part);

inline bool always(const checks::Process&) { return true; }

}  // namespace fusee::formats
