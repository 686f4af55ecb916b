#include <fmt/format.h>

#include <future>

#include "assembly/shown.h"
#include "fusee/report/assembly.h"
#include "fusee/solid/part.h"
#include "page/column.h"
#include "scene/packed.h"
#include "scene/parts.h"
#include "scene/poses.h"
#include "scene/scene.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::Body, assembly::Side;

constexpr double kChordalError = 2e-5;  // of the shown cams [m]: below a pixel, and a tenth of the files' triangles

/// The part as the page shows it: swept again with fewer facets, which keeps its shape where a decimation would not.
solid::Mesh shown_cam(const solid::Part& part) {
    solid::PartOptions options = part.options;
    options.chordal_error = std::max(options.chordal_error, kChordalError);
    auto coarse = solid::build_part(part.cam, options);
    return coarse ? std::move(coarse).value().mesh : part.mesh;
}

Json scene_mesh_json(const solid::Mesh& mesh) {
    const PackedMesh packed_mesh = packed(mesh);
    return {{"low_mm", packed_mesh.low_mm},
            {"step_mm", packed_mesh.step_mm},
            {"points", packed_mesh.points},
            {"triangles", packed_mesh.triangles},
            {"wide", packed_mesh.wide}};
}

/// The mesh of each kind of body once: the antagonist's are mirror images.
Json meshes_json(const Assembly& a) {
    auto k_se = std::async(std::launch::async | std::launch::deferred, [&a] { return shown_cam(*a.drive.k_se); });
    const solid::Mesh k_pe = shown_cam(*a.drive.k_pe);
    Json all = Json::object();
    for (const Body& body : a.bodies)
        if (body.side != Side::kAntagonist && !body.cam && !coil_of(a, body)) all[body.base_name()] = scene_mesh_json(body.mesh());
    all["k_pe"] = scene_mesh_json(k_pe);
    all["k_se"] = scene_mesh_json(k_se.get());
    return all;
}

template <class Row, class Of>
Json curve_json(const std::vector<Row>& rows, const Of& of) {
    Json all = Json::array();
    for (const double value : column(rows, of)) all.push_back(rounded(value));
    return all;
}

Json scene_columns_json(const Eigen::Isometry3d& m) {  // by columns, as three.js reads it
    Json all = Json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) all.push_back(m.matrix()(row, column));
    return all;
}

Json coil_json(const Assembly& a, const Body& body) {
    const auto coil = coil_of(a, body);
    if (!coil) return nullptr;
    const int first = body.side == Side::kAntagonist ? kTurnAntagonist : kTurnAgonist;
    const bool torsion = body.base_name() == "k_se_spring";
    return {{"frame", scene_columns_json(body.shapes.front().frame)},
            {"radius_mm", coil->mean_radius_mm},
            {"wire_mm", coil->wire_mm},
            {"length_mm", coil->length_mm},
            {"turns", coil->turns},
            {"left", coil->left_hand},
            {"winds_with", torsion ? first + kSpoolAgonist : -1},
            {"shortens_with", torsion ? -1 : first + kDrawnAgonist}};
}

std::string shown_colour(const Body& body) {
    const auto colour = colour_of(body);
    return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

Json scene_body_json(const Assembly& a, const Body& body) {
    const Follows f = follows(a, body);
    const bool mirrored = body.side == Side::kAntagonist;
    return {{"name", body.name},
            {"mesh", body.base_name()},
            {"side", to_string(body.side)},
            {"mirror", mirrored ? (body.cam ? "y" : "x") : ""},
            {"rest", scene_columns_json(body.rest)},
            {"turn", f.turn},
            {"gain", f.gain},
            {"slide", f.slide},
            {"direction", vector_json(f.direction)},
            {"apart_mm", vector_json(moved_apart(a, body))},
            {"colour", shown_colour(body)},
            {"coil", coil_json(a, body)}};
}

/// Cable paid out or drawn in over the angle of a cam.
Json travel_json(const std::vector<assembly::Travel>& travel) {
    using T = assembly::Travel;
    return {{"angle_rad", curve_json(travel, &T::angle)}, {"length_mm", curve_json(travel, &T::length_mm)}};
}

Json grid_json(const Assembly& a, const actuator::Actuator& actuator) {
    const auto grid = pose_grid(a, actuator);
    if (!grid) return nullptr;
    const auto row = [](const PoseValues& values) {
        Json all = Json::array();
        for (const double value : values) all.push_back(rounded(value));
        return all;
    };
    return {{"tau_Nm", grid->tau},
            {"share", grid->share},
            {"most_Nm", grid->most},
            {"values", {"turn_agonist_rad", "payout_agonist_mm", "turn_antagonist_rad", "payout_antagonist_mm"}},
            {"rows", json_list(grid->rows, [&](const std::vector<PoseValues>& level) { return json_list(level, row); })},
            {"error_deg", core::deg_from_rad(grid->error_rad)},
            {"error_mm", grid->error_mm}};
}

Json law_curves(const LawReport& law) {
    using P = spring::LawPoint;
    return {{"theta_rad", curve_json(law.samples, &P::theta)},
            {"f_se_Nm", curve_json(law.samples, &P::f_se)},
            {"f_pe_Nm", curve_json(law.samples, &P::f_pe)}};
}

Json dead_band_curve_json(const std::vector<actuator::DeadBand>& band) {
    using D = actuator::DeadBand;
    return {{"tau_Nm", curve_json(band, &D::tau)},
            {"exact_deg", curve_json(band, [](const D& d) { return core::deg_from_rad(d.exact_width); })}};
}

}  // namespace

std::string scene_json(const DesignReport& design) {
    const Assembly& a = *design.assembly;
    const Json json{{"name", design.provenance.name},
                    {"cable_mm", a.cable_mm},
                    {"capstan_radius_mm", a.capstan_radius_mm},
                    {"joint_radius_mm", a.joint_radius_mm},
                    {"travel", {{"k_se", travel_json(a.k_se)}, {"k_pe", travel_json(a.k_pe)}}},
                    {"meshes", meshes_json(a)},
                    {"bodies", json_list(a.bodies, [&](const Body& body) { return scene_body_json(a, body); })},
                    {"grid", grid_json(a, design.actuator)},
                    {"cables", cables_json(a)},
                    {"cams", cam_tables_json(design)},
                    {"law", law_curves(design.law)},
                    {"dead_band", dead_band_curve_json(design.dead_band)}};
    return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string joint_plan_json(const DesignReport& design) { return Json(assembly_plan(*design.assembly)).dump(); }

void add_scene(Page& page, const DesignReport& design) { add_joint(page, joint_plan_json(design), scene_json(design)); }

}  // namespace fusee::report
