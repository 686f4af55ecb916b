#include "fusee/spring/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/spring/coil.h"

namespace fusee::spring {

namespace {

using Kind = core::CsvColumn::Kind;
constexpr std::size_t kMostSprings = 100'000;
constexpr std::size_t kLargestFile = 10'000'000;  // [bytes]

/// A column whose unit depends on the spring's kind: of compression and of torsion.
core::CsvColumn of_kind(const char* name, const char* compression, const char* torsion) {
    return {.name = name, .units = {compression, torsion}};
}

/// One row of the table; every refusal names its cell.
class Row {
public:
    Row(const core::CsvTable& table, std::size_t row) : table_(table), row_(row) {}

    [[nodiscard]] const std::string& text(const char* column) const { return table_.texts(column)[row_]; }
    [[nodiscard]] double number(const char* column) const { return table_.numbers(column)[row_]; }
    [[nodiscard]] double above_0(const char* column) const {
        if (const double value = number(column); value > 0.0) return value;
        throw fault(column, fmt::format("{:g}", number(column)), "above 0");
    }
    [[nodiscard]] core::InvalidInput fault(const char* column, std::string value, std::string allowed) const {
        return table_.fault(row_, column, std::move(value), std::move(allowed));
    }
    /// Asks whether a figure is in `unit` if it is about `factor` of those units away from what the other figures give.
    void ask(const char* column, double expected, const char* unit, double factor) const {
        const double off = number(column) * factor / expected;
        if (!table_.unit_is_told(column) && !table_.unit(column) && off > 0.5 && off < 2.0)
            throw table_.question(row_, column, unit, fmt::format("the other figures of the spring give {:.3g}", expected));
    }
    /// The header's units of compression or torsion springs, where it names one.
    void require_kind(bool torsion) const {
        for (const char* column : {"rate", "max_deflection", "max_load"})
            if (const auto unit = table_.unit(column); unit && *unit != (torsion ? 1U : 0U))
                throw fault(column, fmt::format("a {} spring", torsion ? "torsion" : "compression"),
                            fmt::format("{} springs only: the header gives their unit", torsion ? "compression" : "torsion"));
    }

private:
    const core::CsvTable& table_;
    std::size_t row_;
};

BaseKind kind_of(const Row& row) {
    const std::string& kind = row.text("kind");
    if (kind != "torsion" && kind != "compression") throw row.fault("kind", kind, "torsion or compression");
    return kind == "torsion" ? BaseKind::kTorsion : BaseKind::kCompression;
}

/// Wire and coils give the rate, rate and deflection the load: a figure a thousand or 57 times off is in another unit.
void ask_about_units(const Row& row, const BaseSpring& s) {
    const bool torsion = s.kind == BaseKind::kTorsion;
    const double rate = rate_of_coils(s), deflection = row.number("max_load") / s.rate * (torsion ? 1.0 : 1e3);
    const auto factor = [](const char* unit, const char* own) {
        return core::find_measure_unit(unit)->to(*core::find_measure_unit(own), 1.0);
    };
    for (const char* unit : torsion ? std::vector{"Nm/deg", "mNm/rad", "mNm/deg"} : std::vector{"N/mm"})
        row.ask("rate", rate, unit, factor(unit, torsion ? "Nm/rad" : "N/m"));
    row.ask("max_deflection", deflection, torsion ? "deg" : "m", factor(torsion ? "deg" : "m", torsion ? "rad" : "mm"));
    row.ask("max_load", row.number("max_load") / deflection * row.number("max_deflection"), torsion ? "mNm" : "mN", 1e-3);
}

BaseSpring spring_of(const Row& row) {
    BaseSpring s;
    s.kind = kind_of(row);
    const bool torsion = s.kind == BaseKind::kTorsion;
    row.require_kind(torsion);
    s.rate = row.above_0("rate");
    s.wire_diameter = core::m_from_mm(row.above_0("wire_mm"));
    s.coil_diameter = core::m_from_mm(row.above_0("coil_mm"));
    if (s.coil_diameter <= s.wire_diameter) throw row.fault("coil_mm", fmt::format("{:g}", row.number("coil_mm")), "above wire_mm");
    s.active_coils = row.above_0("active_coils");
    s.free_length = torsion ? 0.0 : core::m_from_mm(row.above_0("free_length_mm"));
    s.max_state = torsion ? row.above_0("max_deflection") : core::m_from_mm(row.above_0("max_deflection"));
    s.max_load = row.above_0("max_load");
    s.tensile_strength = row.above_0("tensile_strength_MPa") * 1e6;
    ask_about_units(row, s);
    return s;
}

double stress_share(const Row& row) {
    const double share = row.above_0("stress_share");
    if (share > 1.0) throw row.fault("stress_share", fmt::format("{:g}", share), "at most 1");
    return share;
}

}  // namespace

const std::vector<core::CsvColumn>& catalogue_columns() {
    static const std::vector<core::CsvColumn> all = {{"kind", Kind::kText},
                                                     {"name", Kind::kText},
                                                     of_kind("rate", "N/m", "Nm/rad"),
                                                     {"wire_mm"},
                                                     {"coil_mm"},
                                                     {"active_coils"},
                                                     {"free_length_mm"},
                                                     of_kind("max_deflection", "mm", "rad"),
                                                     of_kind("max_load", "N", "Nm"),
                                                     {"tensile_strength_MPa"},
                                                     {"stress_share", Kind::kNumber, false}};
    return all;
}

Catalogue parse_catalogue(std::string_view bytes, const std::string& file, const core::CsvMapping& mapping) {
    const core::CsvTable table = core::parse_csv(bytes, file, catalogue_columns(), {.most_rows = kMostSprings, .mapping = mapping});
    Catalogue catalogue;
    std::set<std::string> names;
    core::CsvFaults faults(file);
    const auto take = [&](const Row& row) {
        CatalogueSpring entry{row.text("name"), spring_of(row)};
        if (table.has("stress_share")) entry.spring.stress_share = stress_share(row);
        if (!names.insert(entry.name).second) throw row.fault("name", entry.name, "a unique name");
        (entry.spring.kind == BaseKind::kTorsion ? catalogue.torsion : catalogue.compression).push_back(std::move(entry));
    };
    for (std::size_t i = 0; i < table.rows(); ++i) faults.collect([&] { take(Row(table, i)); });
    faults.throw_if_any();
    const auto softer = [](const CatalogueSpring& a, const CatalogueSpring& b) { return a.spring.rate < b.spring.rate; };
    std::stable_sort(catalogue.torsion.begin(), catalogue.torsion.end(), softer);
    std::stable_sort(catalogue.compression.begin(), catalogue.compression.end(), softer);
    return catalogue;
}

Catalogue read_catalogue(const std::filesystem::path& path, const core::CsvMapping& mapping) {
    return parse_catalogue(core::read_file(path, kLargestFile), path.string(), mapping);
}

}  // namespace fusee::spring
