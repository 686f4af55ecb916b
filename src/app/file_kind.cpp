#include "file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>

#include "fusee/core/csv.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/toml.h"

namespace fusee::app {

namespace {

struct KindText {
    FileKind kind;
    const char* is;
};
/// What each kind is, and the command that reads it.
constexpr KindText kTexts[] = {
    {FileKind::kProfile, "a profile, which fusee make reads"},
    {FileKind::kStudy, "a study, which fusee batch reads"},
    {FileKind::kCaseFile, "the file of a case; fusee diagnose reads its folder"},
    {FileKind::kToml, "a TOML file"},
    {FileKind::kBreakAway, "a sheet of break-away tests, which fusee identify reads"},
    {FileKind::kCoupons, "a sheet of coupons, which fusee calibrate reads"},
    {FileKind::kInspection, "the inspection sheet of a part, which fusee calibrate reads"},
    {FileKind::kMeasuredSprings, "a table of measured springs, which fusee init --law reads"},
    {FileKind::kCatalogue, "a list of springs on sale, which fusee springs --catalogue reads"},
    {FileKind::kCaseSheet, "a sheet of a case; fusee diagnose reads its folder"},
    {FileKind::kCsv, "a CSV file"},
    {FileKind::kDiagnosis, "a diagnosis, which fusee predict --effects reads"},
    {FileKind::kJson, "a JSON file"},
    {FileKind::kMesh, "a mesh, which fusee check reads"},
    {FileKind::kPage, "a page for a browser"},
    {FileKind::kPicture, "a picture"},
    {FileKind::kCaseFolder, "the folder of a case, which fusee diagnose reads"},
    {FileKind::kStudyFolder, "the folder of a finished study, which fusee query reads"},
};

struct Ending {
    const char* ending;
    FileKind kind;
};
constexpr Ending kEndings[] = {
    {".toml", FileKind::kToml},   {".csv", FileKind::kCsv},     {".tsv", FileKind::kCsv},   {".txt", FileKind::kCsv},
    {".json", FileKind::kJson},   {".stl", FileKind::kMesh},    {".obj", FileKind::kMesh},  {".3mf", FileKind::kMesh},
    {".step", FileKind::kMesh},   {".stp", FileKind::kMesh},    {".html", FileKind::kPage}, {".png", FileKind::kPicture},
    {".svg", FileKind::kPicture}, {".pdf", FileKind::kPicture},
};

FileKind kind_by_ending(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const Ending* found = core::find_by(kEndings, &Ending::ending, ending);
    return found == nullptr ? FileKind::kUnknown : found->kind;
}

/// The first bytes of a file; not core::read_file, which notes an input of the run.
std::string beginning_of(const fs::path& path) {
    std::string bytes(100'000, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

FileKind kind_of_toml(const fs::path& path) {
    try {
        const toml::table table = core::parse_toml(beginning_of(path), path.string());
        const auto any = [&table](std::initializer_list<const char*> names) {
            return std::any_of(names.begin(), names.end(), [&table](const char* name) { return table.contains(name); });
        };
        if (table.contains("study")) return FileKind::kStudy;
        if (any({"law", "cam", "k_se", "k_pe"})) return FileKind::kProfile;
        if (any({"experiments", "bench", "model"})) return FileKind::kCaseFile;
    } catch (const core::InputError&) {  // also one that is longer: its reader says more
    }
    return FileKind::kToml;
}

core::CsvColumn text_column(const char* name) { return {name, core::CsvColumn::Kind::kText}; }

FileKind kind_of_csv(const fs::path& path) {
    const std::string beginning = beginning_of(path);
    const auto fits = [&beginning](const std::vector<core::CsvColumn>& columns) { return core::csv_fits(beginning, columns); };
    if (fits({text_column("side"), text_column("direction"), {"motor_torque_Nm"}, {"load_torque_Nm"}})) return FileKind::kBreakAway;
    if (fits({text_column("item"), {"given"}, text_column("given_unit"), {"measured"}})) return FileKind::kCoupons;
    if (fits({text_column("part"), {"nominal_mm"}, {"measured_deviation_mm"}})) return FileKind::kInspection;
    if (fits({{"angle_rad"}, {"series_Nm"}, {"parallel_Nm"}})) return FileKind::kMeasuredSprings;
    if (fits({text_column("kind"), text_column("name"), {"rate"}})) return FileKind::kCatalogue;
    std::error_code error;
    return fs::is_regular_file(path.parent_path() / "case.toml", error) ? FileKind::kCaseSheet : FileKind::kCsv;
}

FileKind kind_of_folder(const fs::path& path) {
    std::error_code error;
    if (fs::is_regular_file(path / "case.toml", error)) return FileKind::kCaseFolder;
    return fs::is_regular_file(path / "index.sqlite", error) ? FileKind::kStudyFolder : FileKind::kUnknown;
}

/// kToml of a study: the kind of every file of its format.
FileKind format_of(FileKind kind) {
    if (kind <= FileKind::kToml) return FileKind::kToml;
    if (kind <= FileKind::kCsv) return FileKind::kCsv;
    return kind <= FileKind::kJson ? FileKind::kJson : kind;
}

}  // namespace

FileKind kind_of_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) return kind_of_folder(path);
    if (!fs::is_regular_file(status)) return FileKind::kUnknown;  // opening a pipe waits
    switch (const FileKind kind = kind_by_ending(path)) {
        case FileKind::kToml:
            return kind_of_toml(path);
        case FileKind::kCsv:
            return kind_of_csv(path);
        case FileKind::kJson:
            return path.filename() == "diagnosis.json" ? FileKind::kDiagnosis : kind;
        default:
            return kind;
    }
}

std::string other_kind(const fs::path& path, const std::vector<FileKind>& read) {
    const FileKind kind = kind_of_file(path);
    const bool open =
        kind == FileKind::kCaseSheet || kind == format_of(kind);  // it may be any of its format: with --columns, another sheet
    const auto may_be = [kind, open](FileKind one) { return one == kind || (open && format_of(one) == format_of(kind)); };
    if (kind == FileKind::kUnknown || std::any_of(read.begin(), read.end(), may_be)) return "";
    return fmt::format("is {}", core::find_by(kTexts, &KindText::kind, kind)->is);
}

CLI::Validator reads(std::vector<FileKind> kinds, std::string allowed) {
    const auto check = [kinds = std::move(kinds), allowed = std::move(allowed)](const std::string& path) -> std::string {
        const std::string kind = other_kind(path, kinds);
        return kind.empty() ? "" : fmt::format("{} {} (allowed: {})", core::printable(path), kind, allowed);
    };
    return CLI::Validator(check, "");
}

CLI::Validator reads_profile() { return reads({FileKind::kProfile}, "a profile"); }
CLI::Validator reads_case() { return reads({FileKind::kCaseFolder}, "the folder of a case, which fusee case-template PROFILE writes"); }
CLI::Validator reads_diagnosis() { return reads({FileKind::kDiagnosis}, "diagnosis.json of fusee diagnose"); }
CLI::Validator reads_catalogue() { return reads({FileKind::kCatalogue}, "a CSV file of springs on sale"); }

}  // namespace fusee::app
