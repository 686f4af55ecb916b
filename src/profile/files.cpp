#include "files.h"

#include <fmt/format.h>

#include "csv.h"
#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"

namespace fs = std::filesystem;

namespace fusee::profile {

namespace {

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
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double x = rows.x[i], y = rows.y[i];
        if (x < 0.0) throw table.fault(i, columns.x, fmt::format("{:g}", x), "at least 0");
        if (i > 0 && x <= rows.x[i - 1])
            throw table.fault(i, columns.x, fmt::format("{:g}", x), fmt::format("above the row before, {:g}", rows.x[i - 1]));
        if (y < 0.0 || (columns.positive && y == 0.0))
            throw table.fault(i, columns.y, fmt::format("{:g}", y), columns.positive ? "above 0" : "at least 0");
        rows.y[i] = columns.unit * y;
    }
}

/// Reads files beside the profile and keeps their bytes for its hash.
class Folder {
public:
    explicit Folder(const fs::path& profile) : folder_(profile.parent_path()) {}

    void read(Rows& rows, const Columns& columns) {
        if (rows.file.empty()) return;
        const std::string path = (folder_ / rows.file).string();
        read_rows(bytes_of(path), path, columns, rows);
    }
    void read(TablePair& table) {
        const std::string path = (folder_ / table.file).string();
        read_table(bytes_of(path), path, table);
    }
    void read(design::CoDesignOptions& co_design) {
        if (co_design.catalogue_file.empty()) return;
        const std::string path = (folder_ / co_design.catalogue_file).string();
        co_design.catalogue = spring::parse_catalogue(bytes_of(path), path);
    }
    [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

private:
    std::string bytes_of(const std::string& path) {
        const std::string bytes = core::read_file(path, kLargestFile);
        bytes_ += bytes;
        return bytes;
    }

    fs::path folder_;
    std::string bytes_;
};

}  // namespace

std::string read_files(Profile& profile) {
    constexpr double kDegree = core::rad_from_deg(1.0);
    constexpr std::size_t kCurve = 4;  // math::make_interpolant needs as many
    Folder folder(profile.file);
    folder.read(profile.rig.gear_friction_table, {"load_Nm", "friction_Nm", 2, false});
    if (auto* table = std::get_if<TablePair>(&profile.law.curves)) folder.read(*table);
    if (auto* wanted = std::get_if<DeadBandSpec>(&profile.law.curves)) {
        folder.read(wanted->dead_band.rows, {"tau_Nm", "dead_band_deg", kCurve, true, kDegree});
        folder.read(wanted->series_stiffness.rows, {"tau_Nm", "stiffness_Nm_per_rad", kCurve});
    }
    folder.read(profile.co_design);
    folder.read(profile.simulate.measured, {"tau_Nm", "width_deg", 1, false, kDegree});
    return std::move(folder).bytes();
}

}  // namespace fusee::profile
