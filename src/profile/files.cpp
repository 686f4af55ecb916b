#include "files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "fusee/core/csv.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/profile/places.h"
#include "key.h"

namespace fusee::profile {

namespace {

/// Reads measured curves: columns angle_rad, series_Nm and parallel_Nm in any order, at least 8 rows whose angles all rise or all fall,
/// which are kept rising (core::parse_csv).
/// @param torque greatest one of the law that they are for [Nm]; 0: not known
/// @throws core::InvalidInput, of several core::InvalidInputs: "file:line:column: series_Nm" for a gap, a text, a NaN, an angle that
/// turns back, a number out of range (10^4 of either sign), too few rows, numbers that look like degrees or mNm
void read_table(std::string_view csv, const std::string& file, TablePair& table, const core::CsvMapping& mapping = {}, double torque = 0.0);

/// Reads the measured curve of a single spring: columns angle_rad and torque_Nm. @throws as read_table
void read_one_spring(std::string_view csv, const std::string& file, Rows& rows, const core::CsvMapping& mapping = {});

const std::vector<core::CsvColumn> kColumns{{"angle_rad"}, {"series_Nm"}, {"parallel_Nm"}}, kOneSpring{{"angle_rad"}, {"torque_Nm"}};
constexpr std::size_t kLeastRows = 8;                  // spring::make_tabulated needs as many
constexpr double kMostAngle = 1e4, kMostTorque = 1e4;  // as of the keys

/// Angles of more than two turns may be degrees, torques far above those of the law mNm.
void ask_about_units(const core::CsvTable& rows, const std::vector<core::CsvColumn>& columns, double torque) {
    constexpr double kTurns = 4.0 * core::kPi, kTimes = 50.0, kMostOfAny = 300.0;  // [rad], [1], [Nm]
    const auto greatest = [&rows](const char* column) {
        const std::vector<double>& all = rows.numbers(column);
        const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
        return static_cast<std::size_t>(std::max_element(all.begin(), all.end(), less) - all.begin());
    };
    if (const std::size_t row = greatest("angle_rad"); !rows.unit_is_told("angle_rad") && rows.numbers("angle_rad")[row] > kTurns)
        throw rows.question(row, "angle_rad", "deg", "more than two turns of a capstan");
    const double most = torque > 0.0 ? kTimes * torque : kMostOfAny;
    for (std::size_t i = 1; i < columns.size(); ++i)
        if (const char* column = columns[i].name.c_str();
            !rows.unit_is_told(column) && std::abs(rows.numbers(column)[greatest(column)]) > most)
            throw rows.question(greatest(column), column, "mNm",
                                torque > 0.0 ? fmt::format("the law ends at {:g} Nm", torque) : std::string("a large torque for a spring"));
}

/// Does the angle fall from the first row to the last?
bool is_falling(const core::CsvTable& rows) { return rows.numbers("angle_rad").back() < rows.numbers("angle_rad").front(); }

/// The angles rise in every row, or fall in every row.
void require_one_way(const core::CsvTable& rows) {
    const std::vector<double>& angle = rows.numbers("angle_rad");
    const bool falling = is_falling(rows);
    for (std::size_t i = 1; i < angle.size(); ++i)
        if (falling ? angle[i] >= angle[i - 1] : angle[i] <= angle[i - 1])
            throw rows.fault(i, "angle_rad", fmt::format("{:g}", angle[i]),
                             fmt::format("{} the row before, {:g}: one way alone, such as the loading branch, each angle once",
                                         falling ? "below" : "above", angle[i - 1]));
}

/// The rows of a measured law, the first column its angle. @throws as read_table
core::CsvTable read_law(std::string_view csv, const std::string& file, const std::vector<core::CsvColumn>& columns,
                        const core::CsvMapping& mapping, double torque) {
    core::CsvTable rows = core::parse_csv(csv, file, columns, {.least_rows = columns.size() == 2 ? 1 : kLeastRows, .mapping = mapping});
    if (rows.rows() < kLeastRows)
        throw core::InvalidInput(file, fmt::format("{} rows", rows.rows()),
                                 fmt::format("at least {}; law.kind = \"points\" goes through 4 or more points, \"polynomial\" is a "
                                             "line or parabola",
                                             kLeastRows));
    core::CsvFaults faults(file);
    for (std::size_t i = 0; i < rows.rows(); ++i) {
        for (const core::CsvColumn& column : columns) {
            const double most = column.name == "angle_rad" ? kMostAngle : kMostTorque;
            if (const double value = rows.numbers(column.name)[i]; std::abs(value) > most)
                faults.add(rows.fault(i, column.name, fmt::format("{:g}", value), fmt::format("{:g} to {:g}", -most, most)));
        }
    }
    faults.throw_if_any();
    require_one_way(rows);
    ask_about_units(rows, columns, torque);
    return rows;
}

/// A column in the order of rising angles.
std::vector<double> rising(const core::CsvTable& rows, const char* column) {
    std::vector<double> all = rows.numbers(column);
    if (is_falling(rows)) std::reverse(all.begin(), all.end());
    return all;
}

void read_table(std::string_view csv, const std::string& file, TablePair& table, const core::CsvMapping& mapping, double torque) {
    const core::CsvTable rows = read_law(csv, file, kColumns, mapping, torque);
    table.angle = rising(rows, "angle_rad");
    table.series = rising(rows, "series_Nm");
    table.parallel = rising(rows, "parallel_Nm");
}

void read_one_spring(std::string_view csv, const std::string& file, Rows& law, const core::CsvMapping& mapping) {
    const core::CsvTable rows = read_law(csv, file, kOneSpring, mapping, 0.0);
    law.x = rising(rows, "angle_rad");
    law.y = rising(rows, "torque_Nm");
}

constexpr double kMostLoad = 1e4, kMost = 1e6, kLeastPositive = 1e-9;  // as of the keys

// The kinds of tables below.
constexpr const char *kLoad = "load_Nm", *kTau = "tau_Nm";

/// Two columns of one kind of table.
struct Columns {
    std::string x, y;
    std::size_t least_rows = 1;
    bool positive = true;  ///< y > 0; else y >= 0
    double unit = 1.0;     ///< y in SI = unit * y
};

void read_rows(const std::string& csv, const std::string& file, const Columns& columns, const Profile& profile, Rows& rows) {
    const core::CsvTable table =
        core::parse_csv(csv, file, {{columns.x}, {columns.y}}, {.least_rows = columns.least_rows, .mapping = profile.columns});
    rows.x = table.numbers(columns.x);
    rows.y = table.numbers(columns.y);
    core::CsvFaults faults(file);
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double x = rows.x[i], y = rows.y[i];
        const auto refuse = [&](const std::string& column, double value, std::string allowed) {
            faults.add(table.fault(i, column, fmt::format("{:g}", value), std::move(allowed)));
        };
        if (x < 0.0 || x > kMostLoad) refuse(columns.x, x, fmt::format("0 to {:g}", kMostLoad));
        if (i > 0 && x <= rows.x[i - 1]) refuse(columns.x, x, fmt::format("above the row before, {:g}", rows.x[i - 1]));
        if (y > kMost || y < (columns.positive ? kLeastPositive : 0.0))
            refuse(columns.y, y,
                   columns.positive ? fmt::format("above 0, {:g} to {:g}", kLeastPositive, kMost)
                                    : fmt::format("at least 0, at most {:g}", kMost));
    }
    faults.throw_if_any();
    constexpr double kTimes = 50.0;  // the rig's torque: far beyond any use of the table
    if (const double most = kTimes * profile.rig.overdrive_torque; most > 0.0 && rows.x.back() > most && !table.unit_is_told(columns.x))
        throw table.question(table.rows() - 1, columns.x, "mNm", fmt::format("the rig has {:g} Nm at most", profile.rig.overdrive_torque));
    for (double& y : rows.y) y *= columns.unit;
}

/// Reads the profile's CSV files and keeps their bytes for its hash.
class Folder {
public:
    Folder(const Profile& profile, core::TomlFaults& faults) : profile_(profile), faults_(faults) {}

