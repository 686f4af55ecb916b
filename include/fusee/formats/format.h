#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/formats/part_export.h"
#include "fusee/readback/readback.h"

namespace fusee::formats {

inline constexpr const char* kOpenScadRenders = "OpenSCAD renders the solids";  ///< the note of what runs OpenSCAD

/// One export format: one file of src/formats, which registers it.
struct Format {
    using WriteMesh = void (*)(const std::filesystem::path&, const solid::Mesh&, const std::string& name, const std::string& provenance);

    const char* name;                                      ///< in `outputs.formats`; the name of its source file
    const char* extension;                                 ///< of its files: ".stl"
    const char* meaning = "";                              ///< for docs/profile.md
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
