#include "assembly/shown.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "fusee/core/kept.h"
#include "fusee/solid/part.h"

namespace fusee::report {

using assembly::Assembly, assembly::Body;
using Eigen::Vector3d;

namespace {

constexpr double kChordalError = 2e-5;  // of the shown cams [m]: below a pixel, and a tenth of the files' triangles

/// Both pictures and the page ask for each cam.
solid::Mesh shown_cam(const std::shared_ptr<const solid::Part>& part) {
    static core::Kept<std::shared_ptr<const solid::Part>, solid::Mesh> cams(2);
    if (auto known = cams.find(part)) return *std::move(known);
    solid::PartOptions options = part->options;
    options.chordal_error = std::max(options.chordal_error, kChordalError);
    auto coarse = solid::build_part(part->cam, options);
    solid::Mesh mesh = coarse ? std::move(coarse).value().mesh : part->mesh;
    cams.keep(part, mesh);
    return mesh;
}

}  // namespace

solid::Mesh shown_mesh(const Assembly& a, const Body& body) {
    if (!body.cam) return body.mesh();
    solid::Mesh cam = shown_cam(body.base_name() == "k_se" ? a.drive.k_se : a.drive.k_pe);
    return body.side == assembly::Side::kAntagonist ? solid::mirrored(cam) : cam;
}

Vector3d moved_apart(const Assembly& a, const Body& body) {
    struct Move {
        double up, along;
    };
    static const std::map<std::string, Move> kMoves{
        {"axle_rings", {30.0, 0.0}},    {"axle_sleeve", {-25.0, 0.0}},    {"shaft_collar", {70.0, 0.0}}, {"joint_stops", {-10.0, 0.0}},
        {"rods", {-60.0, 0.0}},         {"bushes", {-40.0, 0.0}},         {"axle", {30.0, 0.0}},         {"k_se", {60.0, 0.0}},
        {"k_se_spring", {85.0, 0.0}},   {"capstan", {40.0, 0.0}},         {"joint_pulley", {40.0, 0.0}}, {"stop_pin", {40.0, 0.0}},
        {"capstan_pin", {40.0, 0.0}},   {"capstan_stops", {-30.0, 0.0}},  {"k_pe", {-55.0, 0.0}},        {"k_pe_seat", {-55.0, 0.0}},
        {"leg_in_k_se", {85.0, 0.0}},   {"leg_in_carriage", {85.0, 0.0}}, {"frame_plate", {150.0, 0.0}}, {"joint_tower", {110.0, 0.0}},
        {"bearings", {120.0, 0.0}},     {"joint_shaft", {90.0, 0.0}},     {"k_pe_posts", {60.0, 0.0}},   {"spring_arbor", {70.0, 0.0}},
        {"k_pe_spring", {-55.0, 25.0}}, {"k_pe_cap", {-55.0, 50.0}}};
    const auto found = kMoves.find(body.base_name());
    if (found == kMoves.end()) return Vector3d::Zero();
    const double side = body.side == assembly::Side::kAntagonist ? -1.0 : 1.0, direction = a.options.k_pe_direction;
    return Vector3d(side * std::cos(direction), std::sin(direction), 0.0) * found->second.along + found->second.up * Vector3d::UnitZ();
}

std::optional<drawing::Coil> coil_of(const Assembly& a, const Body& body, const assembly::Pose& pose) {
    const bool torsion = body.base_name() == "k_se_spring";
    if (!torsion && body.base_name() != "k_pe_spring") return {};
    const spring::BaseSpring& spring = torsion ? a.drive.k_se_spring : a.drive.k_pe_spring;
    if (spring.active_coils <= 0.0) return {};
    const assembly::Extrusion& space = body.shapes.front();
    const double inside = space.holes.front().radius_mm, wire = space.radius_mm - inside;
    const double length = space.length_mm - (torsion ? 0.0 : assembly::drawn_mm(a, pose.of(body.side).turn));
    constexpr double kGroundCoils = 2.0;  // of a compression spring, one at each end
    const bool left = (spring.hand == spring::Hand::kLeft) == (body.side == assembly::Side::kAgonist);
    return drawing::Coil{inside + 0.5 * wire, wire, length, spring.active_coils + (torsion ? 0.0 : kGroundCoils), left};
}

}  // namespace fusee::report