    /// Passes the bytes and the name of the file of `key` to `parse`, if it names one.
    template <class Parse>
    void read(const char* key, const fs::path& file, const Parse& parse) {
        if (file.empty()) return;
        const std::string path = (profile_.file.parent_path() / file).string();
        faults_.collect([&] {
            const std::string bytes = bytes_of(key, file, path);
            bytes_ += bytes;
            parse(bytes, path);
        });
    }
    void read(const char* key, Rows& rows, const Columns& columns) {
        read(key, rows.file, [&](const std::string& bytes, const std::string& path) { read_rows(bytes, path, columns, profile_, rows); });
    }
    [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

private:
    [[nodiscard]] std::string bytes_of(const char* key, const fs::path& file, const std::string& path) const {
        try {
            return core::read_file(path, kLargestFile);
        } catch (const core::IoError& e) {
            throw core::InvalidInput(profile_.place_of(key), core::quoted(file.string()), fmt::format("a readable file; {}", e.what()));
        }
    }

    const Profile& profile_;
    core::TomlFaults& faults_;
    std::string bytes_;
};

}  // namespace

void read_columns(const toml::node& node, core::TomlFaults& faults, core::CsvMapping& columns) {
    std::vector<std::string> known{"angle_rad",   "torque_Nm", "series_Nm",     "parallel_Nm",          kLoad,
                                   "friction_Nm", kTau,        "dead_band_deg", "stiffness_Nm_per_rad", "width_deg"};
    for (const core::CsvColumn& column : spring::catalogue_columns()) known.push_back(column.name);
    if (!node.is_table()) return faults.add(node.source(), "columns", "no table", "a table [columns] with NAME = \"HEADER in the file\"");
    for (const auto& [key, value] : *node.as_table()) {
        const std::string name(key.str()), path = "columns." + name;
        if (name != "decimal" && std::find(known.begin(), known.end(), name) == known.end())
            faults.add(key.source(), path, "unknown key", fmt::format("decimal, {}", fmt::join(known, ", ")));
        else if (const auto* header = value.as_string(); header == nullptr || header->get().empty())
            faults.add(value.source(), path, "no text", "the header of the column in the file, \"Winkel\" or \"Winkel in deg\"");
        else
            faults.collect([&] { columns.add(name, header->get(), core::toml_place(faults.file(), value.source(), path)); });
    }
}

std::string columns_toml(const core::CsvMapping& columns) {
    std::string toml;
    if (columns.decimal != 0) toml += fmt::format("decimal = \"{}\"\n", columns.decimal);
    for (const auto& [name, header] : columns.columns) toml += fmt::format("{} = {}\n", name, core::quoted(header));
    return toml.empty() ? "" : "\n[columns]\n" + toml;
}

std::string columns_reference() {
    return "### `[columns]`\n\n"
           "| key | allowed | default | meaning |\n|---|---|---|---|\n"
           "| a column of a CSV file that the profile names | its header in the file, or the header and a unit: `\"Winkel in deg\"` | as "
           "the file "
           "shows | for a header or unit that is not recognised ([tables](tables.md)) |\n"
           "| `decimal` | `\",\"` or `\".\"` | as the file shows | decimal mark of the numbers |\n\n";
}

std::string read_files(Profile& profile, core::TomlFaults& faults) {
    constexpr double kDegree = core::rad_from_deg(1.0);
    constexpr std::size_t kCurve = 4;  // math::make_interpolant needs as many
    Folder folder(profile, faults);
    folder.read("rig.gear_friction_table", profile.rig.gear_friction_table, {kLoad, "friction_Nm", 2, false});
    if (auto* table = std::get_if<TablePair>(&profile.law.curves))
        folder.read("law.file", table->file, [table, &profile](const auto& bytes, const std::string& path) {
            read_table(bytes, path, *table, profile.columns, profile.law.end_torque);
        });
    if (auto* one = std::get_if<OneSpring>(&profile.law.curves))
        folder.read("law.file", one->rows.file, [one, &profile](const auto& bytes, const std::string& path) {
            read_one_spring(bytes, path, one->rows, profile.columns);
        });
    if (auto* wanted = std::get_if<DeadBandSpec>(&profile.law.curves)) {
        folder.read("law.dead_band_file", wanted->dead_band.rows, {kTau, "dead_band_deg", kCurve, true, kDegree});
        folder.read("law.series_stiffness_file", wanted->series_stiffness.rows, {kTau, "stiffness_Nm_per_rad", kCurve});
    }
    design::CoDesignOptions& co_design = profile.co_design;
    folder.read("co_design.catalogue", co_design.catalogue_file, [&](const auto& bytes, const std::string& path) {
        co_design.catalogue = spring::parse_catalogue(bytes, path, profile.columns);
    });
    folder.read("simulate.measured", profile.simulate.measured, {kTau, "width_deg", 1, false, kDegree});
    return std::move(folder).bytes();
}

TablePair read_measured_law(const std::filesystem::path& file, const core::CsvMapping& mapping) {
    TablePair table;
    table.file = file;
    read_table(core::read_file(file, kLargestFile), file.string(), table, mapping);
    return table;
}

std::vector<fs::path> find_profiles(const std::vector<fs::path>& paths) {
    std::vector<fs::path> found;
    for (const fs::path& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            found.push_back(path);  // also one that does not exist: reading it says so
            continue;
        }
        error.clear();
        std::vector<fs::path> inside;
        for (auto entry = fs::directory_iterator(path, error); !error && entry != fs::directory_iterator(); entry.increment(error))
            if (entry->path().extension() == ".toml" && !fs::is_directory(entry->path())) inside.push_back(entry->path());
        if (error) throw core::IoError(path.string(), error.message());
        if (inside.empty()) throw core::IoError(path.string(), "holds no profile (*.toml)");
        std::sort(inside.begin(), inside.end());
        found.insert(found.end(), inside.begin(), inside.end());
    }
    return found;
}

}  // namespace fusee::profile
