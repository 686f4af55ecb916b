#include <array>

#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"

namespace fusee::checks {

namespace {

constexpr double kPlasticCreep = 1.0 / 3.0;  // of the short-time modulus

constexpr Material plastic(const char* name, double strength, double permanent, double bearing, double modulus, double density,
                           const char* designation, const char* source) {
    return {name,    strength * 1e6, permanent * 1e6, bearing * 1e6, modulus * 1e9, kPlasticCreep * modulus * 1e9,
            density, designation,    source};
}
constexpr Material metal(const char* name, double yield, double permanent, double modulus, double density, const char* designation,
                         const char* source) {
    return {name, yield * 1e6, permanent * 1e6, yield * 1e6, modulus * 1e9, modulus * 1e9, density, designation, source};
}

constexpr std::array kMaterials = {
    plastic("pla", 50.0, 20.0, 60.0, 2.3, 1240.0, "PLA (ISO 1043-1), as printed",
            "strength: PMC10113796, table 6; bearing, permanent and creep (practice)"),
    plastic("petg", 38.0, 15.0, 45.0, 2.0, 1270.0, "PETG (ISO 1043-1), as printed",
            "strength, modulus: PMC10113796, table 6; bearing, permanent and creep (practice)"),
    plastic("resin", 42.0, 30.0, 50.0, 2.0, 1180.0, "resin, washed and cured",
            "strength, modulus: PMC10113796, table 6; bearing, permanent and creep (practice)"),
    plastic("pa12", 43.0, 35.0, 52.0, 1.5, 1010.0, "PA12 (ISO 1043-1), as sintered",
            "strength, modulus: PMC10113796, table 6; bearing, permanent and creep (practice)"),
    plastic("pom", 65.0, 26.0, 78.0, 2.8, 1410.0, "POM-C (ISO 1043-1), as extruded", "(practice)"),
    plastic(
        "pmma", 70.0, 10.0, 84.0, 3.2, 1190.0, "PMMA (ISO 1043-1), cast sheet (ISO 7823-1)",
        "strength, modulus: makeitfrom, designerdata; permanent: 1500 psi at most, against crazing (Plexiglas); bearing, creep (practice)"),
    metal("aluminium", 250.0, 100.0, 70.0, 2700.0, "EN AW-6082 T6 (EN 573-3, EN 515)", "EN AW-6082-T6 (practice)"),
    metal("steel", 235.0, 100.0, 210.0, 7850.0, "S235JR+AR (EN 10025-2)", "S235 (practice)"),
};

const Material* find(const std::string& name) { return core::find_by(kMaterials, &Material::name, name); }

}  // namespace

std::span<const Material> material_table() { return kMaterials; }

const Material& usual_material(ProcessKind kind) {
    switch (kind) {
        case ProcessKind::kFdm:
            return *find("pla");
        case ProcessKind::kSla:
            return *find("resin");
        case ProcessKind::kSls:
            return *find("pa12");
        case ProcessKind::kMill:
        case ProcessKind::kMill4:
            return *find("aluminium");
        default:
            return *find("steel");
    }
}

Material material_of(const Process& process) {
    const MaterialOptions& stated = process.material;
    Material m = usual_material(process.kind);
    if (stated.kind != kByProcess) {
        const Material* known = find(stated.kind);
        if (known == nullptr) throw core::InvalidInput("material.kind", stated.kind, "by_process, or a material of docs/rules.md, table 5");
        m = *known;
    }
    if (stated.strength > 0.0) {
        const double share = stated.strength / m.strength;
        m.strength *= share, m.permanent *= share, m.bearing *= share;
    }
    if (stated.modulus > 0.0) {
        m.creep_modulus *= stated.modulus / m.modulus;
        m.modulus = stated.modulus;
    }
    if (stated.density > 0.0) m.density = stated.density;
    return m;
}

std::string designation_of(const Process& process) {
    return process.material.designation.empty() ? material_of(process).designation : process.material.designation;
}

double bearing_strength(const Design& design) {
    return design.cable.max_pressure > 0.0 ? design.cable.max_pressure : material_of(design.process).bearing;
}

std::string bearing_origin(const Design& design) {
    return design.cable.max_pressure > 0.0 ? "as stated (cable.max_pressure_MPa)" : std::string("of ") + material_of(design.process).name;
}

}  // namespace fusee::checks
