#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "fusee/brep/brep.h"

namespace fusee::exchange {

/// Writes STEP AP242 (ISO 10303-242): millimetres, one product `name`, the provenance as description of the file. Equal input gives
/// equal bytes: the header has no time. Thread-safe.
/// @throws IoError
void write_step(const std::filesystem::path& path, const brep::Brep& solid, const std::string& name, const std::string& provenance);

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
    struct Shape;
    std::unique_ptr<Shape> shape_;
};

}  // namespace fusee::exchange
