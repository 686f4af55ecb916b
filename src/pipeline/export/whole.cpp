#include "whole.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "design/words.h"
#include "fusee/assembly/motion.h"
#include "fusee/assembly/to_make.h"
#include "fusee/checks/limits.h"
#include "fusee/checks/support.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/readback/readback.h"
#include "fusee/solid/arrange.h"
#include "fusee/spring/law.h"
#include "judge.h"

namespace fusee::pipeline {

namespace {

constexpr double kAllowed = 1e-3;  // of the largest torque, as readback.arm allows of an arm

/// Torques of one cable by the arms of a file [Nm], by rising cam angle.
std::vector<double> torques_by(const PartReport& part, const readback::ArmError& reading, const cam::Allowance& allowance) {
    std::vector<double> all;
    for (std::size_t i = 0; i < reading.arms_mm.size(); ++i)
        all.push_back(part.part->cam.working[i].arm.tension * (core::m_from_mm(reading.arms_mm[i]) + allowance.on_arms()));
    return all;
}

/// The law's torque by one reading of each part; both have as many rows, evenly over the same travel.
std::vector<double> difference(const DesignReport& report, const ResolvedDesign& design, const readback::ArmError& forth,
                               const readback::ArmError& back) {
    std::vector<double> found = torques_by(report.parts[0], forth, design.ways[0].profile.k_pe.allowance);
    const std::vector<double> against = torques_by(report.parts[1], back, design.ways[1].profile.k_pe.allowance);
    for (std::size_t i = 0; i < found.size(); ++i) found[i] -= against[against.size() - 1 - i];
    return found;
}

core::Finding judge(const TorqueOfBoth& of, const std::vector<double>& found, const readback::ArmError& forth,
                    const readback::ArmError& back) {
    double largest = 0.0, worst = 0.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < of.wanted.size(); ++i) {
        largest = std::max(largest, std::abs(of.wanted[i]));
        const double error = std::abs(found[i] - of.wanted[i]);
        if (!(error <= worst)) worst = error, at = i;  // NaN is the worst
    }
    core::Finding f;
    f.rule = "readback.torque";
    f.what = fmt::format("the difference of both cables' torques, recomputed from {} and {} (read by {}), must be the law's", forth.file,
                         back.file, forth.reader);
    f.measured = 100.0 * worst / largest;
    f.bound = core::Bound::kAtMost;
    f.allowed = 100.0 * kAllowed;
    f.unit = "%";
    f.where =
        fmt::format("law at {:.1f} deg, of the largest torque, worst of {} angles", core::deg_from_rad(of.angle[at]), of.angle.size());
    f.suggestion = "a smaller tolerances.chordal_error_mm, or a smaller cam.least_torque_Nm";
    f.source = "docs/part-file.md: arms and tensions of both parts";
    return core::judged(std::move(f), forth.when_broken);
}

using assembly::Assembly, assembly::Body;

/// The part's solid or that of its mirror image, which is the antagonist's unless K_PE's is the agonist's. Refusal without findings: the
/// part has none.
core::Outcome<exchange::brep::Brep> exact_cam(const Assembly& joint, const Body& body, const ExactSolids& parts) {
    const auto designed = parts.find(body.base_name()), image = parts.find(body.base_name() + "_mirrored");
    if (designed == parts.end()) return core::Findings{};
    const bool swapped = joint.drive.k_pe_mirrored && body.base_name() == "k_pe";
    if ((body.side == assembly::Side::kAgonist) != swapped) return designed->second;
    return image != parts.end() ? image->second : exchange::brep::mirrored(designed->second);
}

core::Outcome<std::vector<exchange::StepInstance>> instances_of(const Assembly& joint, const ExactSolids& parts) {
    std::vector<exchange::StepInstance> all;
    for (const Body& body : joint.bodies) {
        auto exact = body.cam ? exact_cam(joint, body, parts) : exchange::brep::extruded(body.shapes);
        if (!exact) {
            core::Findings refusal = exact.refusal();
            for (core::Finding& f : refusal) {
                f.what = "assembly.step is not written: " + f.what;
                f.where = body.name;
                f.severity = core::Severity::kWarning;  // the parts have their own files
            }
            return refusal;
        }
        all.push_back({body.name, std::move(exact).value().shape, placement(joint, body, {}), colour_of(body)});
    }
    return all;
}

std::vector<exchange::NamedMesh> objects_of(const Assembly& joint) {
    std::vector<exchange::NamedMesh> all;
    for (const Body& body : joint.bodies) all.push_back({body.name, placed_mesh(joint, body, {}), colour_of(body)});
    return all;
}

/// The sheet of a body that has to be made.
void write_sheet(const Assembly& joint, const Body& body, const std::string& name, const profile::Profile& profile,
                 const core::Provenance& provenance, const fs::path& folder, JointFiles& out) {
    const drawing::Sheet sheet =
        drawing::draw_sheet({*joint.drive.k_pe, joint.drive.k_pe_spring, joint.drive.cable, assembly::process_of(joint, body), profile.name,
                             name, provenance.line(), profile.title},
                            assembly::sheet_of(joint, body));
    if (profile.outputs.has("drawing"))
        for (const fs::path& svg : drawing::write_svg(folder / (name + "_drawing"), {sheet})) out.files.push_back(file_row(svg));
    if (!profile.outputs.has("pdf")) return;
    const fs::path pdf = folder / (name + "_drawing.pdf");
    core::write_file(pdf, drawing::pdf({sheet}));
    out.files.push_back(file_row(pdf));
}

/// Files and sheets of the bodies beside the cams that have to be made; of a pair their mirror images, too.
void write_bodies(const Assembly& joint, const profile::Profile& profile, const core::Provenance& provenance, const fs::path& folder,
                  JointFiles& out) {
    for (const Body* body : assembly::bodies_to_make(joint)) {
        const bool antagonist = body->side == assembly::Side::kAntagonist;
        if (!profile.outputs.pair && antagonist) continue;
        const std::string name = body->base_name() + (antagonist ? "_mirrored" : "");
        if (profile.outputs.has("drawing") || profile.outputs.has("pdf")) write_sheet(joint, *body, name, profile, provenance, folder, out);
        if (!profile.outputs.has("stl")) continue;
        const solid::Mesh mesh = assembly::mesh_on_bed(joint, *body);
        const fs::path stl = folder / (name + ".stl");
        exchange::write_stl(stl, mesh, provenance.line());
        out.files.push_back(file_row(stl, mesh.triangles.size()));
    }
}

constexpr double kSpacing_mm = 5.0;     // between skirts of neighbours (practice)
constexpr double kSupported_mm = 10.0;  // the supports' first layer reaches 4 mm beyond a part (PrusaSlicer 2.5)

/// Between neighbours on the bed.
double spacing_mm(const checks::Process& process) { return checks::process_limits(process).overhang > 0.0 ? kSupported_mm : kSpacing_mm; }

std::array<double, 3> build_mm(const checks::Process& process) {
    return {core::mm_from_m(process.build_x), core::mm_from_m(process.build_y), core::mm_from_m(process.build_z)};
}

core::Finding too_small(const std::vector<solid::Size2>& sizes, const std::array<double, 3>& build, double spacing) {
    const double factor = solid::least_bed(sizes, {build[0], build[1]}, spacing);
    const double x = std::ceil(factor * build[0]), y = std::ceil(factor * build[1]);
    core::Finding f;
    f.rule = "plate.bed";
    f.what = fmt::format("{} parts, {:g} mm apart, do not fit on one bed of {:g} x {:g} mm: plate.3mf is not written", sizes.size(),
                         spacing, build[0], build[1]);
    f.measured = x;
    f.bound = core::Bound::kAtMost;
    f.allowed = build[0];
    f.unit = "mm";
    f.where = "bed along x";
    f.suggestion = core::change("process.build_mm", fmt::format("[{:g}, {:g}, {:g}]", x, y, build[2]))
                       .or_else("print the parts one by one from their own files");
    f.source = "process.build_mm; quarter turns about z allowed";
    return core::judged(f, core::Severity::kWarning);
}

/// Printed parts stand on the side that needs less support; without a limit for overhangs, on either side.
bool stands_on_top(const ExportedPart& part, const checks::Process& process) {
    const double overhang = checks::process_limits(process).overhang;
    return overhang > 0.0 && checks::prints_on_its_top(part.mesh, overhang);
}

/// The objects as they stand, in the middle of the bed.
struct Arranged {
    std::vector<exchange::PlateObject> places;
    std::vector<exchange::NamedMesh> objects;
};
Arranged stand(const std::vector<ExportedPart>& parts, const std::vector<solid::Spot>& spots, const checks::Process& process) {
    const std::array<double, 3> build = build_mm(process);
    Arranged all;
    solid::Size2 reach{};  // of the group from the bed's corner
    for (std::size_t i = 0; i < parts.size(); ++i) {
        exchange::PlateObject place{parts[i].name, spots[i].turned, {}, stands_on_top(parts[i], process)};
        const solid::Box box = solid::bounding_box(exchange::placed(parts[i].mesh, place));
        for (std::size_t k = 0; k < 2; ++k) {
            place.moved_mm[k] = spots[i].corner_mm[k] - box.low_mm[k];
            reach[k] = std::max(reach[k], spots[i].corner_mm[k] + box.high_mm[k] - box.low_mm[k]);
        }
        place.moved_mm[2] = -box.low_mm[2];
        all.places.push_back(place);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) all.places[i].moved_mm[k] += 0.5 * (build[k] - reach[k]);
        all.objects.push_back({parts[i].name, exchange::placed(parts[i].mesh, all.places[i])});
    }
    return all;
}

