#include "json/json.h"

#include <nlohmann/json.hpp>

#include "design/as_exported.h"
#include "design/cam_figures.h"
#include "design/stretch.h"
#include "fusee/report/report.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

Json range(const core::Range& r) { return Json::array({r.low, r.high}); }

Json misfit_json(const SmoothedTable::Misfit& misfit) {
    return {{"rms_Nm", misfit.rms}, {"largest_Nm", misfit.largest}, {"largest_in_row", misfit.row}};
}

Json table_json(const SmoothedTable& table) {
    Json rows = Json::array();
    for (const TableRow& r : table.rows) rows.push_back({r.angle, r.series, r.series_smooth, r.parallel, r.parallel_smooth});
    return {{"file", table.file},
            {"series", misfit_json(table.series())},
            {"parallel", misfit_json(table.parallel())},
            {"columns", {"angle_rad", "series_Nm", "series_smoothed_Nm", "parallel_Nm", "parallel_smoothed_Nm"}},
            {"rows", std::move(rows)}};
}

Json law_json(const LawReport& law) {
    Json j;
    if (!law.samples.empty()) {
        j["loads_Nm"] = {law.samples.front().tau, law.samples.back().tau};
        j["angles_rad"] = {law.samples.front().theta, law.samples.back().theta};
    }
    j["design_loads_Nm"] = range(law.design_loads);
    j["lead_in_travel_rad"] = law.lead_in_travel;
    j["least_feasible_start_Nm"] = law.least_feasible_start;
    j["stiction_loads_Nm"] = range(law.stiction_loads);
    j["covers_stiction"] = law.covers_stiction();
    if (law.table) j["table"] = table_json(*law.table);
    return j;
}

Json dead_band_json(const actuator::DeadBand& d) {
    return {{"tau_Nm", d.tau},
            {"theta_rad", d.theta},
            {"linear_rad", d.linear},
            {"exact_rad", d.exact_width},
            {"covered", d.covered},
            {"joint_stiffness_Nm_per_rad", d.joint_stiffness},
            {"free_joint_stiffness_Nm_per_rad", d.free_joint_stiffness},
            {"condition_6", d.condition_6}};
}

Json files_json(const std::vector<FileRow>& files) {
    Json all = Json::array();
    for (const FileRow& file : files)
        all.push_back({{"name", file.entry.name},
                       {"bytes", file.bytes},
                       {"sha256", file.entry.sha256},
                       {"triangles", file.entry.triangles},
                       {"chordal_error_mm", file.entry.chordal_error_mm}});
    return all;
}

Json read_back_json(const std::vector<readback::ArmError>& errors) {
    Json all = Json::array();
    for (const readback::ArmError& e : errors)
        all.push_back({{"file", e.file},
                       {"reader", e.reader},
                       {"rows", e.rows},
                       {"worst_relative", e.worst_relative},
                       {"worst_angle_rad", e.worst_angle_rad},
                       {"allowed", e.allowed},
                       {"passed", e.passed()}});
    return all;
}

Json spring_json(const spring::BaseSpring& s, const CamFigures& cam) {
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    return {{"kind", torsion ? "torsion" : "compression"},
            {torsion ? "rate_Nm_per_rad" : "rate_N_per_m", s.rate},
            {torsion ? "preload_rad" : "preload_m", s.preload},
            {torsion ? "states_rad" : "states_m", range(cam.states)},
            {torsion ? "torques_Nm" : "forces_N", {s.rate * cam.states.low, s.rate * cam.states.high}}};
}

Json cam_json(const solid::Part& part, const CamFigures& cam) {
    return {{"family", cam::to_string(part.cam.options.family)},
            {"path", part.cam.closed() ? "planar" : "helix"},
            {"cable_diameter_mm", core::mm_from_m(part.cam.options.cable_diameter)},
            {"torque_sign", part.cam.options.torque_sign},
            {"rotation_sign", part.cam.rotation_sign},
            {"travel_rad", cam.travel},
            {"working_psi_rad", range(part.cam.working_psi)},
            {"arms_mm", range(cam.arms_mm)},
            {"least_curvature_radius_mm", cam.least_rho_mm},
            {"tensions_N", range(cam.tensions)}};
}

