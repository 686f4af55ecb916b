#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "design/parts.h"
#include "fusee/assembly/assembly.h"
#include "fusee/report/report.h"
#include "page/column.h"
#include "scene/scene.h"

namespace fusee::report {

namespace {

Json misfit_json(const pipeline::Misfit& misfit) {
    return {{"rms_Nm", misfit.rms}, {"largest_Nm", misfit.largest}, {"largest_in_row", misfit.row}};
}

Json smoothed_table_json(const SmoothedTable& table) {
    return {{"file", table.file},
            {"series", misfit_json(table.series())},
            {"parallel", misfit_json(table.parallel())},
            {"columns", {"angle_rad", "series_Nm", "series_smoothed_Nm", "parallel_Nm", "parallel_smoothed_Nm"}},
            {"rows", json_list(table.rows, [](const TableRow& r) {
                 return Json{r.angle, r.series, r.series_smooth, r.parallel, r.parallel_smooth};
             })}};
}

/// The torque of a single spring that its part gives at each of its rows, as the first of its files was read [Nm].
std::vector<double> torques_read_back(const PartReport& part, double pulley_radius) {
    std::vector<double> torques;
    if (part.arm_errors.empty()) return torques;
    const std::vector<double>& arms_mm = part.arm_errors.front().arms_mm;
    for (std::size_t i = 0; i < arms_mm.size(); ++i) {
        const cam::ArmPoint& at = part.part->cam.working[i].arm;
        const double found = core::m_from_mm(arms_mm[i]);
        const bool spool = part.part->cam.kind == cam::PartKind::kSeries;  // the arm gives the tension, the pulley's radius the torque
        torques.push_back(at.tension * (spool ? pulley_radius * at.arm / found : found));
    }
    return torques;
}

Json one_spring_json(const DesignReport& design) {
    using P = spring::LawPoint;
    const double first = design.headline.spring->angles.low;
    const std::vector<P>& samples = design.law.samples;
    const PartReport& part = design.parts.front();
    Json json{{"angle_rad", column(samples, [&](const P& p) { return first + p.theta; })},
              {"torque_Nm", column(samples, &P::tau)},
              {"stiffness_Nm_per_rad", column(samples, &P::p)},
              {"energy_J", column(samples, &P::u_pe)},
              {"cam_angle_rad", column(part.part->cam.working, [](const cam::Contact& c) { return c.arm.angle; })},
              {"read_back_Nm", design.of_both ? design.of_both->found : torques_read_back(part, design.actuator.capstan_radius)}};
    if (design.of_both) json["cables"] = {{"forth_Nm", design.of_both->forth}, {"back_Nm", design.of_both->back}};
    return json;
}

Json law_json(const LawReport& law) {
    Json j;
    if (!law.samples.empty()) {
        j["loads_Nm"] = {law.samples.front().tau, law.samples.back().tau};
        j["angles_rad"] = {law.samples.front().theta, law.samples.back().theta};
    }
    j["design_loads_Nm"] = range_json(law.design_loads);
    j["lead_in_travel_rad"] = law.lead_in_travel;
    j["least_feasible_start_Nm"] = law.least_feasible_start;
    j["stiction_loads_Nm"] = range_json(law.stiction_loads);
    j["covers_stiction"] = law.covers_stiction();
    j["curves"] = spring_curves_json(law.samples);
    if (law.table) j["table"] = smoothed_table_json(*law.table);
    return j;
}

Json level_of_design_json(const actuator::DeadBand& d) {
    return {{"tau_Nm", d.tau},
            {"theta_rad", d.theta},
            {"linear_rad", d.linear},
            {"exact_rad", d.exact_width},
            {"covered", d.covered},
            {"joint_stiffness_Nm_per_rad", d.joint_stiffness},
            {"free_joint_stiffness_Nm_per_rad", d.free_joint_stiffness},
            {"condition_6", d.condition_6}};
}

Json file_json(const FileRow& file) {
    return {{"name", file.entry.name},
            {"bytes", file.bytes},
            {"sha256", file.entry.sha256},
            {"triangles", file.entry.triangles},
            {"chordal_error_mm", file.entry.chordal_error_mm}};
}

Json arm_error_json(const readback::ArmError& e) {
    Json json{{"file", e.file},
              {"reader", e.reader},
              {"rows", e.rows},
              {"worst_relative", e.worst_relative},
              {"worst_angle_rad", e.worst_angle_rad},
              {"allowed", e.allowed},
              {"passed", e.passed()},
              {"severity", core::to_string(e.passed() ? core::Severity::kPass : e.when_broken)}};
    if (!e.mirror_of.empty()) json["mirror_of"] = e.mirror_of;
    return json;
}

Json base_spring_json(const spring::BaseSpring& s, const CamFigures& cam) {
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    return {{"kind", torsion ? "torsion" : "compression"},
            {torsion ? "rate_Nm_per_rad" : "rate_N_per_m", s.rate},
            {torsion ? "preload_rad" : "preload_m", s.preload},
            {torsion ? "states_rad" : "states_m", range_json(cam.states)},
            {torsion ? "torques_Nm" : "forces_N", {s.rate * cam.states.low, s.rate * cam.states.high}}};
}

/// In the world, with the pivot seen from the cam's axis.
Json follower_arm_json(const cam::Roller& roller) {
    const cam::FollowerArm& arm = roller.arm;
    const double pivot = core::mm_from_m(arm.pivot);
    return {{"arm_mm", core::mm_from_m(arm.length)},
            {"pivot_mm", {pivot * std::cos(roller.direction), pivot * std::sin(roller.direction)}},
            {"lever_mm", core::mm_from_m(arm.lever)},
            {"spring_mm", core::mm_from_m(arm.spring)}};
}

Json cam_json(const solid::Part& part, const CamFigures& cam) {
    Json j{{"family", cam::to_string(part.cam.options.family)},
           {"path", part.cam.closed() ? "planar" : "helix"},
           {"cable_diameter_mm", core::mm_from_m(part.cam.options.cable_diameter)},
           {"torque_sign", part.cam.options.torque_sign},
           {"rotation_sign", part.cam.rotation_sign},
           {"travel_rad", cam.travel},
           {"working_psi_rad", range_json(part.cam.working_psi)},
           {"arms_mm", range_json(cam.arms_mm)},
           {"least_curvature_radius_mm", cam.least_rho_mm},
           {"tensions_N", range_json(cam.tensions)}};
    if (const cam::ArmPoint& most = part.cam.working.back().arm; most.elongation.turn != 0.0) j["stretch"] = stretch_json(most);
    if (part.cam.has_roller()) {
        const auto angle = [&](const cam::Contact& c) { return std::abs(cam::pressure_angle(c.arm, part.cam.options)); };
        const std::vector<double> angles = column(part.cam.working, angle);
        j["roller"] = {{"radius_mm", core::mm_from_m(part.cam.options.roller.radius)},
                       {"greatest_pressure_angle_rad", *std::max_element(angles.begin(), angles.end())}};
        if (part.cam.options.roller.follower == cam::FollowerKind::kArm) j["roller"]["arm"] = follower_arm_json(part.cam.options.roller);
    }
    return j;
}

Json least_radius_json(const std::optional<cam::LeastRadius>& r) {
    if (!r) return nullptr;
    return {{"proven_mm", core::mm_from_m(r->proven)}, {"found_mm", core::mm_from_m(r->found)}, {"psi_rad", range_json(r->psi)}};
}

Json certificate_json(const cam::Certificate& c) {
    return {{"convex", cam::to_string(c.convex)},
            {"ordered", cam::to_string(c.ordered)},
            {"working_arc", least_radius_json(c.working)},
            {"idle_arc", least_radius_json(c.idle)},
            {"floor_in_space", least_radius_json(c.floor)},
            {"idle_floor_in_space", least_radius_json(c.idle_floor)},
            {"least_proven_mm", core::mm_from_m(c.least().proven)},
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

Json made_part_json(const PartReport& report) {
    const CamFigures cam = measure(report.part->cam);
    Json j{{"part", cam::to_string(report.part->cam.kind)},
           {"spring", base_spring_json(report.spring, cam)},
           {"cam", cam_json(*report.part, cam)},
           {"certificate", certificate_json(report.certificate)},
           {"mesh", mesh_json(report)},
           {"findings", findings_json(report.findings)},
           {"files", json_list(report.files, file_json)},
           {"read_back", json_list(report.arm_errors, arm_error_json)}};
    if (report.shaft)
        j["shaft"] = {{"first_rad", report.shaft->first_rad}, {"sense", report.shaft->sense}, {"height_mm", report.shaft->height_mm}};
    return j;
}

/// A part of the agonist's side, as the page draws it.
Json drawn_part_json(const PartReport& report) {
    const std::vector<cam::Contact>& working = report.part->cam.working;
    Json j = made_part_json(report);
    j["arms"] = {{"angle_rad", column(working, [](const cam::Contact& c) { return c.arm.angle; })},
                 {"arm_mm", column(working, [](const cam::Contact& c) { return core::mm_from_m(c.arm.arm); })},
                 {"z_mm", column(working, [](const cam::Contact& c) { return core::mm_from_m(c.path.z); })}};
    j["drawing"] = drawing_json(*report.part);
    return j;
}

Json building_json(const DesignReport& design) {
    if (!design.assembly) return nullptr;
    const assembly::Assembly& a = *design.assembly;
    Json cables = Json::array();
    for (const assembly::Cable& cable : a.cables)
        if (cable.side == assembly::Side::kAgonist)
            cables.push_back({{"kind", to_string(cable.kind)}, {"length_mm", cable.length_mm}, {"cut_mm", cable.cut_mm()}});
    return {{"motor_distance_mm", a.motor_distance_mm},
            {"carriage_travel_mm", a.capstan_radius_mm * a.greatest_turn},
            {"cables", std::move(cables)}};
}

/// Why there is no assembly.
std::string no_assembly(const DesignReport& design) {
    for (const core::Finding& f : design.findings)
        if (f.rule == "joint.roller" || f.rule == "joint.guide") return f.where + ": " + f.what + ".";
    return "";
}

Json headline_json(const Headline& o, const FileErrors& files, double worst_file_error) {
    const auto width = [](const ExpectedWidth& w) {
        return Json{{"tau_Nm", w.tau}, {"exact_rad", w.nominal}, {"built_rad", range_json(w.built)}};
    };
    return {{"process", o.process},
            {"figures",
             json_list(head_figures(o, files),
                       [](const HeadFigure& figure) {
                           return Json{{"name", figure.name}, {"value", figure.value}, {"line", figure.line}, {"label", figure.label}};
                       })},
            {"dead_band", o.spring ? Json::array() : Json::array({width(o.least), width(o.overdrive)})},
            {"arms", json_list(o.arms,
                               [](const MadeArm& arm) {
                                   return Json{{"part", arm.part},
                                               {"tolerance_mm", arm.tolerance_mm},
                                               {"least_arm_mm", arm.least_arm_mm},
                                               {"worst_relative", arm.worst_relative()}};
                               })},
            {"budget", o.budget ? budget_to_json(*o.budget) : Json()},
            {"worst_file_arm_error", worst_file_error},
            {"joint_torque_Nm", o.joint_torque},
            {"condition_6",
             o.spring ? Json() : Json{{"verdict", to_string(condition_verdict(o.condition))}, {"values", range_json(o.condition.values)}}}};
}

/// The part of a single spring: it has a name of its own, and its drawing states torques where that of a joint states loads.
void name_single(Json& part, const std::string& name, double first_torque, double last_torque) {
    part["part"] = name;
    part["drawing"]["ends"][0]["load_Nm"] = first_torque;
    part["drawing"]["ends"][1]["load_Nm"] = last_torque;
}

/// The drawing of each cable's part has the torques of that cable.
void name_spring_parts(Json& parts, const DesignReport& design) {
    if (const auto& both = design.of_both) {
        name_single(parts[0], design.parts[0].name, both->forth.front(), both->forth.back());
        name_single(parts[1], design.parts[1].name, both->back.back(), both->back.front());
    } else {
        name_single(parts.front(), design.parts.front().name, design.law.samples.front().tau, design.law.samples.back().tau);
    }
}

Json exported_spring_json(const ExportedSpring& spring) {
    if (spring.file.empty()) return {{"file", nullptr}};
    return {{"file", spring.file}, {"worst_arm_relative", spring.worst_arm}, {"worst_law_relative", spring.worst_law}};
}

}  // namespace

Json as_exported_json(const AsExported& exported) {
    return {{"tau_Nm", exported.torques},
            {"nominal_dead_band_rad", exported.nominal},
            {"joints", json_list(exported.joints, [](const JointAsExported& joint) {
                 return Json{{"reader", joint.reader},
                             {"k_se", exported_spring_json(joint.series)},
                             {"k_pe", exported_spring_json(joint.parallel)},
                             {"dead_band_rad", joint.dead_band},
                             {"binding", joint.binding},
                             {"refusal", joint.refusal}};
             })}};
}

Json stretch_json(const cam::ArmPoint& at) {
    return {{"load_Nm", at.tau},
            {"tension_N", at.tension},
            {"length_mm", core::mm_from_m(at.elongation.length)},
            {"capstan_rad", at.elongation.turn},
            {"capstan_travel_rad", at.elongation.travel},
            {"share", at.elongation.share()}};
}

std::string report_json(const DesignReport& design) {
    Json j = provenance_json(design.provenance);
    j["made_by"] = design.provenance.line();
    j["verdict"] = core::to_string(verdict(design));
    j["rules"] = rules_json(design.all_findings());
    j["headline"] = headline_json(design.headline, design.file_errors(), design.worst_arm_error());
    j["law"] = design.headline.spring ? Json{{"spring", one_spring_json(design)}} : law_json(design.law);
    j["dead_band"] = json_list(design.dead_band, level_of_design_json);
    j["as_exported"] = as_exported_json(design.as_exported);
    j["findings"] = findings_json(design.findings);
    j["parts"] = json_list(design.parts, drawn_part_json);
    if (design.headline.spring) name_spring_parts(j["parts"], design);
    j["mirrored"] = json_list(design.mirrored, made_part_json);
    j["plate"] = json_list(design.plate_errors, arm_error_json);
    j["files"] = json_list(design.files, file_json);
    j["assembly"] = building_json(design);
    j["no_assembly"] = no_assembly(design);
    RenamedFields renamed = kRenamedCounts;
    renamed.emplace_back("outlook", "headline");
    return json_text(std::move(j), renamed);
}

std::string report_html(const DesignReport& design) { return report_page(design, report_json(design)); }

std::string report_page(const DesignReport& design, std::string json) {
    const core::Findings findings = design.all_findings();
    std::string summary = design.provenance.line() + "\n";
    for (const HeadFigure& figure : head_figures(design.headline, design.file_errors()))
        summary += fmt::format("{}  {}\n", figure.value, figure.label);
    for (const core::Finding& finding : findings)
        if (core::is_broken(finding)) summary += core::to_line(finding) + "\n";
    Page page{"design", design.provenance.name, summary + not_judged_text(findings), {{"result", std::move(json)}}};
    if (design.assembly) add_scene(page, design);
    return page_file(page);
}

}  // namespace fusee::report