exchange::Plate write(const Arranged& all, const std::array<double, 3>& build, double spacing, double chordal_error_mm,
                      const std::string& provenance, const fs::path& folder, PlateFiles& out) {
    const fs::path three_mf = folder / "plate.3mf", json = folder / "plate.json";
    std::size_t triangles = 0;
    for (const exchange::NamedMesh& object : all.objects) triangles += object.mesh.triangles.size();
    exchange::write_3mf(three_mf, all.objects, provenance);
    out.files.push_back(file_row(three_mf, triangles, chordal_error_mm));
    exchange::write_plate_file(json, {out.files.front().entry, build, spacing, all.places, provenance});
    out.files.push_back(file_row(json));
    return exchange::read_plate_file(json);
}

}  // namespace

core::Range law_angles(const ResolvedDesign& design) {
    const double first = std::get<profile::OneSpring>(design.profile.law.curves).first_angle();
    return {first, first + design.law()->angles().width()};
}

void judge_both_ways(DesignReport& report, const ResolvedDesign& design) {
    TorqueOfBoth of;
    for (const cam::Contact& c : report.parts[0].part->cam.working) {
        of.angle.push_back(law_angles(design).low + c.arm.angle);
        of.wanted.push_back(design.law()->at_angle(c.arm.angle).tau);
        of.forth.push_back(design.ways[0].law()->at_angle(c.arm.angle).tau);
        of.back.push_back(design.ways[1].law()->at_angle(law_angles(design).width() - c.arm.angle).tau);
    }
    for (const readback::ArmError& forth : report.parts[0].arm_errors) {
        const std::string ending = forth.file.substr(report.parts[0].name.size());
        for (const readback::ArmError& back : report.parts[1].arm_errors) {
            if (back.file != report.parts[1].name + ending || back.reader != forth.reader) continue;
            const std::vector<double> found = difference(report, design, forth, back);
            report.findings.push_back(judge(of, found, forth, back));
            if (of.found.empty()) of.found = found;
        }
    }
    report.of_both = std::move(of);
}

