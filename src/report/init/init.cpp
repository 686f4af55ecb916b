#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/assembly/to_make.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/report/search.h"
#include "fusee/spring/coil.h"
#include "init/cost.h"

namespace fusee::report {

namespace {

using core::mm_from_m;

/// A word for the shell, quoted only where it must be.
std::string word(const std::string& text) {
    const auto plain = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-' || c == '/'); };
    return !text.empty() && text[0] != '-' && std::all_of(text.begin(), text.end(), plain) ? text : core::shell_word(text);
}

std::string coil_line(const char* part, const char* kind, const spring::BaseSpring& s) {
    return fmt::format("  {}: {} spring, wire {:g} mm, mean coil {:g} mm, {:g} turns, length {:g} mm\n", part, kind,
                       mm_from_m(s.wire_diameter), mm_from_m(s.coil_diameter), s.active_coils, mm_from_m(s.free_length));
}

std::string dead_band_range_text(const pipeline::ResolvedDesign& design, double tau) {
    return fmt::format("{:.1f} deg at {:g} Nm", core::deg_from_rad(actuator::dead_band(design.actuator, tau).exact_width), tau);
}

constexpr std::size_t kMostNamed = 4;   // springs of a catalogue
constexpr std::size_t kRepairStep = 8;  // rows of the file for one of the table

/// Largest distance of a cam's surface from its axis, doubled [mm].
double diameter_mm(const solid::Mesh& mesh) {
    double largest = 0.0;
    for (const solid::Vec3& p : mesh.points_mm) largest = std::max(largest, std::hypot(p[0], p[1]));
    return 2.0 * largest;
}

/// The joint's box at rest, with its frame, without motors.
std::string box_text(const assembly::Assembly& joint) {
    solid::Mesh all;
    for (const assembly::Body& body : joint.bodies) {
        const solid::Mesh one = assembly::moved(body.mesh(), body.rest);
        all.points_mm.insert(all.points_mm.end(), one.points_mm.begin(), one.points_mm.end());
    }
    const solid::Box box = solid::bounding_box(all);
    const auto side = [&box](std::size_t i) { return box.high_mm.at(i) - box.low_mm.at(i); };
    return fmt::format("  the joint at rest, without motors: {:.0f} x {:.0f} x {:.0f} mm\n", side(0), side(1), side(2));
}

/// "; 13 more pieces, 300 cm3, 370 g if solid; 1 of aluminium, ...": beside the cams, by material.
std::string pieces_text(const assembly::Assembly& joint) {
    struct Pieces {
        checks::Material material;
        int count = 0;
        double mm3 = 0.0;
    };
    std::map<std::string, Pieces> made;
    for (const assembly::Body* body : assembly::bodies_to_make(joint)) {
        const checks::Material material = assembly::material_of(joint, *body);
        Pieces& pieces = made[material.name];
        pieces.material = material, ++pieces.count, pieces.mm3 += solid::volume_mm3(body->mesh());
    }
    const std::string of_cams = checks::material_of(joint.drive.process).name;
    std::string text;
    if (const auto own = made.find(of_cams); own != made.end())
        text += fmt::format("; {} more pieces, {}", own->second.count, solid_amount(own->second.mm3, own->second.material));
    for (const auto& [name, pieces] : made)
        if (name != of_cams) text += fmt::format("; {} of {}, {}", pieces.count, name, solid_amount(pieces.mm3, pieces.material));
    return text;
}

/// What the joint costs in material, both sides.
std::string cost_text(const profile::Profile& p, double cams_mm3, const assembly::Assembly* joint) {
    double wire = 0.0, steel = 0.0, cable_mm = 0.0;
    for (const spring::BaseSpring* s : {&p.k_se.spring, &p.k_pe.spring}) {
        const double both = 2.0 * spring::wire_length(*s);
        wire += both;
        steel += spring::wire_mass(*s, both);
    }
    const checks::Material material = checks::material_of(p.process);
    std::string text =
        fmt::format("  cost of both sides in material:\n    4 cams of {}, {}", material.name, solid_amount(2.0 * cams_mm3, material));
    if (joint) {
        text += pieces_text(*joint);
        for (const assembly::Cable& cable : joint->cables) cable_mm += cable.cut_mm();
    }
    text += fmt::format("\n    4 springs of {:.1f} m of wire, {:.0f} g", wire, steel * 1e3);
    if (joint) text += fmt::format("; {:.1f} m of cable; what else to buy: bom.csv", cable_mm * 1e-3);
    return text + fmt::format("\n    {}\n", kNoPrices);
}

/// Sizes, torque from outside and cost.
std::string size_text(const profile::Profile& p) {
    pipeline::Evaluation seen = pipeline::evaluate(p, pipeline::Depth::kSolid);
    std::string text = fmt::format("  diameters: capstan {:.4g} mm, the joint's pulley {:.4g} mm", 2.0 * mm_from_m(p.rig.capstan_radius),
                                   2.0 * mm_from_m(p.rig.joint_radius));
    std::vector<std::shared_ptr<const solid::Part>> made;
    double cams_mm3 = 0.0;
    for (pipeline::EvaluatedPart& part : seen.parts) {
        if (part.reached < pipeline::Depth::kSolid || !part.body) return text + "\n";
        text += fmt::format(", {} {:.3g} mm", to_string(part.kind), diameter_mm(part.body->mesh));
        cams_mm3 += solid::volume_mm3(part.body->mesh);
        made.push_back(std::make_shared<const solid::Part>(*std::move(part.body)));
    }
    const pipeline::Assembled joint = pipeline::assemble(*seen.design, made.at(0), made.at(1));
    if (joint.assembly) text += "\n" + box_text(*joint.assembly);
    text += fmt::format("  greatest torque from outside within the laws of the springs: {:.3g} Nm\n",
                        pipeline::simulate(*seen.design, {.levels = 2}).survey.torque);
    return text + cost_text(p, cams_mm3, joint.assembly.get());
}

std::string figures(const search::init::Design& found) {
    const profile::Profile& p = found.profile;
    const auto design = pipeline::resolve(p);
    std::string text;
    if (design) {
        text += fmt::format("  dead-band, full width at the joint: {}", dead_band_range_text(*design, p.rig.least_torque));
        for (const double torque : std::set<double>{p.rig.peak_torque, p.rig.overdrive_torque})
            text += ", " + dead_band_range_text(*design, torque);
        text += "\n";
    }
    text += size_text(p);
    text += coil_line("K_SE", "torsion", p.k_se.spring) + coil_line("K_PE", "compression", p.k_pe.spring);
    if (p.k_se.solid.features.leg_slot_width <= 0.0)
        text +=
            "  K_SE has no slot for its spring's leg, since the coil is narrower than bore and wall: put the spring on a shaft of its "
            "own, or choose a thinner --shaft\n";
    return text;
}

std::string open_findings(const core::Findings& findings) {
    std::string text = fmt::format("  {} to review, {} not judged; fusee make lists them\n",
                                   core::counted(core::count(findings, core::Severity::kWarning), "warning"),
                                   core::counted(core::count(findings, core::Severity::kNotJudged), "rule"));
    return text;
}

/// Energy that both springs hold, and which springs can.
std::string stores_text(const std::vector<search::init::Store>& stores) {
    std::string text;
    for (const search::init::Store& store : stores) {
        text += fmt::format("  {} holds {:.3g} J of work and {:.2g} J of preload: ", to_string(store.part), store.work, store.preload);
        text += store.least_wire > 0.0 ? fmt::format("wound of wire from {:g} mm on", mm_from_m(store.least_wire))
                                       : "no wire up to 5 mm holds it";
        if (store.offered > 0) text += fmt::format("; of the catalogue {} of {} springs", store.bought.size(), store.offered);
        for (std::size_t i = 0; i < std::min(kMostNamed, store.bought.size()); ++i)
            text += (i == 0 ? ": " : ", ") + core::printable(store.bought[i], 40);
        text += store.bought.size() > kMostNamed ? ", ...\n" : "\n";
    }
    return text;
}

std::string other_text(const core::Changes& changes) {
    const auto text = [](const core::Change& c) { return fmt::format("{} {} instead of {}", c.key, word(c.value), word(c.was)); };
    return core::listed(changes, text, ", and ");
}

std::string levers_text(const search::init::Result& result) {
    if (!result.at_once) return "";
    if (result.levers.empty()) return "no change of a single answer meets this\n";
    std::string text = "each of these alone meets it, the smallest change first; other limits come after it:\n";
    for (const search::init::OtherAnswers& lever : result.levers) text += "  " + other_text(lever.changes) + "\n";
    return text;
}

std::string nearest_text(const search::init::Result& result, const std::string& file, const std::string& more) {
    if (!result.nearest)
        return result.at_once && result.levers.size() > 1
                   ? "none of these alone leads to a joint that can be made: change two of them; nothing is written\n"
                   : "no joint that can be made was found near these answers; nothing is written\n";
    const search::init::OtherAnswers& n = *result.nearest;
    return fmt::format("nearest joint that can be made: {}\n  fusee init {} {}{}\nnothing is written\n", other_text(n.changes), word(file),
                       n.options, more);
}

std::string change_line(const char* column, const search::init::Repair::Change& change) {
    return fmt::format("  {}: {:+.3g} to {:+.3g} Nm, root mean square over the angle {:.3g} Nm\n", column, change.least, change.greatest,
                       change.mean);
}

bool is_changed(const search::init::Repair& r) { return r.series_change().mean > 0.0 || r.parallel_change().mean > 0.0; }

/// The changed law beside the wanted one.
std::string repair_text(const search::init::Result& result) {
    if (!result.repair) return "";
    const search::init::Repair& r = *result.repair;
    std::string text = fmt::format("the law was {} so that it can be made; beyond {:.4g} to {:.4g} rad the wanted one is not measured:\n",
                                   is_changed(r) ? "changed" : "continued", r.measured.low, r.measured.high);
    if (is_changed(r)) text += change_line("series_Nm", r.series_change()) + change_line("parallel_Nm", r.parallel_change());
    text += fmt::format("  {:>9}  {:>9} {:>9}  {:>11} {:>9}\n", "angle_rad", "series_Nm", "wanted", "parallel_Nm", "wanted");
    for (std::size_t i = 0; i < r.law.angle.size(); i += kRepairStep)
        text += fmt::format("  {:9.4f}  {:9.4f} {:9.4f}  {:11.4f} {:9.4f}{}\n", r.law.angle[i], r.law.series[i], r.wanted_series[i],
                            r.law.parallel[i], r.wanted_parallel[i], r.measured.holds(r.law.angle[i]) ? "" : "  continued");
    return text;
}

}  // namespace

std::string solid_amount(double mm3, const checks::Material& material) {
    return fmt::format("{:.3g} cm3, {:.0f} g if solid", 1e-3 * mm3, mm3 * 1e-9 * material.density * 1e3);
}

std::string init_summary(const search::init::Result& result) {
    return "this joint can be made:\n" + repair_text(result) + figures(*result.design) + stores_text(result.stores) +
           open_findings(result.design->findings);
}

std::string init_refusal(const search::init::Result& result) {
    std::string text = "this joint cannot be made; the limits that bind:\n";
    for (std::size_t i = 0; i < std::min<std::size_t>(3, result.binding.size()); ++i)
        text += "  " + core::to_line(result.binding[i]) + "\n";
    return text + stores_text(result.stores) + levers_text(result);
}

std::string init_text(const search::init::Result& result, const std::string& file, const std::string& more) {
    if (!result.design) return init_refusal(result) + nearest_text(result, file, more);
    return fmt::format("written: {}\n{}{}{}{}next:\n  fusee make {}\n  fusee watch {}\n", core::printable(file), repair_text(result),
                       figures(*result.design), stores_text(result.stores), open_findings(result.design->findings), word(file), word(file));
}

}  // namespace fusee::report
