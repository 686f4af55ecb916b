#include <StepBasic_DerivedUnit.hxx>
#include <StepBasic_DerivedUnitElement.hxx>
#include <StepBasic_HArray1OfDerivedUnitElement.hxx>
#include <StepBasic_MeasureValueMember.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepBasic_SiUnitAndMassUnit.hxx>
#include <StepBasic_Unit.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_DescriptiveRepresentationItem.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_MeasureRepresentationItem.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_PropertyDefinitionRepresentation.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>

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

}  // namespace fusee::exchange
