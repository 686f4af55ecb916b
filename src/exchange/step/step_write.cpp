#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepBasic_DerivedUnit.hxx>
#include <StepBasic_DerivedUnitElement.hxx>
#include <StepBasic_HArray1OfDerivedUnitElement.hxx>
#include <StepBasic_MeasureValueMember.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepBasic_SiUnitAndMassUnit.hxx>
#include <StepBasic_Unit.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_DescriptiveRepresentationItem.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_MeasureRepresentationItem.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_PropertyDefinitionRepresentation.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cassert>
#include <gp_Trsf.hxx>
#include <iterator>
#include <map>
#include <set>

#include "brep/kernel/measure.h"
#include "fusee/core/error.h"
#include "fusee/exchange/step.h"
#include "step_model.h"

namespace fusee::exchange {

namespace {

/// OpenCASCADE writes bytes as they are, but a STEP file is ASCII: other letters become a question mark.
Handle(TCollection_HAsciiString) ascii(const std::string& s) {
    std::string plain;
    for (const char c : s)
        if ((c & 0xC0) != 0x80) plain += static_cast<unsigned char>(c) < 0x80 ? c : '?';
    return new TCollection_HAsciiString(plain.c_str());
}

template <class Entity>
Handle(Entity) first_of(const Handle(StepData_StepModel) & model) {
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto found = Handle(Entity)::DownCast(model->Value(i)); !found.IsNull()) return found;
    return {};
}

/// A property of the product with one value.
void add_property(const Handle(StepData_StepModel) & model, const char* name, const char* representation_name,
                  const Handle(StepRepr_RepresentationItem) & value) {
    StepRepr_CharacterizedDefinition of;
    of.SetValue(first_of<StepBasic_ProductDefinition>(model));
    const Handle(StepRepr_PropertyDefinition) property = new StepRepr_PropertyDefinition;
    property->Init(ascii("material property"), Standard_True, ascii(name), of);
    const Handle(StepRepr_HArray1OfRepresentationItem) items = new StepRepr_HArray1OfRepresentationItem(1, 1);
    items->SetValue(1, value);
    const Handle(StepRepr_Representation) representation = new StepRepr_Representation;
    representation->Init(ascii(representation_name), items,
                         first_of<StepShape_ShapeDefinitionRepresentation>(model)->UsedRepresentation()->ContextOfItems());
    StepRepr_RepresentedDefinition defined;
    defined.SetValue(property);
    const Handle(StepRepr_PropertyDefinitionRepresentation) link = new StepRepr_PropertyDefinitionRepresentation;
    link->Init(defined, representation);
    model->AddWithRefs(link);
}

template <class SiUnit>
Handle(StepBasic_DerivedUnitElement) element(StepBasic_SiPrefix prefix, bool has_prefix, StepBasic_SiUnitName name, double exponent) {
    const Handle(SiUnit) unit = new SiUnit;
    unit->Init(has_prefix, prefix, name);
    const Handle(StepBasic_DerivedUnitElement) part = new StepBasic_DerivedUnitElement;
    part->Init(unit, exponent);
    return part;
}

/// The density in grams and centimetres.
Handle(StepRepr_MeasureRepresentationItem) density_item(double density) {
    const Handle(StepBasic_HArray1OfDerivedUnitElement) parts = new StepBasic_HArray1OfDerivedUnitElement(1, 2);
    parts->SetValue(1, element<StepBasic_SiUnitAndMassUnit>(StepBasic_spKilo, false, StepBasic_sunGram, 1.0));
    parts->SetValue(2, element<StepBasic_SiUnitAndLengthUnit>(StepBasic_spCenti, true, StepBasic_sunMetre, -3.0));
    const Handle(StepBasic_DerivedUnit) derived = new StepBasic_DerivedUnit;
    derived->Init(parts);
    StepBasic_Unit unit;
    unit.SetValue(derived);
    const Handle(StepBasic_MeasureValueMember) value = new StepBasic_MeasureValueMember;
    value->SetName("POSITIVE_RATIO_MEASURE");
    value->SetReal(1e-3 * density);
    const Handle(StepRepr_MeasureRepresentationItem) item = new StepRepr_MeasureRepresentationItem;
    item->Init(ascii("density measure"), value, unit);
    return item;
}

void add_material(const Handle(StepData_StepModel) & model, const StepMaterial& material) {
    const Handle(StepRepr_DescriptiveRepresentationItem) name = new StepRepr_DescriptiveRepresentationItem;
    name->Init(ascii(material.designation), ascii(material.designation));
    add_property(model, "material name", "material name", name);
    if (material.density > 0.0) add_property(model, "density", "density", density_item(material.density));
}

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

using Contexts = std::map<const StepRepr_RepresentationItem*, Handle(StepRepr_RepresentationContext)>;

/// Those of all solids. STEPConstruct_Styles finds one by a list of who refers to whom in the whole model.
Contexts contexts_of(const Handle(StepData_StepModel) & model) {
    Contexts contexts;
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto shape = Handle(StepShape_ShapeRepresentation)::DownCast(model->Value(i)); !shape.IsNull())
            for (int k = 1; k <= shape->NbItems(); ++k) contexts.emplace(shape->ItemsValue(k).get(), shape->ContextOfItems());
    return contexts;
}

void paint(const Handle(XSControl_WorkSession) & session, const Contexts& contexts, const StepInstance& instance) {
    const auto part = [&](std::size_t i) { return instance.colour[i] / 255.0; };
    const auto colour = STEPConstruct_Styles::EncodeColor(Quantity_Color(part(0), part(1), part(2), Quantity_TOC_sRGB));
    for (TopExp_Explorer at(*instance.shape, TopAbs_SOLID); at.More(); at.Next()) {
        STEPConstruct_Styles styles;
        const auto item = STEPConstruct::FindEntity(session->TransferWriter()->FinderProcess(), at.Current());
        assert(!item.IsNull());
        styles.AddStyle(item, styles.MakeColorPSA(item, colour, colour, colour, 0.0), nullptr);
        Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) drawn;
        styles.CreateMDGPR(contexts.at(item.get()), drawn);
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

void write_step(const std::filesystem::path& path, const brep::Brep& solid, const std::string& name, const std::string& provenance,
                const StepMaterial& material) {
    write_step_model(path, name, provenance, [&](STEPControl_Writer& writer) {
        transfer(writer, *solid.shape, path);
        const Handle(StepData_StepModel) model = writer.Model();
        name_product(first_of<StepBasic_Product>(model), name);
        if (!material.designation.empty()) add_material(model, material);
    });
}

void write_step_assembly(const std::filesystem::path& path, const std::vector<StepInstance>& instances, const std::string& name,
                         const std::string& provenance) {
    require_names(instances);
    write_step_model(path, name, provenance, [&](STEPControl_Writer& writer) {
        const AsAssembly as_assembly;
        transfer(writer, placed(instances), path);
        const Contexts contexts = contexts_of(writer.Model());
        for (const StepInstance& instance : instances) paint(writer.WS(), contexts, instance);
        name_instances(writer.Model(), instances, name);
    });
}

}  // namespace fusee::exchange
