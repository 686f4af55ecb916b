#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "columns.h"
#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/gap_case/toml.h"

namespace fs = std::filesystem;

namespace fusee::subsystem {

std::size_t Record::rows() const { return texts.empty() ? columns.at("t_s").size() : texts.begin()->second.size(); }

namespace {

constexpr std::size_t kLargestFile = 200'000'000;  // bytes
constexpr const char* kKindKeys[] = {"kind", "type", "name"};

const KindKeys& kind_of(const gap_case::CaseToml& toml) {
    std::vector<std::string> names;
    for (const KindKeys& keys : all_keys()) names.push_back(keys.name);
    for (const char* key : kKindKeys) {
        const std::string path = std::string("bench.") + key;
        if (!toml.has(path)) continue;
        const std::string name = toml.text(path, fmt::format("{}", fmt::join(names, ", ")));
        for (const KindKeys& keys : all_keys())
            if (name == keys.name) return keys;
        throw toml.fault(path, "\"" + name + "\"", fmt::format("{}", fmt::join(names, ", ")));
    }
    throw toml.fault("bench.kind", "missing", fmt::format("{}", fmt::join(names, ", ")));
}

std::map<std::string, double> numbers_of(const gap_case::CaseToml& toml, const std::string& table, const std::vector<ParameterKey>& known,
                                         const std::vector<std::string>& others) {
    std::vector<double> values(known.size());
    std::vector<gap_case::NumberKey> keys;
    for (std::size_t i = 0; i < known.size(); ++i)
        keys.push_back({known[i].name, known[i].low, known[i].high, known[i].unit, &values[i], "", known[i].other});
    (void)toml.read_numbers(table, keys, others);
    std::map<std::string, double> numbers;
    for (std::size_t i = 0; i < known.size(); ++i)
        if (toml.has(table + "." + known[i].name)) numbers[known[i].name] = values[i];
    return numbers;
}

std::string allowed_text(double low, double high, const char* unit, const char* other) {
    return fmt::format("{:g} to {:g}{}{}{}{}{}", low, high, *unit == '\0' ? "" : " ", unit, *other == '\0' ? "" : "; is it in ", other,
                       *other == '\0' ? "" : "?");
}

/// @param fault makes the error to throw from what is allowed
template <class Fault>
void check_word(const KindKeys& keys, const std::string& key, const std::string& text, const Fault& fault) {
    for (const WordKey& known : keys.words)
        if (key == known.name && !known.allowed.empty() &&
            std::find(known.allowed.begin(), known.allowed.end(), text) == known.allowed.end())
            throw fault(fmt::format("{}", fmt::join(known.allowed, ", ")));
}

/// The texts of [bench] that the kind knows.
std::map<std::string, std::string> words_of(const gap_case::CaseToml& toml, const KindKeys& keys) {
    std::map<std::string, std::string> words;
    for (const WordKey& known : keys.words) {
        const std::string path = std::string("bench.") + known.name;
        if (!toml.has(path)) continue;
        words[known.name] = toml.text(path, known.allowed.empty() ? "a text" : fmt::format("{}", fmt::join(known.allowed, ", ")));
        check_word(keys, known.name, words[known.name],
                   [&](const std::string& allowed) { return toml.fault(path, '"' + words[known.name] + '"', allowed); });
    }
    return words;
}

/// The table [columns]: a column's header in the files, "pos" or "pos in deg".
core::CsvMapping columns_of(const gap_case::CaseToml& toml, const KindKeys& keys) {
    core::CsvMapping columns;
    columns.table = "columns";
    if (!toml.has("columns")) return columns;
    std::vector<std::string> names{"decimal"};
    for (const ColumnKey& key : keys.columns) names.emplace_back(key.name);
    (void)toml.read_numbers("columns", {}, names);
    for (const std::string& name : toml.keys_of("columns"))
        columns.add(name, toml.text("columns." + name, "the column's header in the file, or the header and a unit"), "columns." + name);
    return columns;
}

/// A word key=value of a '#' line: a known parameter within its range, or any other word.
void add_word(std::string_view word, const KindKeys& keys, const std::string& place, Record& record) {
    while (!word.empty() && (word.back() == ',' || word.back() == ';')) word.remove_suffix(1);
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == word.size()) return;
    const std::string key(word.substr(0, equals)), text(word.substr(equals + 1));
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc{} && end == text.data() + text.size();
    for (const ParameterKey& known : keys.parameters) {
        if (key != known.name) continue;
        if (!number || !(value >= known.low && value <= known.high))
            throw core::InvalidInput(place + key, "'" + text + "'", allowed_text(known.low, known.high, known.unit, known.other));
        record.parameters[key] = value;
        return;
    }
    check_word(keys, key, text, [&](const std::string& allowed) { return core::InvalidInput(place + key, "'" + text + "'", allowed); });
    record.words[key] = text;
}

/// The '#' lines above the header.
void add_words(std::string_view csv, const KindKeys& keys, const std::string& file, Record& record) {
    for (std::size_t line = 1; csv.starts_with('#'); ++line) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        std::string_view text = csv.substr(0, end);
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t begin = text.find_first_not_of(" \t\r#", at);
            if (begin == std::string_view::npos) break;
            at = std::min(text.find_first_of(" \t\r", begin), text.size());
            add_word(text.substr(begin, at - begin), keys, fmt::format("{}:{}:{}: ", file, line, begin + 1), record);
        }
        csv.remove_prefix(std::min(end + 1, csv.size()));
    }
}