JointFiles write_joint(const Assembly& joint, const ExactSolids& parts, const profile::Profile& profile, const core::Provenance& provenance,
                       const fs::path& folder) {
    JointFiles out;
    if (profile.outputs.has("step")) {
        const auto instances = instances_of(joint, parts);
        if (instances) {
            const fs::path step = folder / "assembly.step";
            exchange::write_step_assembly(step, *instances, profile.name, provenance.line());
            out.files.push_back(file_row(step));
        } else {
            core::append(out.findings, instances.refusal());
        }
    }
    if (profile.outputs.has("3mf")) {
        const fs::path three_mf = folder / "assembly.3mf";
        const std::vector<exchange::NamedMesh> objects = objects_of(joint);
        std::size_t triangles = 0;
        for (const exchange::NamedMesh& object : objects) triangles += object.mesh.triangles.size();
        exchange::write_3mf(three_mf, objects, provenance.line());
        out.files.push_back(file_row(three_mf, triangles));
    }
    if (const Body* plate = joint.find("frame_plate"); plate != nullptr && profile.outputs.has("dxf")) {
        const fs::path dxf = folder / "frame_plate.dxf";
        exchange::write_dxf(dxf, exchange::plate_drawing(plate->shapes.front(), provenance.line()));
        out.files.push_back(file_row(dxf));
    }
    write_bodies(joint, profile, provenance, folder, out);
    return out;
}

PlateFiles write_plate(const std::vector<ExportedPart>& parts, const profile::Profile& profile, const core::Provenance& provenance,
                       const fs::path& folder) {
    PlateFiles out;
    if (!profile.outputs.plate || !profile.outputs.has("3mf")) return out;
    const std::array<double, 3> build = build_mm(profile.process);
    std::vector<solid::Size2> sizes;
    double chordal_error_mm = 0.0;
    for (const ExportedPart& part : parts) {
        const solid::Box box = solid::bounding_box(part.mesh);
        sizes.push_back({box.high_mm[0] - box.low_mm[0], box.high_mm[1] - box.low_mm[1]});
        chordal_error_mm = std::max(chordal_error_mm, part.report.part->chordal_error_mm);
    }
    const double spacing = spacing_mm(profile.process);
    const auto spots = solid::arrange(sizes, {build[0], build[1]}, spacing);
    if (!spots) {
        out.findings.push_back(too_small(sizes, build, spacing));
        return out;
    }
    const exchange::Plate plate =
        write(stand(parts, *spots, profile.process), build, spacing, chordal_error_mm, provenance.line(), folder, out);
    out.arm_errors = readback::read_back_plate(folder, plate);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        core::Finding& f = out.findings.emplace_back(judge_arm(out.arm_errors[i], parts[i].report.part->cam));
        if (profile.has_two_cables())
            f.where.replace(0, std::string_view(to_string(cam::PartKind::kParallel)).size(), parts[i].report.name);
    }
    out.findings = in_words_of(profile, std::move(out.findings));
    return out;
}

}  // namespace fusee::pipeline
