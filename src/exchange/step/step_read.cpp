#include <fmt/format.h>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <gp_Vec.hxx>
#include <mutex>
#include <sstream>

#include "brep/kernel/failure.h"
#include "brep/kernel/measure.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "kernel.h"
#include "step_rays.h"
#include "step_scan.h"
#include "step_session.h"
#include "step_shape.h"

namespace fusee::exchange {

std::mutex& step_session() {
    static std::mutex mutex;
    static const bool ready = [] {
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        return STEPControl_Controller::Init();
    }();
    (void)ready;
    return mutex;
}

namespace {

constexpr double kScale = 1e-9;  // a scale of a placement that is none

class OpenCascadeSolid : public StepSolid {
public:
    OpenCascadeSolid(const TopoDS_Shape& solid, std::string product) : solid_(solid), product_(std::move(product)), rays_(solid) {}
    [[nodiscard]] std::size_t faces() const override { return brep::count_faces(solid_); }
    [[nodiscard]] double volume_mm3() const override { return brep::volume_mm3(solid_); }
    [[nodiscard]] std::string product() const override { return product_; }
    [[nodiscard]] std::optional<double> outermost(double azimuth, double z_mm) const override {
        std::optional<double> found;
        brep::guard([&] { found = rays_.outermost(azimuth, z_mm); });
        return found;
    }

private:
    TopoDS_Shape solid_;
    std::string product_;
    StepRays rays_;
};

std::string product_of(const STEPControl_Reader& reader) {
    const Handle(StepData_StepModel) model = reader.StepModel();
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i)); !product.IsNull())
            return product->Name()->ToCString();
    return "";
}

/// In place of a direction that is not stated; all three of a placement that mirrors are.
gp_Vec direction(bool stated, const Handle(StepGeom_Direction) & d, const gp_Vec& otherwise) {
    if (!stated || d.IsNull() || d->NbDirectionRatios() < 3) return otherwise;
    return {d->DirectionRatiosValue(1), d->DirectionRatiosValue(2), d->DirectionRatiosValue(3)};
}

/// OpenCASCADE 7.6 turns a part that is placed as its mirror image, and leaves out a scale: nothing would be where the file has it.
/// @throws core::IoError
void require_rigid_placements(const STEPControl_Reader& reader, const std::filesystem::path& path) {
    const Handle(StepData_StepModel) model = reader.StepModel();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto placement = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(model->Value(i));
        if (placement.IsNull()) continue;
        const gp_Vec x = direction(placement->HasAxis1(), placement->Axis1(), {1, 0, 0}),
                     y = direction(placement->HasAxis2(), placement->Axis2(), {0, 1, 0}),
                     z = direction(placement->HasAxis3(), placement->Axis3(), x.Crossed(y));
        const bool mirrors = x.Crossed(y).Dot(z) < 0.0, scales = placement->HasScale() && std::abs(placement->Scale() - 1.0) > kScale;
        if (!mirrors && !scales) continue;
        throw core::IoError(path.string(),
                            fmt::format("#{} places a part {} (CARTESIAN_TRANSFORMATION_OPERATOR_3D), which OpenCASCADE does not "
                                        "do; export the part as it stands, without its placement",
                                        model->IdentLabel(placement), mirrors ? "as its mirror image" : "with a scale"));
    }
}

}  // namespace

void with_step_shape(const std::filesystem::path& path, const std::string& bytes,
                     const std::function<void(const TopoDS_Shape&, STEPControl_Reader&)>& take) {
    require_sound_step(bytes, path);
    const std::scoped_lock lock(step_session());
    try {
        brep::guard([&] {
            STEPControl_Reader reader;  // converts every unit to millimetres
            std::istringstream in(bytes);
            if (reader.ReadStream(path.c_str(), in) != IFSelect_RetDone) throw core::IoError(path.string(), "is not a STEP file");
            require_rigid_placements(reader, path);
            if (reader.TransferRoots() == 0) throw core::IoError(path.string(), "contains no shape");
            take(reader.OneShape(), reader);
        });
    } catch (const brep::Failure& failure) {
        throw core::IoError(path.string(), failure.what());
    }
}

std::unique_ptr<StepSolid> read_step(const std::filesystem::path& path) {
    std::unique_ptr<StepSolid> solid;
    with_step_shape(path, core::read_file(path), [&](const TopoDS_Shape& shape, const STEPControl_Reader& reader) {
        if (!brep::is_one_solid(shape)) throw core::IoError(path.string(), "does not contain exactly one valid solid");
        solid = std::make_unique<OpenCascadeSolid>(shape, product_of(reader));
    });
    return solid;
}

}  // namespace fusee::exchange