void add_column(const core::CsvTable& table, const ColumnKey& key, Record& record) {
    if (!table.has(key.name)) return;
    if (key.text) {
        record.texts[key.name] = table.texts(key.name);
        return;
    }
    const std::vector<double>& numbers = table.numbers(key.name);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] < key.low || numbers[i] > key.high)
            throw table.fault(i, key.name, fmt::format("{:g}", numbers[i]), allowed_text(key.low, key.high, "", key.other));
        if (i > 0 && std::string_view(key.name) == "t_s" && !(numbers[i] > numbers[i - 1]))
            throw table.fault(i, key.name, fmt::format("{:g}", numbers[i]), "a time after the row before");
    }
    record.columns[key.name] = numbers;
}

void require_directions(const core::CsvTable& table, const Record& record) {
    if (!record.texts.contains("direction")) return;
    const auto& directions = record.texts.at("direction");
    for (std::size_t i = 0; i < directions.size(); ++i)
        if (directions[i] != "drive" && directions[i] != "backdrive")
            throw table.fault(i, "direction", "'" + directions[i] + "'", "drive or backdrive");
}

/// Adds the file's words and columns to `record`. @returns its bytes
std::string add_file(const fs::path& path, const KindKeys& keys, const core::CsvMapping& mapping, bool inputs_only, Record& record) {
    std::string bytes = core::read_file(path, kLargestFile);
    const std::size_t mark = bytes.starts_with(core::kByteOrderMark) ? core::kByteOrderMark.size() : 0;
    add_words(std::string_view(bytes).substr(mark), keys, path.string(), record);
    std::vector<core::CsvColumn> columns;
    for (const ColumnKey& key : keys.columns)
        columns.push_back({key.name, key.text ? core::CsvColumn::Kind::kText : core::CsvColumn::Kind::kNumber,
                           key.required && !(inputs_only && key.measured)});
    const core::CsvTable table = core::parse_csv(bytes, path.string(), columns, {.mapping = mapping});
    for (const ColumnKey& key : keys.columns) add_column(table, key, record);
    require_directions(table, record);
    return bytes;
}

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

/// True for a CSV file with the columns of a law and no time. @throws core::IoError
bool is_law_file(const fs::path& file, const core::CsvMapping& columns) {
    const std::string bytes = core::read_file(file, kLargestFile);
    return core::csv_fits(bytes, {{"q_rad"}, {"torque_Nm"}}, columns) && !core::csv_fits(bytes, {{"t_s"}}, columns);
}

/// @param bytes gets the file's bytes at its end
/// @throws core::InvalidInput "file:line:column: q_rad" if angles do not ascend; core::IoError
LawCurve read_law(const fs::path& folder, const std::string& file, const core::CsvMapping& columns, std::string& bytes) {
    constexpr double kOneTurn = 2.0 * core::kPi, kMostOfALaw = 1e6;  // one turn; beyond them, the column is in another unit
    const std::string text = core::read_file(folder / file, kLargestFile);
    const core::CsvTable table =
        core::parse_csv(text, (folder / file).string(), {{"q_rad"}, {"torque_Nm"}}, {.least_rows = 2, .mapping = columns});
    LawCurve law{file, table.numbers("q_rad"), table.numbers("torque_Nm")};
    for (std::size_t i = 0; i < law.q_rad.size(); ++i) {
        if (std::abs(law.q_rad[i]) > kOneTurn && !table.unit_is_told("q_rad")) throw table.question(i, "q_rad", "deg", "one turn at most");
        if (std::abs(law.torque_Nm[i]) > kMostOfALaw)
            throw table.fault(i, "torque_Nm", fmt::format("{:g}", law.torque_Nm[i]), "-1e+06 to 1e+06 Nm");
        if (i > 0 && !(law.q_rad[i] > law.q_rad[i - 1]))
            throw table.fault(i, "q_rad", fmt::format("{:g}", law.q_rad[i]), "an angle above that of the row before");
    }
    bytes += text;
    return law;
}

