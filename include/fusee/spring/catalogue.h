#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/spring/base_spring.h"

namespace fusee::spring {

/// A spring as a vendor lists it: what a base spring can be held to. `spring.preload` is 0; the user chooses it.
struct CatalogueSpring {
    std::string name;
    BaseSpring spring;
};

/// The springs of both kinds, each by rising rate.
struct Catalogue {
    std::vector<CatalogueSpring> torsion, compression;
    [[nodiscard]] const std::vector<CatalogueSpring>& of(BaseKind kind) const { return kind == BaseKind::kTorsion ? torsion : compression; }
};

/// A CSV file with one spring a row (docs/guides/co-design.md):
///     kind ("torsion" or "compression"), name, rate [Nm/rad or N/m], wire_mm, coil_mm, active_coils, tensile_strength_MPa,
///     free_length_mm (0 for torsion), max_deflection [rad or mm], max_load [Nm or N]; stress_share may be left out (0.8).
/// @throws InvalidInput "file:line:column: name": unknown kind, a number that is not above 0 where it has to be, a name that stands twice;
/// IoError
[[nodiscard]] Catalogue read_catalogue(const std::filesystem::path& path);
/// The same from bytes. @param file the name used in messages
[[nodiscard]] Catalogue parse_catalogue(std::string_view bytes, const std::string& file);

}  // namespace fusee::spring
