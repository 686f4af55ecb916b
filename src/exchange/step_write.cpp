#include <TopoDS_Shape.hxx>

#include "fusee/exchange/step.h"
#include "step_model.h"

namespace fusee::exchange {

void write_step(const std::filesystem::path& path, const brep::Brep& solid, const std::string& name, const std::string& provenance) {
    write_step_model(path, name, provenance, [&](STEPControl_Writer& writer) {
        transfer(writer, *solid.shape, path);
        const Handle(StepData_StepModel) model = writer.Model();
        for (int i = 1; i <= model->NbEntities(); ++i)
            if (const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i)); !product.IsNull()) name_product(product, name);
    });
}

}  // namespace fusee::exchange
