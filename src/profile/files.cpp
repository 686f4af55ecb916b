#include "files.h"

#include <fmt/format.h>

#include "csv.h"
#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "key.h"

namespace fs = std::filesystem;

namespace fusee::profile {

namespace {

constexpr double kMostLoad = 1e4, kMost = 1e6, kLeastPositive = 1e-9;  // as of the keys

/// Two columns of one kind of table.
struct Columns {
    std::string x, y;
    std::size_t least_rows = 1;
    bool positive = true;  ///< y > 0; else y >= 0
    double unit = 1.0;     ///< y in SI = unit * y
};

void read_rows(const std::string& csv, const std::string& file, const Columns& columns, Rows& rows) {
    const core::CsvTable table =
        core::parse_csv(csv, file, {{columns.x}, {columns.y}}, {.extra_columns = true, .least_rows = columns.least_rows});
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
        read(key, rows.file, [&](const std::string& bytes, const std::string& path) { read_rows(bytes, path, columns, rows); });
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

std::string read_files(Profile& profile, core::TomlFaults& faults) {
    constexpr double kDegree = core::rad_from_deg(1.0);
    constexpr std::size_t kCurve = 4;  // math::make_interpolant needs as many
    Folder folder(profile, faults);
    folder.read("rig.gear_friction_table", profile.rig.gear_friction_table, {"load_Nm", "friction_Nm", 2, false});
    if (auto* table = std::get_if<TablePair>(&profile.law.curves))
        folder.read("law.file", table->file, [table](const auto& bytes, const std::string& path) { read_table(bytes, path, *table); });
    if (auto* wanted = std::get_if<DeadBandSpec>(&profile.law.curves)) {
        folder.read("law.dead_band_file", wanted->dead_band.rows, {"tau_Nm", "dead_band_deg", kCurve, true, kDegree});
        folder.read("law.series_stiffness_file", wanted->series_stiffness.rows, {"tau_Nm", "stiffness_Nm_per_rad", kCurve});
    }
    design::CoDesignOptions& co_design = profile.co_design;
    folder.read("co_design.catalogue", co_design.catalogue_file,
                [&](const auto& bytes, const std::string& path) { co_design.catalogue = spring::parse_catalogue(bytes, path); });
    folder.read("simulate.measured", profile.simulate.measured, {"tau_Nm", "width_deg", 1, false, kDegree});
    return std::move(folder).bytes();
}

}  // namespace fusee::profile
