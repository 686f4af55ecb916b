#include "joint_files.h"

#include "fusee/assembly/motion.h"
#include "fusee/assembly/to_make.h"
#include "fusee/core/file.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

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

}  // namespace

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

}  // namespace fusee::pipeline