/// Gives each record of a case its law: the file of its word `law=FILE`; law_X.csv for pull_X.csv; the file of experiments.law at the same
/// place, or its only one. @returns the bytes of the files. @throws core::InvalidInput naming the record that has none
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

/// The same for inputs, from the law files of their folder, then from those of the case. @throws as read_laws
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

}  // namespace

Case read_case(const fs::path& folder) {
    const gap_case::CaseToml toml(folder);
    toml.allow_tables({"bench", "sensors", "experiments", "columns", "tolerance", "protocol"});
    const KindKeys& keys = kind_of(toml);
    Case subsystem_case;
    subsystem_case.name = fs::absolute(folder / "").parent_path().filename().string();
    subsystem_case.kind = keys.kind;
    std::vector<std::string> texts{std::begin(kKindKeys), std::end(kKindKeys)};
    for (const WordKey& word : keys.words) texts.emplace_back(word.name);
    subsystem_case.parameters = numbers_of(toml, "bench", keys.parameters, texts);
    subsystem_case.words = words_of(toml, keys);
    subsystem_case.sensors = numbers_of(toml, "sensors", keys.sensors, {});
    subsystem_case.columns = columns_of(toml, keys);
    for (const char* table : {"tolerance", "protocol"})
        if (toml.has(table)) subsystem_case.remarks.push_back(fmt::format("[{}] is not used by a subsystem case", table));
    for (const std::string& key : toml.keys_of("experiments"))
        if (key != keys.experiment && !(keys.laws && key == "law"))
            throw toml.fault("experiments." + key, "unknown key", std::string(keys.experiment) + (keys.laws ? ", law" : ""));
    std::string all = toml.bytes();
    for (const std::string& file : toml.files(std::string("experiments.") + keys.experiment)) {
        Record record{keys.experiment, file, subsystem_case.parameters, subsystem_case.words, {}, {}};
        all += add_file(folder / file, keys, subsystem_case.columns, false, record);
        subsystem_case.records.push_back(std::move(record));
    }
    if (keys.laws) all += read_laws(toml, folder, subsystem_case);
    subsystem_case.sha256 = core::sha256_hex(all);
    std::sort(subsystem_case.records.begin(), subsystem_case.records.end(),
              [](const Record& a, const Record& b) { return a.file < b.file; });  // no answer depends on the order in case.toml
    ask_units(subsystem_case, folder);
    return subsystem_case;
}

Case read_inputs(const Case& subsystem_case, const fs::path& folder) {
    if (!fs::is_directory(folder)) throw core::IoError(folder.string(), "is no folder");
    const KindKeys& keys = keys_of(subsystem_case.kind);
    std::vector<fs::path> files, laws;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (!entry.is_regular_file() || entry.path().extension() != ".csv") continue;
        (keys.laws && is_law_file(entry.path(), subsystem_case.columns) ? laws : files).push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    Case inputs = subsystem_case;
    inputs.records.clear();
    for (const fs::path& file : files) {
        Record record{keys.experiment, file.filename().string(), subsystem_case.parameters, subsystem_case.words, {}, {}};
        for (const Record& known : subsystem_case.records)
            if (known.file == record.file) record.parameters = known.parameters, record.words = known.words;
        (void)add_file(file, keys, subsystem_case.columns, true, record);
        inputs.records.push_back(std::move(record));
    }
    if (inputs.records.empty()) throw core::IoError(folder.string(), fmt::format("no CSV file of a {} in this folder", keys.experiment));
    if (keys.laws) read_laws_of_inputs(subsystem_case, folder, laws, inputs);
    ask_units(inputs, folder);
    return inputs;
}

void write_rows(const Case& rows, const fs::path& folder) {
    for (const Record& record : rows.records) {
        std::vector<std::string> names;
        for (const ColumnKey& key : keys_of(rows.kind).columns)
            if (record.columns.contains(key.name) || record.texts.contains(key.name)) names.push_back(key.name);
        std::string out = fmt::format("{}\n", fmt::join(names, ","));
        for (std::size_t i = 0; i < record.rows(); ++i)
            for (std::size_t c = 0; c < names.size(); ++c)
                out += (record.texts.contains(names[c]) ? record.texts.at(names[c])[i]
                                                        : fmt::format("{:.9g}", record.columns.at(names[c])[i])) +
                       (c + 1 == names.size() ? "\n" : ",");
        core::make_folder((folder / record.file).parent_path());
        core::write_file(folder / record.file, out);
    }
}

}  // namespace fusee::subsystem