Json least_radius_json(const std::optional<cam::LeastRadius>& r) {
    if (!r) return nullptr;
    return {{"proven_mm", core::mm_from_m(r->proven)}, {"found_mm", core::mm_from_m(r->found)}, {"psi_rad", range(r->psi)}};
}

Json certificate_json(const cam::Certificate& c) {
    return {{"convex", cam::to_string(c.convex)},
            {"ordered", cam::to_string(c.ordered)},
            {"working_arc", least_radius_json(c.working)},
            {"idle_arc", least_radius_json(c.idle)},
            {"floor_in_space", least_radius_json(c.floor)},
            {"idle_floor_in_space", least_radius_json(c.idle_floor)},
            {"seam_mm", core::mm_from_m(c.seam)},
            {"boxes", c.boxes},
            {"open", c.open},
            {"assumed", cam::certificate_assumptions()}};
}

Json mesh_json(const PartReport& report) {
    const solid::Box box = solid::bounding_box(report.part->mesh);
    return {{"triangles", report.part->mesh.triangles.size()},
            {"volume_mm3", solid::volume_mm3(report.part->mesh)},
            {"box_mm", {box.low_mm, box.high_mm}},
            {"chordal_error_mm", report.part->chordal_error_mm},
            {"boundary_edges", report.quality.boundary_edges},
            {"euler", report.quality.euler},
            {"shortest_edge_mm", report.quality.shortest_edge_mm},
            {"smallest_angle_deg", report.quality.smallest_angle_deg}};
}

Json part_json(const PartReport& report) {
    const CamFigures cam = measure(report.part->cam);
    Json on_cam = cam_json(*report.part, cam);
    if (const cam::ArmPoint& most = report.part->cam.working.back().arm; most.stretch.turn != 0.0) on_cam["stretch"] = stretch_json(most);
    return {{"part", cam::to_string(report.part->cam.kind)},
            {"spring", spring_json(report.spring, cam)},
            {"cam", std::move(on_cam)},
            {"certificate", certificate_json(report.certificate)},
            {"mesh", mesh_json(report)},
            {"findings", findings_json(report.findings)},
            {"files", files_json(report.files)},
            {"read_back", read_back_json(report.arm_errors)}};
}

Json outlook_json(const Outlook& o, double worst_file_error) {
    const auto width = [](const ExpectedWidth& w) {
        return Json{{"tau_Nm", w.tau}, {"exact_rad", w.nominal}, {"built_rad", range(w.built)}};
    };
    Json arms = Json::array();
    for (const MadeArm& arm : o.arms)
        arms.push_back({{"part", arm.part},
                        {"tolerance_mm", arm.tolerance_mm},
                        {"least_arm_mm", arm.least_arm_mm},
                        {"worst_relative", arm.worst_relative()}});
    return {{"process", o.process},
            {"dead_band", Json::array({width(o.least), width(o.overdrive)})},
            {"arms", std::move(arms)},
            {"worst_file_arm_error", worst_file_error},
            {"joint_torque_Nm", o.joint_torque},
            {"condition_6", {{"verdict", to_string(condition_verdict(o.condition))}, {"values", range(o.condition.values)}}}};
}

}  // namespace

std::string report_json(const DesignReport& design) {
    Json j;
    j["fusee"] = core::version();
    j["name"] = design.provenance.name;
    j["profile_sha256"] = design.provenance.profile_sha256;
    j["options"] = design.provenance.options;
    j["verdict"] = core::to_string(verdict(design));
    j["rules"] = rules_json(design.all_findings());
    j["outlook"] = outlook_json(design.outlook, design.worst_arm_error());
    j["law"] = law_json(design.law);
    j["dead_band"] = Json::array();
    for (const actuator::DeadBand& d : design.dead_band) j["dead_band"].push_back(dead_band_json(d));
    j["as_exported"] = as_exported_json(design.as_exported);
    j["findings"] = findings_json(design.findings);
    j["parts"] = Json::array();
    for (const PartReport& part : design.parts) j["parts"].push_back(part_json(part));
    j["mirrored"] = Json::array();
    for (const PartReport& part : design.mirrored) j["mirrored"].push_back(part_json(part));
    j["plate"] = read_back_json(design.plate_errors);
    j["files"] = files_json(design.files);
    // A broken byte in a text is replaced rather than losing the report.
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::report
