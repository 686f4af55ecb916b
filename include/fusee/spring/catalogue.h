#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/csv.h"
#include "fusee/spring/base_spring.h"

namespace fusee::spring {

/// A spring of a vendor's list, as a choice for a base spring. `spring.preload` is 0; the user chooses it.
struct CatalogueSpring {
    std::string name;
    BaseSpring spring;
};

/// The springs of both kinds, sorted by rate.
struct Catalogue {
    std::vector<CatalogueSpring> torsion, compression;
    [[nodiscard]] const std::vector<CatalogueSpring>& of(BaseKind kind) const { return kind == BaseKind::kTorsion ? torsion : compression; }
};

/// A CSV file with one spring per row (docs/guides/co-design.md):
///     kind ("torsion" or "compression"), name, rate [Nm/rad or N/m], wire_mm, coil_mm, active_coils, tensile_strength_MPa,
///     free_length_mm (0 for torsion), max_deflection [rad or mm], max_load [Nm or N]; stress_share is optional (0 = that of its kind).
/// The header may give rate, max_deflection and max_load a unit of one kind: a list of compression springs with "rate [N/mm]".
/// @throws InvalidInput "file:line:column: name": as core::parse_csv; unknown kind, a number that must be above 0 and is not, a repeated
/// name, figures that look like another unit; IoError
[[nodiscard]] Catalogue read_catalogue(const std::filesystem::path& path, const core::CsvMapping& mapping = {});
/// The same from bytes. @param file the name used in messages
[[nodiscard]] Catalogue parse_catalogue(std::string_view bytes, const std::string& file, const core::CsvMapping& mapping = {});
/// Its columns.
[[nodiscard]] const std::vector<core::CsvColumn>& catalogue_columns();

}  // namespace fusee::spring
