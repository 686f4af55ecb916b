#include "step_model.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>

#include "brep/kernel/failure.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"

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

}  // namespace

void name_product(const Handle(StepBasic_Product) & product, const std::string& name) {
    product->SetId(text(name));
    product->SetName(text(name));
}

void write_step_model(const std::filesystem::path& path, const std::string& name, const std::string& provenance,
                      const std::function<void(STEPControl_Writer&)>& fill) {
    std::ostringstream bytes;
    try {
        const std::scoped_lock lock(step_session());
        brep::guard([&] {
            // The schema must be set after the controller and before the writer.
            Interface_Static::SetCVal("write.step.schema", "AP242DIS");
            STEPControl_Writer writer;
            fill(writer);
            const Handle(StepData_StepModel) model = writer.Model();
            set_header(model, name, provenance);
            StepData_StepWriter file(model);
            file.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
            if (!file.Print(bytes)) throw core::IoError(path.string(), "OpenCASCADE cannot print the STEP file");
        });
    } catch (const brep::Failure& failure) {
        throw core::IoError(path.string(), failure.what());
    }
    core::write_file(path, bytes.str());
}

void transfer(STEPControl_Writer& writer, const TopoDS_Shape& shape, const std::filesystem::path& path) {
    constexpr bool kWithGraph = false;  // of who refers to whom: for choices and checks, which nothing here makes
    if (writer.Transfer(shape, STEPControl_AsIs, kWithGraph) != IFSelect_RetDone)
        throw core::IoError(path.string(), "OpenCASCADE cannot transfer the solid");
}

}  // namespace fusee::exchange
