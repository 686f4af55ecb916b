#include "fusee/exchange/step.h"

#include <limits>

#include "foreign.h"
#include "fusee/core/module.h"
#include "fusee/solid/mesh_faults.h"
#include "step/kernel.h"

namespace fusee::exchange {

namespace {

/// OpenCASCADE takes 60 ms to start: it is loaded when a STEP file is read or written.
const StepKernel& kernel() {
    static const StepKernel& loaded =
        *reinterpret_cast<decltype(&fusee_step_kernel)>(core::loaded_function("fusee_step.so", "fusee_step_kernel"))();
    return loaded;
}

}  // namespace

void write_step(const std::filesystem::path& path, const brep::Brep& solid, const std::string& name, const std::string& provenance,
                const StepMaterial& material) {
    kernel().write(path, solid, name, provenance, material);
}

StepFile::StepFile(const std::filesystem::path& path) : solid_(kernel().read(path)) {}

StepFile::~StepFile() = default;

std::size_t StepFile::faces() const { return solid_->faces(); }

double StepFile::volume_mm3() const { return solid_->volume_mm3(); }

std::string StepFile::product() const { return solid_->product(); }

std::optional<double> StepFile::outermost(double azimuth, double z_mm) const { return solid_->outermost(azimuth, z_mm); }

void write_step_assembly(const std::filesystem::path& path, const std::vector<StepInstance>& instances, const std::string& name,
                         const std::string& provenance) {
    kernel().write_assembly(path, instances, name, provenance);
}

std::vector<StepBody> read_step_assembly(const std::filesystem::path& path) { return kernel().read_assembly(path); }

std::vector<Interference> interferences(const std::vector<StepBody>& bodies, double least_mm3) {
    return kernel().interferences(bodies, least_mm3);
}

namespace {

/// Removes triangles without area; takes a valid body, which touches itself but is no less a solid, apart where it touches.
std::size_t settle_mesh(solid::Mesh& mesh, bool valid) {
    mesh = solid::without_flat_triangles(std::move(mesh));
    if (valid) mesh = solid::parted(std::move(mesh));
    if (!solid::is_closed_and_oriented(mesh.triangles)) return std::numeric_limits<std::size_t>::max();
    const std::vector<std::uint32_t> flat = solid::flat_triangles(mesh);
    return flat.size() + solid::crossings(mesh, flat).pairs.size();
}

}  // namespace

MeshFile read_foreign_step(std::string bytes, const std::filesystem::path& path) { return kernel().read_mesh(path, bytes, settle_mesh); }

void load_step_reader() { kernel().load(); }

}  // namespace fusee::exchange
