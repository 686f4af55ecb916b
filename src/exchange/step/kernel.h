#pragma once
#include "fusee/exchange/mesh_file.h"
#include "fusee/exchange/step.h"

namespace fusee::exchange {

/// A solid that was read from a file; the members are those of StepFile.
class StepSolid {
public:
    virtual ~StepSolid() = default;
    [[nodiscard]] virtual std::size_t faces() const = 0;
    [[nodiscard]] virtual double volume_mm3() const = 0;
    [[nodiscard]] virtual std::string product() const = 0;
    [[nodiscard]] virtual std::optional<double> outermost(double azimuth, double z_mm) const = 0;
};

/// @throws as StepFile's constructor
[[nodiscard]] std::unique_ptr<StepSolid> read_step(const std::filesystem::path& path);
/// Mends what a tessellation alone cannot do (settle_mesh of step.cpp). @param valid the kernel calls the body valid
/// @returns how many faults are left; 0: the mesh is sound
using SettleMesh = std::size_t (*)(solid::Mesh& mesh, bool valid);
/// Tessellates all shapes, a body finer where `settle` finds faults. @param bytes of the file @throws core::IoError naming it
[[nodiscard]] MeshFile read_step_mesh(const std::filesystem::path& path, const std::string& bytes, SettleMesh settle);

/// The functions of this module that call OpenCASCADE, as the library fusee_step.so has them. The module itself has functions of the same
/// names, which load the library and call these.
struct StepKernel {
    decltype(&exchange::write_step) write;
    decltype(&exchange::read_step) read;
    decltype(&exchange::write_step_assembly) write_assembly;
    decltype(&exchange::read_step_assembly) read_assembly;
    decltype(&exchange::interferences) interferences;
    decltype(&exchange::read_step_mesh) read_mesh;
    void (*load)();  ///< initializes OpenCASCADE's reader, which looks for files of settings
};

}  // namespace fusee::exchange

extern "C" [[gnu::visibility("default")]] const fusee::exchange::StepKernel* fusee_step_kernel();
