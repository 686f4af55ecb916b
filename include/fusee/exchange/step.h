#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fusee/exchange/brep.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/solid/mesh.h"

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

/// One body of an assembly, in its own frame.
struct StepInstance {
    std::string name;                                             ///< of product and instance
    std::shared_ptr<const TopoDS_Shape> shape;                    ///< in mm: one solid, or several of one body
    Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< from its frame to the assembly's: a proper rotation [mm]
    Colour colour{};
};

/// Writes STEP AP242 with the assembly `name`: for each instance one product and its placement; the provenance as description of the file.
/// A body of several solids is an assembly of the products NAME_1, NAME_2.
/// Equal input gives equal bytes. Thread-safe. @throws core::InvalidInput: no instance, or two of one name; core::IoError
void write_step_assembly(const std::filesystem::path& path, const std::vector<StepInstance>& instances, const std::string& name,
                         const std::string& provenance);

/// One instance of a file.
struct StepBody {
    std::string name;                           ///< of the instance
    std::string product;                        ///< of which it is an instance
    std::shared_ptr<const TopoDS_Shape> shape;  ///< in the assembly's frame [mm]
    std::size_t solids = 0;
    double volume_mm3 = 0.0;  ///< of its solids
    solid::Box box;           ///< of the exact surface
};

/// Reads the instances of the assembly of a STEP file, in the file's order. Thread-safe. @throws core::IoError naming the file: not STEP,
/// cut short, without instances, or with one that is not valid
[[nodiscard]] std::vector<StepBody> read_step_assembly(const std::filesystem::path& path);

/// Two bodies and the volume that both take.
struct Interference {
    std::string a, b;
    double common_mm3 = 0.0;
};
/// The interference of each pair of bodies, by falling volume; bodies that touch have none. @param least_mm3 smaller ones are left out
/// @throws brep::Failure
[[nodiscard]] std::vector<Interference> interferences(const std::vector<StepBody>& bodies, double least_mm3);

}  // namespace fusee::exchange
