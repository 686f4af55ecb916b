#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "fusee/brep/brep.h"

namespace fusee::exchange {

/// What a part is made of; an empty designation is not written.
struct StepMaterial {
    std::string designation;  ///< "EN AW-6082 T6 (EN 573-3, EN 515)"; letters beyond ASCII are written as "?"
    double density = 0.0;     ///< [kg/m^3]
};

/// Writes STEP AP242 (ISO 10303-242): millimetres, one product `name`, the provenance as description of the file, the material and its
/// density (in g/cm^3) as properties of the product (recommended practice of CAx-IF, material identification and density). Equal input
/// gives equal bytes: the header has no time. Thread-safe.
/// @throws IoError
void write_step(const std::filesystem::path& path, const brep::Brep& solid, const std::string& name, const std::string& provenance,
                const StepMaterial& material = {});

class StepSolid;

/// A STEP file with one solid, read by OpenCASCADE.
class StepFile {
public:
    /// Thread-safe. @throws IoError naming the file: not STEP, cut short, not exactly one valid solid
    explicit StepFile(const std::filesystem::path& path);
    ~StepFile();
    [[nodiscard]] std::size_t faces() const;
    [[nodiscard]] double volume_mm3() const;
    [[nodiscard]] std::string product() const;
    /// The outermost point of the surface on a horizontal ray at height z: its distance from the z axis [mm]; nothing if the ray meets
    /// none.
    [[nodiscard]] std::optional<double> outermost(double azimuth, double z_mm) const;

private:
    std::unique_ptr<StepSolid> solid_;
};

}  // namespace fusee::exchange
