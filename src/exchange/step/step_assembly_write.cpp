#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cassert>
#include <gp_Trsf.hxx>
#include <iterator>
#include <set>

#include "brep/kernel/measure.h"
#include "brep/kernel/transform.h"
#include "fusee/core/error.h"
#include "fusee/exchange/step.h"
#include "step_model.h"

namespace fusee::exchange {

namespace {

/// OpenCASCADE writes a compound as an assembly of its shapes while this lives.
class AsAssembly {
public:
    AsAssembly() : before_(Interface_Static::IVal(kName)) { Interface_Static::SetIVal(kName, 1); }
    ~AsAssembly() { Interface_Static::SetIVal(kName, before_); }
    AsAssembly(const AsAssembly&) = delete;
    AsAssembly& operator=(const AsAssembly&) = delete;

private:
    static constexpr const char* kName = "write.step.assembly";
    int before_;
};

TopoDS_Compound placed(const std::vector<StepInstance>& instances) {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const StepInstance& instance : instances)
        builder.Add(all, brep::solids_of(*instance.shape).Moved(TopLoc_Location(brep::transform_of(instance.placement))));
    return all;
}

Handle(StepBasic_Product) product_of(const Handle(StepBasic_ProductDefinition) & definition) {
    return definition->Formation()->OfProduct();
}

using Use = Handle(StepRepr_NextAssemblyUsageOccurrence);

/// The uses in the order of their transfer.
std::vector<Use> uses_of(const Handle(StepData_StepModel) & model) {
    std::vector<Use> all;
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto use = Use::DownCast(model->Value(i)); !use.IsNull()) all.push_back(use);
    return all;
}

/// The use and the product used.
void set_name(const Use& use, const std::string& name) {
    const Handle(TCollection_HAsciiString) text = new TCollection_HAsciiString(name.c_str());
    use->SetId(text);
    use->SetName(text);
    name_product(product_of(use->RelatedProductDefinition()), name);
}

/// A body of several solids is an assembly of its own: its solids are NAME_1, NAME_2.
void name_instances(const Handle(StepData_StepModel) & model, const std::vector<StepInstance>& instances, const std::string& name) {
    const std::vector<Use> uses = uses_of(model);
    const Handle(StepBasic_ProductDefinition) root = uses.front()->RelatingProductDefinition();
    name_product(product_of(root), name);
    std::vector<Use> bodies;
    std::copy_if(uses.begin(), uses.end(), std::back_inserter(bodies),
                 [&](const Use& use) { return use->RelatingProductDefinition() == root; });
    assert(bodies.size() == instances.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        set_name(bodies[i], instances[i].name);
        int solid = 0;
        for (const Use& use : uses)
            if (use->RelatingProductDefinition() == bodies[i]->RelatedProductDefinition())
                set_name(use, fmt::format("{}_{}", instances[i].name, ++solid));
    }
}

void paint(const Handle(XSControl_WorkSession) & session, const StepInstance& instance) {
    const auto part = [&](std::size_t i) { return instance.colour[i] / 255.0; };
    const auto colour = STEPConstruct_Styles::EncodeColor(Quantity_Color(part(0), part(1), part(2), Quantity_TOC_sRGB));
    for (TopExp_Explorer at(*instance.shape, TopAbs_SOLID); at.More(); at.Next()) {
        STEPConstruct_Styles styles(session);
        const auto item = STEPConstruct::FindEntity(session->TransferWriter()->FinderProcess(), at.Current());
        assert(!item.IsNull());
        styles.AddStyle(item, styles.MakeColorPSA(item, colour, colour, colour, 0.0), nullptr);
        Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) drawn;
        styles.CreateMDGPR(styles.FindContext(at.Current()), drawn);
        assert(!drawn.IsNull());
        session->Model()->AddWithRefs(drawn);
    }
}

void require_names(const std::vector<StepInstance>& instances) {
    if (instances.empty()) throw core::InvalidInput("instances", "0", "at least 1");
    std::set<std::string> names;
    for (const StepInstance& instance : instances)
        if (!names.insert(instance.name).second)
            throw core::InvalidInput("instances", "\"" + instance.name + "\" twice", "different names");
}

}  // namespace

void write_step_assembly(const std::filesystem::path& path, const std::vector<StepInstance>& instances, const std::string& name,
                         const std::string& provenance) {
    require_names(instances);
    write_step_model(path, name, provenance, [&](STEPControl_Writer& writer) {
        const AsAssembly as_assembly;
        transfer(writer, placed(instances), path);
        for (const StepInstance& instance : instances) paint(writer.WS(), instance);
        name_instances(writer.Model(), instances, name);
    });
}

}  // namespace fusee::exchange
