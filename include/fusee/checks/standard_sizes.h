#pragma once
#include <optional>
#include <span>
#include <string>

/// Sizes of bought parts. A suggested shaft, cable or wire has one of these sizes (docs/guides/fix.md).
namespace fusee::checks {

/// Diameters of one kind of part [mm], ascending.
struct StandardSizes {
    const char* what;  ///< "shaft"
    std::span<const double> mm;
    const char* source;

    /// The largest size up to `limit_mm`; none if all are larger. A size that misses the limit only by rounding (1e-9 relative) counts.
    [[nodiscard]] std::optional<double> at_most(double limit_mm) const;
    /// The smallest size from `limit_mm` on; none if all are smaller.
    [[nodiscard]] std::optional<double> at_least(double limit_mm) const;
};

[[nodiscard]] StandardSizes shaft_sizes();
[[nodiscard]] StandardSizes wire_sizes();   ///< spring wire
[[nodiscard]] StandardSizes screw_sizes();  ///< metric set screws, thread diameter
/// @throws InvalidInput naming cable.construction
[[nodiscard]] StandardSizes cable_sizes(const std::string& construction);

/// The breaking load that a usual cable of diameter `d` [m] has at least, in N: for a profile that states none.
/// @throws InvalidInput naming cable.construction
[[nodiscard]] double usual_cable(const std::string& construction, double d);
/// The breaking load that the strongest cable on sale has at diameter `d` [m], in N. @throws InvalidInput naming cable.construction
[[nodiscard]] double strongest_cable(const std::string& construction, double d);

/// Shear stress of a round shaft in torsion, 16 T/(pi d^3) [Pa]. @param torque T [Nm] @param diameter d [m], > 0
[[nodiscard]] double torsion_stress(double torque, double diameter);
/// Allowed shear stress of a shaft of ordinary steel [Pa]: 41 MPa with a keyway, 55 MPa without (ASME code for transmission shafting).
[[nodiscard]] double shaft_shear_limit(bool keyway);

}  // namespace fusee::checks
