#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TopoDS_Shape.hxx>
#include <mutex>

#include "fusee/brep/failure.h"
#include "fusee/brep/measure.h"
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

}  // namespace

void with_step_shape(const std::filesystem::path& path, const std::string& bytes,
                     const std::function<void(const TopoDS_Shape&, const STEPControl_Reader&)>& take) {
    require_sound_step(bytes, path);
    const std::scoped_lock lock(step_session());
    try {
        brep::guard([&] {
            STEPControl_Reader reader;  // converts every unit to millimetres
            if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) throw core::IoError(path.string(), "is not a STEP file");
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
