#include <iterator>

#include "fusee/checks/limits.h"
#include "fusee/formats/format.h"
#include "key.h"

namespace fusee::profile {

namespace {

std::vector<Key> cable_keys() {
    return {
        required(number("cable.diameter_mm", within(0.05, 20), "d, of the cable under load", FIELD(cable.diameter))),
        choice("cable.construction", {"fibre", "7x7", "7x19", "7x49"}, "sets the default bend ratio", FIELD(cable.construction)),
        number("cable.min_bend_ratio", or_zero(1, 200), "least D/d, D = diameter of the groove's floor; 0 = by construction",
               FIELD(cable.min_bend_ratio)),
        number("cable.breaking_load_N", or_zero(1, 1e6), "0 = estimated by construction and diameter", FIELD(cable.breaking_load)),
        number("cable.max_pressure_MPa", or_zero(0.1, 2000), "allowed bearing pressure 2T/(D d) of the part's material; 0 = by material",
               FIELD(cable.max_pressure)),
        number("cable.max_fleet_deg", or_zero(0.01, 20), "angle between the free cable and the groove's plane; 0 = 2 deg, grooved",
               FIELD(cable.max_fleet)),
        choice("cable.termination", {"knot", "crimp", "splice"}, "what holds the cable's end behind its anchor hole",
               FIELD(cable.termination)),
        number("cable.friction", within(0, 2), "of the cable on its cams; with cable.stiffness_N: loops in `fusee simulate`; 0 = none",
               FIELD(wrap.friction)),
        number("cable.stiffness_N", within(0, 1e8),
               "E A: tension over relative stretch; with k_se.cable_length_mm and k_pe.cable_length_mm in the law; 0 = unknown",
               FIELD(wrap.stiffness)),
        number("groove.radius_ratio", within(0.5, 2), "radius of the round floor over d", FIELD(k_se.solid.groove.radius_ratio)),
        number("groove.depth_ratio", within(0.1, 10), "height of the lips above the floor, in d", FIELD(k_se.solid.groove.depth_ratio)),
        number("groove.throat_deg", within(0, 150), "full angle between the flanks", FIELD(k_se.solid.groove.throat)),
        number("groove.rib_mm", within(0.1, 100), "flange next to the groove (planar), least land between turns (helix)",
               FIELD(k_se.solid.groove.rib)),
        number("groove.plate_mm", within(0, 100), "stack of plates: thickness of the middle one, the groove's width; 0 = two floor radii",
               FIELD(k_se.solid.groove.plate)),
    };
}

Key build_volume() {
    Key key;
    key.path = "process.build_mm";
    key.kind = Kind::kNumbers;
    key.meaning = "build volume or stock: x, y, z";
    key.unit = unit_of(key.path);
    key.limits = above(0, 1e4);
    key.least_count = key.most_count = 3;
    key.get = [](const Profile& p) { return Value(std::vector<double>{p.process.build_x, p.process.build_y, p.process.build_z}); };
    key.set = [](Profile& p, const Value& v) {
        const auto& xyz = std::get<std::vector<double>>(v);
        p.process.build_x = xyz[0];
        p.process.build_y = xyz[1];
        p.process.build_z = xyz[2];
    };
    return key;
}

std::vector<Key> process_keys() {
    return {
        required(choice("process.kind", {"fdm", "sla", "sls", "mill", "mill4", "edm", "laser"},
                        "sets the defaults of the limits below; mill4: a fourth axis; edm, laser: stacked plates", FIELD(process.kind))),
        build_volume(),
        number("process.min_wall_mm", or_zero(0.01, 100), "0 = by process", FIELD(process.min_wall)),
        number("process.min_hole_mm", or_zero(0.01, 100), "diameter; 0 = by process", FIELD(process.min_hole)),
        number("process.max_overhang_deg", or_zero(0.1, 90), "of a downward face, from the vertical; 0 = by process",
               FIELD(process.max_overhang)),
        number("process.cutter_radius_mm", or_zero(0.005, 100),
               "smallest available ball or end mill; edm: wire radius and gap; laser: half the kerf; 0 = by process",
               FIELD(process.cutter_radius)),
        number("process.layer_mm", or_zero(0.001, 10), "height of a printed layer; 0 = by process", FIELD(process.layer)),
        number("process.tolerance_mm", or_zero(0.001, 10), "of a contour, one side; 0 = by process", FIELD(process.tolerance)),
        number("tolerances.chordal_error_mm", within(1e-4, 1), "largest distance between the exported mesh and the exact surface",
               FIELD(k_se.solid.chordal_error)),
    };
}

std::vector<Key> material_keys() {
    std::vector<std::string> kinds{checks::kByProcess};
    for (const checks::Material& material : checks::material_table()) kinds.emplace_back(material.name);
    return {
        choice("material.kind", std::move(kinds), "of both parts; by_process: the process's usual one", FIELD(process.material.kind)),
        number("material.strength_MPa", or_zero(1, 5000), "tensile strength of a plastic, yield strength of a metal; 0 = by kind",
               FIELD(process.material.strength)),
        number("material.modulus_MPa", or_zero(1, 1e6), "Young's modulus; 0 = by kind", FIELD(process.material.modulus)),
        number("material.density_g_per_cm3", or_zero(0.01, 30), "0 = by kind", FIELD(process.material.density)),
        text_line("material.designation", "with its condition, for drawing and STEP: \"EN AW-6082 T6\"; \"\" = by kind",
                  FIELD(process.material.designation)),
    };
}

/// The list of formats is that of the files in src/formats.
Key formats_key() {
    Key key;
    key.path = "outputs.formats";
    key.kind = Kind::kChoices;
    key.meaning = "part files to write";
    for (const formats::Format& format : formats::all_formats()) {
        key.choices.emplace_back(format.name);
        if (*format.meaning != '\0') key.meaning += std::string("; ") + format.name + ": " + format.meaning;
    }
    key.most_count = key.choices.size();
    key.get = [](const Profile& p) { return Value(p.outputs.formats); };
    key.set = [names = key.choices](Profile& p, const Value& v) {
        const auto& chosen = std::get<std::vector<std::string>>(v);
        p.outputs.formats.clear();
        std::copy_if(names.begin(), names.end(), std::back_inserter(p.outputs.formats),
                     [&](const std::string& name) { return std::find(chosen.begin(), chosen.end(), name) != chosen.end(); });
    };
    return key;
}

/// What the profile describes.
Key kind_key() {
    Key key;
    key.path = "kind";
    key.kind = Kind::kChoice;
    key.meaning = "joint: both springs and their rig; spring: one spring, with [law] and [cam], no rig";
    key.choices = {"joint", "spring"};
    key.get = [](const Profile& p) { return Value(std::string(p.is_spring() ? "spring" : "joint")); };
    key.set = [](Profile& p, const Value& v) {
        if (std::get<std::string>(v) == "spring") p.law.curves = OneSpring{};
    };
    return key;
}

std::vector<Key> all_keys() {
    std::vector<Key> all;
    const auto add = [&all](std::vector<Key> more) { std::move(more.begin(), more.end(), std::back_inserter(all)); };
    const auto add_joint = [&add](std::vector<Key> more) { add(all_of(Key::Of::kJoint, std::move(more))); };
    add({required(name_key("name", "the design's name and that of its folder under out/", FIELD(name))), kind_key()});
    for (const auto table : {rig_keys, law_keys, simulation_keys, design_keys, codesign_keys}) add_joint(table());
    add(one_spring_keys());
    add(cable_keys());
    add(process_keys());
    add(material_keys());
    add({formats_key(),
         all_of(Key::Of::kJoint,
                {yes_or_no("outputs.pair", "both sides of the joint: the antagonist's parts are mirror images", FIELD(outputs.pair))})
             .front(),
         yes_or_no("outputs.plate", "with 3mf: also plate.3mf, every part on one plate within process.build_mm", FIELD(outputs.plate)),
         number("outputs.kerf_mm", within(0, 10), "of a beam or wire; above 0: also k_xx_kerf.dxf, outlines moved by half of it",
                FIELD(outputs.kerf)),
         integer("outputs.springs_rows", within(200, 100000), "rows of springs.csv", FIELD(outputs.springs_rows))});
    add(machining_keys());
    add(compensation_keys());
    for (const char* part : {"k_se", "k_pe"}) add_joint(part_keys(part));
    add(all_of(Key::Of::kSpring, part_keys("cam")));
    add_joint(assembly_keys());
    add(budget_keys());
    add(drawing_keys());
    return all;
}

}  // namespace

const std::vector<Key>& keys() {
    static const std::vector<Key> all = all_keys();
    return all;
}

}  // namespace fusee::profile
