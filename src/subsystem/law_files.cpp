#include "law_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"

namespace fs = std::filesystem;

namespace fusee::subsystem {

namespace {

constexpr std::size_t kLargestLaw = 200'000'000;  // bytes
constexpr const char* kPlacesOfALaw =
    "a file in [experiments] law, a word law=FILE in the pull's '#' line, or a file law_X.csv beside the pull pull_X.csv";

/// "law_dorsal.csv" for "pull_dorsal.csv"; "" for a name without "pull".
std::string law_name(const std::string& pull) {
    const std::size_t at = pull.find("pull");
    return at == std::string::npos ? "" : pull.substr(0, at) + "law" + pull.substr(at + 4);
}

/// The file that the record's word names. @throws core::InvalidInput unless it is a plain name
std::string named_by_word(const Record& record) {
    const auto word = record.words.find("law");
    if (word == record.words.end()) return "";
    if (fs::path(word->second).filename().string() != word->second)
        throw core::InvalidInput(record.file + ": law", "'" + word->second + "'", "the plain name of a file in the same folder");
    return word->second;
}

core::InvalidInput no_law(const Record& record) { return {record.file + ": law", "missing", kPlacesOfALaw}; }

}  // namespace

bool is_law_file(const fs::path& file, const core::CsvMapping& columns) {
    const std::string bytes = core::read_file(file, kLargestLaw);
    return core::csv_fits(bytes, {{"q_rad"}, {"torque_Nm"}}, columns) && !core::csv_fits(bytes, {{"t_s"}}, columns);
}

LawCurve read_law(const fs::path& folder, const std::string& file, const core::CsvMapping& columns, std::string& bytes) {
    constexpr double kMostAngle = 2.0 * core::kPi, kMostTorque = 1e6;  // one turn; beyond them, the column is in another unit
    const std::string text = core::read_file(folder / file, kLargestLaw);
    const core::CsvTable table =
        core::parse_csv(text, (folder / file).string(), {{"q_rad"}, {"torque_Nm"}}, {.least_rows = 2, .mapping = columns});
    LawCurve law{file, table.numbers("q_rad"), table.numbers("torque_Nm")};
    for (std::size_t i = 0; i < law.q_rad.size(); ++i) {
        if (std::abs(law.q_rad[i]) > kMostAngle && !table.unit_is_told("q_rad"))
            throw table.question(i, "q_rad", "deg", "one turn at most");
        if (std::abs(law.torque_Nm[i]) > kMostTorque)
            throw table.fault(i, "torque_Nm", fmt::format("{:g}", law.torque_Nm[i]), "-1e+06 to 1e+06 Nm");
        if (i > 0 && !(law.q_rad[i] > law.q_rad[i - 1]))
            throw table.fault(i, "q_rad", fmt::format("{:g}", law.q_rad[i]), "an angle above that of the row before");
    }
    bytes += text;
    return law;
}

std::string read_laws(const gap_case::CaseToml& toml, const fs::path& folder, Case& subsystem_case) {
    const bool listed = toml.has("experiments.law");
    const std::vector<std::string> files = listed ? toml.files("experiments.law") : std::vector<std::string>{};
    if (files.size() > 1 && files.size() != subsystem_case.records.size())
        throw toml.fault("experiments.law", fmt::format("{} files", files.size()),
                         fmt::format("one file for all pulls, or {}: one for each", subsystem_case.records.size()));
    std::string bytes;
    std::map<std::string, LawCurve> read;
    for (std::size_t r = 0; r < subsystem_case.records.size(); ++r) {
        Record& record = subsystem_case.records[r];
        std::string file = named_by_word(record);
        const std::string by_name = law_name(record.file);
        const bool named = std::find(files.begin(), files.end(), by_name) != files.end() || (!listed && fs::exists(folder / by_name));
        if (file.empty() && !by_name.empty() && named) file = by_name;
        if (file.empty() && !files.empty()) file = files.size() == 1 ? files.front() : files[r];
        if (file.empty()) throw no_law(record);
        if (!read.contains(file)) read[file] = read_law(folder, file, subsystem_case.columns, bytes);
        record.law = read[file];
    }
    return bytes;
}

void read_laws_of_inputs(const Case& subsystem_case, const fs::path& folder, const std::vector<fs::path>& laws, Case& inputs) {
    std::map<std::string, LawCurve> known;
    for (const Record& record : subsystem_case.records) known[record.law.file] = record.law;
    const bool one_of_case = known.size() == 1;
    std::string ignored;
    for (const fs::path& law : laws)
        known[law.filename().string()] = read_law(folder, law.filename().string(), subsystem_case.columns, ignored);
    for (Record& record : inputs.records) {
        std::string file = named_by_word(record);
        if (!file.empty() && !known.contains(file))
            throw core::InvalidInput(record.file + ": law", "'" + file + "'", "a law file beside it");
        if (file.empty() && known.contains(law_name(record.file))) file = law_name(record.file);
        for (const Record& same : subsystem_case.records)
            if (file.empty() && same.file == record.file) file = same.law.file;
        if (file.empty() && laws.size() == 1) file = laws.front().filename().string();
        if (file.empty() && laws.empty() && one_of_case) file = subsystem_case.records.front().law.file;
        if (file.empty()) throw no_law(record);
        record.law = known.at(file);
    }
}

}  // namespace fusee::subsystem
