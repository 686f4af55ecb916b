#include "files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "csv.h"
#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "key.h"

namespace fs = std::filesystem;

namespace fusee::profile {

namespace {

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
            throw core::InvalidInput(profile_.place_of(key), quoted(file.string()), fmt::format("a readable file; {}", e.what()));
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
    for (const auto& [name, header] : columns.columns) toml += fmt::format("{} = {}\n", name, quoted(header));
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

}  // namespace fusee::profile
