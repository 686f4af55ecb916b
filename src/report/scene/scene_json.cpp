#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "assembly/shown.h"
#include "fusee/assembly/motion.h"
#include "fusee/checks/along.h"
#include "fusee/core/text.h"
#include "fusee/report/assembly.h"
#include "fusee/solid/part.h"
#include "page/column.h"
#include "scene/poses.h"
#include "scene/scene.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::Body, assembly::Side;

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
    Json all = Json::object();
    for (const Body& body : a.bodies)
        if (body.side != Side::kAntagonist && !coil_of(a, body)) all[body.base_name()] = scene_mesh_json(shown_mesh(a, body));
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

constexpr double kBoxSteps = 65535.0;

void add_little_endian(std::string& to, std::unsigned_integral auto value) {
    for (std::size_t byte = 0; byte < sizeof value; ++byte) to.push_back(static_cast<char>((value >> (8 * byte)) & 0xff));
}

using assembly::Assembly, assembly::CableKind, assembly::FreeCable, assembly::Side;
using Eigen::Vector3d;

constexpr double kDeadWrap = core::kPi / 6.0;  // shown on a drum beyond what works

Json node(const Vector3d& at, int channel = -1, const Vector3d& direction = Vector3d::Zero()) {
    return {{"at_mm", vector_json(at)}, {"slide", channel}, {"direction", vector_json(direction)}};
}

/// A cable that winds on a drum from a tangent point: angle wound = base + gain * channel [rad].
Json arc(const Vector3d& centre, const Vector3d& tangent, double direction, double base, int channel, double gain) {
    const Vector3d out = tangent - centre;
    return {{"centre_mm", vector_json(centre)},
            {"radius_mm", rounded(std::hypot(out.x(), out.y()))},
            {"start_rad", rounded(std::atan2(out.y(), out.x()))},
            {"direction", direction},
            {"base_rad", rounded(base)},
            {"channel", channel},
            {"gain", gain}};
}

/// Free cables of one side at rest, in the order of assembly::free_cables.
struct SideCables {
    FreeCable drive, to_guide, to_joint, parallel;
};

Json side_json(const Assembly& a, const SideCables& c, Side side) {
    const bool agonist = side == Side::kAgonist;
    const int first = agonist ? kTurnAgonist : kTurnAntagonist, carriage = first + kCarriageAgonist;
    const double sign = agonist ? 1.0 : -1.0;
    const Vector3d back(0.0, -1.0, 0.0);
    Vector3d motor = a.motor_axis_mm;
    motor.x() *= sign, motor.z() = c.drive.from_mm.z();
    const Vector3d joint(0.0, 0.0, c.to_joint.to_mm.z());
    const std::string of = std::string("_") + to_string(side);
    const double at_motor = c.drive.from_mm.x() > motor.x() ? -1.0 : 1.0;  // winds on the side away from the joint
    Json all = Json::array();
    all.push_back({{"name", "drive cable, " + std::string(to_string(side))},
                   {"from", nullptr},
                   {"nodes", {node(c.drive.to_mm, carriage, back), node(c.drive.from_mm)}},
                   {"arc", arc(motor, c.drive.from_mm, at_motor, kDeadWrap, first, 1.0)}});
    all.push_back({{"name", "series cable, " + std::string(to_string(side))},
                   {"from", "k_se" + of},
                   {"nodes", {node(c.to_guide.to_mm, carriage, back), node(c.to_joint.to_mm)}},
                   {"arc", arc(joint, c.to_joint.to_mm, sign, kDeadWrap + 0.5 * a.joint_range, kJointAngle, sign)}});
    Json nodes = Json::array({node(c.parallel.to_mm)});
    if (const assembly::Body* cap = a.find("k_pe_cap" + of)) {
        const Follows end = follows(a, *cap);
        nodes.push_back(node(cap->rest.translation(), end.slide, end.direction));
    }
    all.push_back({{"name", "parallel cable, " + std::string(to_string(side))}, {"from", "k_pe" + of}, {"nodes", nodes}, {"arc", nullptr}});
    return all;
}

constexpr std::size_t kCamRows = 120;  // of a cam's table
constexpr int kAnchorSteps = 24;       // of the cable between working arc and anchor

/// Evenly spread working positions with both ends.
std::vector<const cam::Contact*> spread_rows(const cam::Cam& cam) {
    std::vector<const cam::Contact*> rows;
    const std::size_t n = std::min(kCamRows, cam.working.size());
    for (std::size_t i = 0; i < n; ++i) rows.push_back(&cam.working[n < 2 ? 0 : i * (cam.working.size() - 1) / (n - 1)]);
    return rows;
}

Json point_json(const cam::PathPoint& p) { return vector_json(1e3 * Eigen::Vector3d(p.x(), p.y(), p.z)); }

template <class Of>
Json column_json(const std::vector<const cam::Contact*>& rows, const Of& of) {
    return json_list(rows, [&](const cam::Contact* c) { return Json(of(*c)); });
}

