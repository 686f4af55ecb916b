#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "fusee/core/csv.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/toml.h"
#include "fusee/profile/profile.h"
#include "fusee/study/study.h"
#include "sample.h"

namespace fusee::study {

namespace {

constexpr std::size_t kLargestStudy = 10'000'000;  // bytes
constexpr std::array<const char*, 5> kMethods{"grid", "random", "latin_hypercube", "sobol", "csv"};
constexpr std::array<const char*, 3> kOutputs{"figures", "meshes", "all"};

/// The text of a value, for a list of texts, numbers and switches.
std::string toml_text(const toml::node& node) {
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
    return core::shown(node);
}

/// Reads one table of the file and refuses what it does not know.
class Reader {
public:
    explicit Reader(core::TomlFaults& faults) : faults_(faults) {}

    void refuse(const toml::source_region& at, const std::string& key, std::string value, std::string allowed) const {
        faults_.add(at, key, std::move(value), std::move(allowed));
    }
    void refuse(const toml::node& node, const std::string& key, std::string allowed) const {
        refuse(node.source(), key, core::shown(node), std::move(allowed));
    }
    void allow(const toml::table& table, const std::string& path, const std::set<std::string>& known) const {
        for (const auto& [name, node] : table)
            if (!known.contains(std::string(name.str())))
                refuse(name.source(), path + std::string(name.str()), "unknown", core::listed(known));
    }
    void text(const toml::table& table, const std::string& name, std::string& to) const {
        const toml::node* node = table.get(name);
        if (node == nullptr) return;
        if (const auto value = node->value_exact<std::string>(); value && !value->empty())
            to = *value;
        else
            refuse(*node, name, "a text");
    }
    template <std::size_t N>
    std::size_t choice(const toml::table& table, const std::string& name, const std::array<const char*, N>& names,
                       std::size_t otherwise) const {
        std::string chosen = names[otherwise];
        text(table, name, chosen);
        const auto found = std::find(names.begin(), names.end(), chosen);
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
        refuse(*table.get(name), name, core::listed(names, core::quoted));
        return otherwise;
    }
    double number(const toml::table& table, const std::string& name, double low, double high, bool whole, double otherwise) const {
        const toml::node* node = table.get(name);
        if (node == nullptr) return otherwise;
        const auto value = node->is_number() ? node->value<double>() : std::nullopt;
        if (value && std::isfinite(*value) && *value >= low && *value <= high && (!whole || node->is_integer())) return *value;
        refuse(*node, name, fmt::format("a {}number, {:g} to {:g}", whole ? "whole " : "", low, high));
        return otherwise;
    }
    [[nodiscard]] const toml::table* table(const toml::table& in, const std::string& name) const {
        const toml::node* node = in.get(name);
        if (node == nullptr) return nullptr;
        if (!node->is_table()) refuse(*node, name, "a table");
        return node->as_table();
    }

private:
    core::TomlFaults& faults_;
};

/// "0.8" is whole? A range of integers between integers varies in whole numbers.
bool is_whole(const toml::table& range) { return range["from"].is_integer() && range["to"].is_integer(); }

Variation read_range(const Reader& reader, const std::string& key, const toml::table& range) {
    constexpr double kAny = std::numeric_limits<double>::max();
    reader.allow(range, "vary." + key + ".", {"from", "to", "steps", "scale"});
    Variation v;
    v.key = key;
    for (const char* end : {"from", "to"})
        if (range.get(end) == nullptr) reader.refuse(range.source(), "vary." + key + "." + end, "is missing", "a number in the key's unit");
    v.from = reader.number(range, "from", -kAny, kAny, false, 0.0);
    v.to = reader.number(range, "to", -kAny, kAny, false, 0.0);
    v.steps = static_cast<std::size_t>(reader.number(range, "steps", 1.0, 1e6, true, 0.0));
    v.whole = is_whole(range) && range.get("steps") == nullptr;
    v.logarithmic = reader.choice(range, "scale", std::array{"linear", "logarithmic"}, 0) == 1;
    if (v.logarithmic && !(v.from > 0.0 && v.to > 0.0)) reader.refuse(range, "vary." + key, "ends above 0 for a logarithmic scale");
    if (v.whole) v.steps = static_cast<std::size_t>(std::abs(v.to - v.from)) + 1;
    return v;
}

Variation read_list(const Reader& reader, const std::string& key, const toml::array& list) {
    Variation v;
    v.key = key;
    for (const toml::node& value : list) {
        if (!value.is_value()) reader.refuse(value, "vary." + key, "numbers, texts, true or false");
        v.values.push_back(toml_text(value));
    }
    if (v.values.empty()) reader.refuse(list, "vary." + key, "at least one value");
    return v;
}

struct Placed {
    toml::source_position at;
    Variation variation;
};

/// "cable.diameter_mm" = ... and the tables that TOML makes of cable.diameter_mm = ...
void read_variations(const Reader& reader, const std::string& prefix, const toml::table& table, std::vector<Placed>& to) {
    for (const auto& [name, node] : table) {
        const std::string key = prefix + std::string(name.str());
        const toml::source_position at = name.source().begin;
        if (const toml::array* list = node.as_array())
            to.push_back({at, read_list(reader, key, *list)});
        else if (const toml::table* inner = node.as_table(); inner != nullptr && (inner->contains("from") || inner->contains("to")))
            to.push_back({at, read_range(reader, key, *inner)});
        else if (inner != nullptr)
            read_variations(reader, key + ".", *inner, to);
        else
            reader.refuse(node, "vary." + key, "a list of values, or {from = ..., to = ..., steps = ..., scale = \"linear\"}");
    }
}

/// toml++ sorts its tables by name; the first key of the file changes slowest in a grid.
std::vector<Variation> in_file_order(std::vector<Placed> all) {
    std::sort(all.begin(), all.end(),
              [](const Placed& a, const Placed& b) { return std::tie(a.at.line, a.at.column) < std::tie(b.at.line, b.at.column); });
    std::vector<Variation> ordered;
    for (Placed& one : all) ordered.push_back(std::move(one.variation));
    return ordered;
}

void read_constraints(const Reader& reader, const toml::table& table, Study& study) {
    for (const auto& [name, node] : table) {
        Constraint constraint{std::string(name.str()), {}};
        reader.text(table, constraint.name, constraint.formula);
        study.constraints.push_back(std::move(constraint));
    }
}

void read_torques(const Reader& reader, const toml::table& table, std::vector<double>& to) {
    const toml::node* node = table.get("dead_band_torques_Nm");
    if (node == nullptr) return;
    if (const toml::array* list = node->as_array())
        for (const toml::node& one : *list) {
            const auto value = one.is_number() ? one.value<double>() : std::nullopt;
            if (value && *value > 0.0 && std::isfinite(*value))
                to.push_back(*value);
            else
                reader.refuse(one, "study.dead_band_torques_Nm", "co-contractions above 0 Nm");
        }
    else
        reader.refuse(*node, "study.dead_band_torques_Nm", "a list of co-contractions [Nm]");
}

/// The columns of the table are keys; a column "name" names the designs.
void read_rows(const fs::path& table, Study& study) {
    const std::string text = core::read_file(table, kLargestStudy);
    std::vector<core::CsvColumn> columns;
    for (const std::string& name : core::csv_header(text)) {
        columns.push_back({name, core::CsvColumn::Kind::kText});
        if (name != "name") study.vary.emplace_back().key = name;
    }
    const core::CsvTable read = core::parse_csv(text, table.string(), columns, {.most_rows = kMostDesigns});
    if (read.has("name")) study.row_names = read.texts("name");
    for (std::size_t row = 0; row < read.rows(); ++row) {
        std::vector<std::string>& values = study.rows.emplace_back();
        for (const Variation& v : study.vary) {
            const std::string& cell = read.texts(v.key)[row];
            const bool bare = cell.find_first_not_of("+-.0123456789eE") == std::string::npos || cell == "true" || cell == "false";
            values.push_back(bare ? cell : '"' + cell + '"');
        }
    }
}

void check_method(const Reader& reader, const toml::table& table, const Study& study) {
    const bool sampled = study.method == Method::kRandom || study.method == Method::kLatinHypercube || study.method == Method::kSobol;
    if (sampled && study.count == 0) reader.refuse(table.source(), "study.count", "is missing", "the number of designs, with this method");
    if (!sampled && study.count > 0)
        reader.refuse(table.source(), "study.count", "has no meaning", "only with random, latin_hypercube or sobol");
    if (study.method == Method::kSobol && study.vary.size() > kMostSobolKeys)
        reader.refuse(table.source(), "study.method", "sobol", fmt::format("at most {} keys", kMostSobolKeys));
    if (study.method != Method::kCsv && study.vary.empty())
        reader.refuse(table.source(), "vary", "is missing", "at least one key that varies");
    double designs = 1.0;
    for (const Variation& v : study.vary) {
        if (study.method != Method::kGrid) break;
        if (v.values.empty() && v.steps == 0) reader.refuse(table.source(), "vary." + v.key, "no steps", "a list, or steps, in a grid");
        designs *= static_cast<double>(std::max<std::size_t>(v.values.empty() ? v.steps : v.values.size(), 1));
    }
    if (designs > static_cast<double>(kMostDesigns))
        reader.refuse(table.source(), "vary", fmt::format("{:g} designs", designs), fmt::format("at most {} designs", kMostDesigns));
}

void read_study_table(const Reader& reader, const toml::table& table, const fs::path& file, Study& study) {
    reader.allow(table, "study.", {"name", "base", "method", "count", "seed", "outputs", "dead_band_torques_Nm", "table"});
    reader.text(table, "name", study.name);
    std::string base, rows;
    reader.text(table, "base", base);
    reader.text(table, "table", rows);
    if (base.empty()) reader.refuse(table.source(), "study.base", "is missing", "the base profile, relative to this file");
    study.profiles = {file.parent_path() / base};
    study.method = static_cast<Method>(reader.choice(table, "method", kMethods, 0));
    study.outputs = static_cast<Outputs>(reader.choice(table, "outputs", kOutputs, 2));
    study.count = static_cast<std::size_t>(reader.number(table, "count", 1.0, static_cast<double>(kMostDesigns), true, 0.0));
    study.seed = static_cast<std::uint64_t>(reader.number(table, "seed", 0.0, 9e15, true, 1.0));
    read_torques(reader, table, study.torques);
    if ((study.method == Method::kCsv) != !rows.empty())
        reader.refuse(table.source(), "study.table", rows.empty() ? "is missing" : "has no meaning", "the CSV file, with method = \"csv\"");
    else if (!rows.empty())
        read_rows(file.parent_path() / rows, study);
}

void require_names(const Study& study) {
    if (!profile::is_name(study.name)) throw core::InvalidInput(study.file.string() + ": study.name", study.name, profile::kAllowedName);
    std::set<std::string> seen;
    for (const std::string& name : study.row_names)
        if (!profile::is_name(name) || !seen.insert(name).second)
            throw core::InvalidInput(study.file.string() + ": study.table: name", name,
                                     std::string(profile::kAllowedName) + "; each name once");
}

/// The name of a profile's file as a design's name: "my cam.toml" is my_cam.
std::string design_name(const fs::path& profile) {
    std::string name = profile.stem().string().substr(0, profile::kLongestName);
    for (char& c : name)
        if (!profile::is_name("a" + std::string(1, c))) c = '_';
    return profile::is_name(name) ? name : "design" + name.substr(0, profile::kLongestName - 6);
}

}  // namespace

const char* to_string(Outputs outputs) { return kOutputs.at(static_cast<std::size_t>(outputs)); }

bool is_study(const fs::path& file) { return core::parse_toml(core::read_file(file, kLargestStudy), file.string()).contains("study"); }

Study read_study(const fs::path& file) {
    const toml::table root = core::parse_toml(core::read_file(file, kLargestStudy), file.string());
    core::TomlFaults faults(file.string());
    const Reader reader(faults);
    Study study;
    study.file = file;
    study.name = file.stem().string();
    reader.allow(root, "", {"study", "vary", "constraints"});
    const toml::table empty;
    const toml::table* table = reader.table(root, "study");
    faults.collect([&] { read_study_table(reader, table != nullptr ? *table : empty, file, study); });
    if (const toml::table* vary = reader.table(root, "vary")) {
        std::vector<Placed> placed;
        read_variations(reader, "", *vary, placed);
        if (study.method == Method::kCsv)
            reader.refuse(*vary, "vary", "no table [vary] with method = \"csv\": its columns are the keys");
        else
            study.vary = in_file_order(std::move(placed));
    }
    if (const toml::table* constraints = reader.table(root, "constraints")) read_constraints(reader, *constraints, study);
    if (faults.count() == 0) check_method(reader, table != nullptr ? *table : empty, study);
    faults.throw_if_any();
    require_names(study);
    return study;
}

Study study_of(std::vector<fs::path> profiles, std::string name) {
    if (profiles.empty()) throw core::InvalidInput("batch", "no profile", "a study (*.toml with [study]), profiles, or folders of them");
    if (!profile::is_name(name)) throw core::InvalidInput("--name", name, profile::kAllowedName);
    Study study;
    study.name = std::move(name);
    std::map<std::string, const fs::path*> seen;
    for (const fs::path& profile : profiles) {
        study.row_names.push_back(design_name(profile));
        if (const auto [other, is_new] = seen.emplace(study.row_names.back(), &profile); !is_new)
            throw core::InvalidInput("batch",
                                     fmt::format("{} and {}", core::printable(other->second->string()), core::printable(profile.string())),
                                     "profiles whose files have different names: each gets the folder designs/NAME");
    }
    study.profiles = std::move(profiles);
    return study;
}

}  // namespace fusee::study
