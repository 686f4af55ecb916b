#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <set>

#include "brep/kernel/failure.h"
#include "brep/kernel/measure.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/step.h"
#include "step_shape.h"

namespace fusee::exchange {

namespace {

std::string text(const Handle(TCollection_HAsciiString) & from) { return from.IsNull() ? "" : from->ToCString(); }

using Use = Handle(StepRepr_NextAssemblyUsageOccurrence);

/// Those of products that are used nowhere themselves, in the file's order.
std::vector<Use> uses_of_root(const Handle(StepData_StepModel) & model) {
    std::vector<Use> all;
    std::set<const StepBasic_ProductDefinition*> used;
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto use = Use::DownCast(model->Value(i)); !use.IsNull()) {
            all.push_back(use);
            used.insert(use->RelatedProductDefinition().get());
        }
    std::erase_if(all, [&](const Use& use) { return used.count(use->RelatingProductDefinition().get()) > 0; });
    return all;
}

StepBody body_of(const Use& use, const TopoDS_Shape& shape) {
    return {text(use->Name()),
            text(use->RelatedProductDefinition()->Formation()->OfProduct()->Name()),
            std::make_shared<TopoDS_Shape>(shape),
            brep::count_solids(shape),
            brep::volume_mm3(shape),
            brep::bounding_box(shape)};
}

bool meet(const solid::Box& a, const solid::Box& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.high_mm[i] < b.low_mm[i] || b.high_mm[i] < a.low_mm[i]) return false;
    return true;
}

}  // namespace

std::vector<StepBody> read_step_assembly(const std::filesystem::path& path) {
    std::vector<StepBody> bodies;
    with_step_shape(path, core::read_file(path), [&](const TopoDS_Shape&, const STEPControl_Reader& reader) {
        const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
        for (const Use& use : uses_of_root(reader.StepModel())) {
            const TopoDS_Shape shape = TransferBRep::ShapeResult(process, use);
            if (!brep::is_valid(shape)) throw core::IoError(path.string(), "contains no valid solid named \"" + text(use->Name()) + "\"");
            bodies.push_back(body_of(use, shape));
        }
    });
    if (bodies.empty()) throw core::IoError(path.string(), "contains no instance of a product");
    return bodies;
}

std::vector<Interference> interferences(const std::vector<StepBody>& bodies, double least_mm3) {
    std::vector<Interference> all;
    brep::guard([&] {
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t k = i + 1; k < bodies.size(); ++k) {
                if (!meet(bodies[i].box, bodies[k].box)) continue;
                const double common = brep::common_volume_mm3(*bodies[i].shape, *bodies[k].shape);
                if (common >= least_mm3) all.push_back({bodies[i].name, bodies[k].name, common});
            }
    });
    std::stable_sort(all.begin(), all.end(), [](const Interference& a, const Interference& b) { return a.common_mm3 > b.common_mm3; });
    return all;
}

}  // namespace fusee::exchange
