#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>
#include <mutex>
#include <sstream>

#include "fusee/brep/failure.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/step.h"
#include "step_session.h"

namespace fusee::exchange {

namespace {

Handle(TCollection_HAsciiString) text(const std::string& s) { return new TCollection_HAsciiString(s.c_str()); }

/// Replaces the time and the system that OpenCASCADE writes.
void set_header(const Handle(StepData_StepModel) & model, const std::string& name, const std::string& provenance) {
    APIHeaderSection_MakeHeader header(model);
    header.SetName(text(name));
    header.SetTimeStamp(text("1970-01-01T00:00:00"));
    header.SetAuthorValue(1, text(""));
    header.SetOrganizationValue(1, text(""));
    header.SetPreprocessorVersion(text("OpenCASCADE"));
    header.SetOriginatingSystem(text("fusee"));
    header.SetAuthorisation(text(""));
    header.SetDescriptionValue(1, text(provenance));
}

/// Replaces the product number that OpenCASCADE adds to names.
void set_product(const Handle(StepData_StepModel) & model, const std::string& name) {
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i));
        if (product.IsNull()) continue;
        product->SetId(text(name));
        product->SetName(text(name));
    }
}

std::string step_of(const std::filesystem::path& path, const brep::Brep& solid, const std::string& name, const std::string& provenance) {
    // The schema must be set after the controller and before the writer.
    Interface_Static::SetCVal("write.step.schema", "AP242DIS");
    STEPControl_Writer writer;
    if (writer.Transfer(*solid.shape, STEPControl_AsIs) != IFSelect_RetDone)
        throw core::IoError(path.string(), "OpenCASCADE cannot transfer the solid");
    const Handle(StepData_StepModel) model = writer.Model();
    set_header(model, name, provenance);
    set_product(model, name);
    StepData_StepWriter file(model);
    file.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
    std::ostringstream bytes;
    if (!file.Print(bytes)) throw core::IoError(path.string(), "OpenCASCADE cannot print the STEP file");
    return bytes.str();
}

}  // namespace

void write_step(const std::filesystem::path& path, const brep::Brep& solid, const std::string& name, const std::string& provenance) {
    std::string bytes;
    try {
        const std::scoped_lock lock(step_session());
        brep::guard([&] { bytes = step_of(path, solid, name, provenance); });
    } catch (const brep::Failure& failure) {
        throw core::IoError(path.string(), failure.what());
    }
    core::write_file(path, bytes);
}

}  // namespace fusee::exchange