/// The cable from the anchor to the wound end of the working arc: K_SE pays cable out, K_PE draws it in.
Json to_anchor(const cam::Cam& cam) {
    const double end = (cam.kind == cam::PartKind::kSeries ? cam.working.back() : cam.working.front()).path.psi;
    Json points = Json::array();
    for (int i = 0; i < kAnchorSteps; ++i)
        points.push_back(point_json(cam.path(cam.anchor_psi + (end - cam.anchor_psi) * i / kAnchorSteps)));
    return points;
}

const core::Finding* finding_of(const PartReport& part, const std::string& rule) {
    for (const core::Finding& f : part.findings)
        if (f.rule == rule && f.severity != core::Severity::kNotJudged) return &f;
    return nullptr;
}

Json rules_along(const PartReport& part, const std::vector<const cam::Contact*>& rows) {
    Json rules = Json::array();
    const cam::Cam& cam = part.part->cam;
    for (const checks::AlongCam& along : checks::along_cam())
        if (const core::Finding* f = finding_of(part, along.rule))
            rules.push_back({{"rule", f->rule},
                             {"unit", f->unit},
                             {"bound", f->bound == core::Bound::kAtMost ? "at most" : "at least"},
                             {"allowed", rounded(f->allowed)},
                             {"values", column_json(rows, [&](const cam::Contact& c) { return rounded(along.value(cam, c)); })}});
    return rules;
}

/// Ids of the part's rules with one value for the whole part.
Json whole_part_rules(const PartReport& part) {
    std::set<std::string> ids;
    for (const core::Finding& f : part.findings) ids.insert(f.rule);
    for (const checks::AlongCam& along : checks::along_cam()) ids.erase(along.rule);
    return ids;
}

Json cam_table_json(const PartReport& part) {
    const cam::Cam& cam = part.part->cam;
    const auto rows = spread_rows(cam);
    using C = cam::Contact;
    return {{"part", to_string(cam.kind)},
            {"angle_rad", column_json(rows, [](const C& c) { return rounded(c.arm.angle); })},
            {"arm_mm", column_json(rows, [](const C& c) { return rounded(core::mm_from_m(c.arm.arm)); })},
            {"tension_N", column_json(rows, [](const C& c) { return rounded(c.arm.tension); })},
            {"load_Nm", column_json(rows, [](const C& c) { return rounded(c.arm.tau); })},
            {"rho_mm", column_json(rows, [](const C& c) { return rounded(core::mm_from_m(c.path.rho)); })},
            {"contact_mm", column_json(rows, [](const C& c) { return point_json(c.path); })},
            {"to_anchor_mm", to_anchor(cam)},
            {"wound_end", cam.kind == cam::PartKind::kSeries ? "last" : "first"},
            {"rules", rules_along(part, rows)},
            {"rules_of_whole_part", whole_part_rules(part)}};
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

std::string joint_plan_json(const DesignReport& design) { return Json(assembly_plan(*design.assembly)).dump(-1, ' ', true); }

void add_scene(Page& page, const DesignReport& design) { add_joint(page, joint_plan_json(design), scene_json(design)); }

double PackedMesh::error_mm() const { return 0.5 * *std::max_element(step_mm.begin(), step_mm.end()); }

PackedMesh packed(const solid::Mesh& mesh) {
    const solid::Box box = solid::bounding_box(mesh);
    PackedMesh out;
    out.low_mm = box.low_mm;
    for (std::size_t k = 0; k < 3; ++k) out.step_mm[k] = (box.high_mm[k] - box.low_mm[k]) / kBoxSteps;
    std::string points, triangles;
    for (const solid::Vec3& p : mesh.points_mm)
        for (std::size_t k = 0; k < 3; ++k) {
            const double count = out.step_mm[k] > 0.0 ? (p[k] - out.low_mm[k]) / out.step_mm[k] : 0.0;
            add_little_endian(points, static_cast<std::uint16_t>(std::clamp(std::round(count), 0.0, kBoxSteps)));
        }
    out.wide = mesh.points_mm.size() > 65536;
    for (const solid::Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t) {
            if (out.wide) add_little_endian(triangles, corner);
            if (!out.wide) add_little_endian(triangles, static_cast<std::uint16_t>(corner));
        }
    out.points = core::base64(points), out.triangles = core::base64(triangles);
    return out;
}

Json cables_json(const Assembly& a) {
    const std::vector<FreeCable> free = assembly::free_cables(a, {});
    Json all = side_json(a, {free[0], free[1], free[2], free[3]}, Side::kAgonist);
    for (Json& cable : side_json(a, {free[4], free[5], free[6], free[7]}, Side::kAntagonist)) all.push_back(std::move(cable));
    return all;
}

double rounded(double value) { return std::round(1e5 * value) / 1e5 + 0.0; }
Json vector_json(const Eigen::Vector3d& v) { return Json::array({rounded(v.x()), rounded(v.y()), rounded(v.z())}); }

Json cam_tables_json(const DesignReport& design) { return json_list(design.parts, cam_table_json); }

}  // namespace fusee::report
