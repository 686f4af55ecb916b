#include "readers.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "exchange/fixtures/zip.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/coupon/calibration.h"
#include "fusee/coupon/sheet.h"
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/mesh_file.h"
#include "fusee/exchange/part_file.h"
#include "fusee/gap_case/break_away.h"
#include "fusee/gap_case/case.h"
#include "fusee/profile/profile.h"
#include "fusee/spring/catalogue.h"
#include "fusee/toolpath/mill.h"
#include "fusee/toolpath/read_back.h"

namespace fs = std::filesystem;

namespace fusee::fuzz {

namespace {

/// A file of this process with the bytes: for readers that take a path. In memory where the system has such a folder.
class Scratch {
public:
    explicit Scratch(const char* ending) {
        std::error_code error;
        const fs::path folder = fs::is_directory("/dev/shm", error) ? fs::path("/dev/shm") : fs::temp_directory_path();
        path_ = folder / ("fusee-fuzz-" + std::to_string(::getpid()) + ending);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& with(std::string_view bytes) const {
        std::ofstream(path_, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return path_;
    }

private:
    fs::path path_;
};

void read_profile(std::string_view bytes) { (void)profile::parse_profile(std::string(bytes), "/nonexistent/fuzz.toml"); }

/// The table of a measured law, read as a profile names it.
void read_law(std::string_view bytes) {
    static const Scratch file(".csv");
    const std::string table = file.with(bytes).filename().string();
    (void)profile::parse_profile(
        "name = \"fuzz\"\n[rig]\ncapstan_radius_mm = 20\njoint_radius_mm = 20\ngear_friction = 0.2\nleast_torque_Nm = 0.5\n"
        "peak_torque_Nm = 0.7\noverdrive_torque_Nm = 0.8\n[law]\nkind = \"table\"\nfile = \"" +
            table + "\"\nstart_torque_Nm = 0.1\nend_torque_Nm = 1.0\n",
        file.with(bytes).parent_path() / "fuzz.toml");
}

/// Text up to a line "=== NAME" is case.toml, the rest the file NAME; so one input is a whole case.
gap_case::CaseTexts split_case(std::string_view bytes) {
    gap_case::CaseTexts texts;
    std::string name = "case.toml";
    while (!bytes.empty()) {
        const std::size_t next = bytes.find("\n=== ");
        texts[name] = std::string(bytes.substr(0, next == std::string_view::npos ? next : next + 1));
        if (next == std::string_view::npos) break;
        bytes.remove_prefix(next + 5);
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        name = std::string(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    return texts;
}

void read_case(std::string_view bytes) {
    const gap_case::CaseTexts texts = split_case(bytes);
    const gap_case::CaseFiles files("fuzz", texts);
    const gap_case::Case read = gap_case::read_case(files);
    (void)gap_case::read_inputs(read, files);
}

/// The first byte, '0' to '5', chooses the experiment of the case that case-template makes.
void read_experiment(std::string_view bytes) {
    static const gap_case::CaseTexts all = split_case(core::read_file(FUSEE_SOURCE_DIR "/tests/fuzz/seeds/case/template.txt"));
    static const gap_case::Case nominal = gap_case::read_case(gap_case::CaseFiles("fuzz", all));
    if (bytes.empty()) return;
    const auto which = static_cast<unsigned char>(bytes.front() - '0') % gap_case::kExperiments;
    const auto found = nominal.files.find(gap_case::kAllExperiments[which]);
    if (found == nominal.files.end()) return;
    const gap_case::CaseTexts texts{{found->second.front(), std::string(bytes.substr(1))}};
    (void)gap_case::read_inputs(nominal, gap_case::CaseFiles("fuzz", texts));
}

void read_break_away(std::string_view bytes) {
    const auto rows = gap_case::parse_break_away(bytes, "fuzz.csv");
    (void)gap_case::identify_friction(rows);
}

void read_coupon(std::string_view bytes) {
    if (coupon::is_inspection(bytes))
        (void)coupon::fit_contour(coupon::parse_inspection(bytes, "fuzz.csv"));
    else
        (void)coupon::parse_sheet(bytes, "fuzz.csv");
}

void read_catalogue(std::string_view bytes) { (void)spring::parse_catalogue(bytes, "fuzz.csv"); }
void read_diagnosis(std::string_view bytes) { (void)diagnosis::diagnosis_json(diagnosis::parse_diagnosis(bytes, "fuzz.json")); }

void read_part(std::string_view bytes) {
    static const Scratch file(".json");
    (void)exchange::read_part_file(file.with(bytes));
}

void read_gcode(std::string_view bytes) { (void)toolpath::mill::read_program(std::string(bytes), "fuzz.ngc"); }

void read_canonical(std::string_view bytes) {
    const toolpath::Interpreted read = toolpath::parse_canonical(std::string(bytes), "fuzz.ngc");
    (void)toolpath::faults(read);
    (void)toolpath::cut_floors(read);
}

void read_dxf(std::string_view bytes) {
    static const Scratch file(".dxf");
    (void)exchange::read_dxf(file.with(bytes));
}

void read_mesh(const char* ending, std::string_view bytes) {
    const Scratch file(ending);
    (void)exchange::read_mesh_file(file.with(bytes));
}
void read_stl(std::string_view bytes) { read_mesh(".stl", bytes); }
void read_obj(std::string_view bytes) { read_mesh(".obj", bytes); }
/// The model of a 3MF file, in an archive; an archive is read as it is. Changed bytes would seldom keep the sums of an archive.
void read_3mf(std::string_view bytes) {
    if (bytes.starts_with("PK")) return read_mesh(".3mf", bytes);
    read_mesh(".3mf", fixtures::three_mf(std::string(bytes)));
}
void read_step(std::string_view bytes) { read_mesh(".step", bytes); }

constexpr Reader kReaders[] = {
    {"profile", read_profile, "profiles/*.toml", false},
    {"law", read_law, "profiles/measured_table.csv", false},
    {"case", read_case, "", false},
    {"experiment", read_experiment, "", false},
    {"break_away", read_break_away, "profiles/examples/break_away.csv", false},
    {"coupon", read_coupon, "profiles/examples/*.csv", false},
    {"catalogue", read_catalogue, "profiles/springs/*.csv", false},
    {"diagnosis", read_diagnosis, "", false},
    {"part", read_part, "", false},
    {"gcode", read_gcode, "", false},
    {"canonical", read_canonical, "", false},
    {"dxf", read_dxf, "", false},
    {"stl", read_stl, "", true},
    {"obj", read_obj, "", true},
    {"3mf", read_3mf, "", true},
    {"step", read_step, "tests/app/fixtures/*.step", true},
};

/// Regular files of a folder whose name ends as asked, in order.
void add_files(std::vector<fs::path>& all, const fs::path& folder, const std::string& ending) {
    std::error_code none;
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.is_regular_file() && entry.path().filename().string().ends_with(ending)) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    all.insert(all.end(), found.begin(), found.end());
}

}  // namespace

std::span<const Reader> readers() { return kReaders; }

std::vector<fs::path> seeds(const Reader& reader) {
    std::vector<fs::path> all;
    const fs::path source = FUSEE_SOURCE_DIR, shipped = reader.shipped;
    if (!shipped.empty())
        add_files(all, source / shipped.parent_path(), fs::path(shipped).filename().string().substr(shipped.stem() == "*" ? 1 : 0));
    add_files(all, source / "tests/fuzz/seeds" / reader.name, "");
    return all;
}

const Reader* reader(std::string_view name) {
    for (const Reader& each : kReaders)
        if (name == each.name) return &each;
    return nullptr;
}

bool accepts(const Reader& reader, std::string_view bytes) {
    try {
        reader.read(bytes);
        return true;
    } catch (const core::InputError&) {
        return false;
    }
}

}  // namespace fusee::fuzz
