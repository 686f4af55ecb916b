#include "data/json.h"
#include "fusee/assembly/motion.h"
#include "fusee/report/assembly.h"

namespace fusee::report {

namespace {

using assembly::Assembly, assembly::Body;

Json point(const Eigen::Vector3d& p) { return Json::array({p.x(), p.y(), p.z()}); }

/// The rows of the matrix that takes a point of the body to the assembly.
Json matrix(const Eigen::Isometry3d& placement) {
    Json rows = Json::array();
    for (int i = 0; i < 3; ++i) {
        const auto row = placement.matrix().row(i);
        rows.push_back(Json::array({row(0), row(1), row(2), row(3)}));
    }
    return rows;
}

/// "k_se_antagonist" is exported as k_se_mirrored.stl.
Json file_of(const Body& body) {
    if (!body.cam) return nullptr;
    const std::string part = body.name.substr(0, 4);
    return part + (body.side == assembly::Side::kAntagonist ? "_mirrored" : "") + ".json";
}

Json body_json(const Body& body) {
    return {{"name", body.name},
            {"side", to_string(body.side)},
            {"moves_with", to_string(body.motion)},
            {"part_file", file_of(body)},
            {"placement_mm", matrix(body.rest)}};
}

}  // namespace

std::string assembly_json(const pipeline::DesignReport& design) {
    const Assembly& a = *design.assembly;
    const Json json{{"provenance", provenance_json(design.provenance)},
                    {"capstan_radius_mm", a.capstan_radius_mm},
                    {"joint_radius_mm", a.joint_radius_mm},
                    {"cable_diameter_mm", a.cable_mm},
                    {"greatest_capstan_turn_rad", a.greatest_turn},
                    {"greatest_series_payout_mm", a.greatest_payout_mm},
                    {"agonist",
                     {{"motor_axis_mm", point(a.motor_axis_mm)},
                      {"spool_axis_mm", point(a.spool_axis_mm)},
                      {"k_se_guide_mm", point(a.k_se_guide_mm)},
                      {"k_pe_guide_mm", point(a.k_pe_guide_mm)}}},
                    {"bodies", json_list(a.bodies, body_json)},
                    {"cables", json_list(a.cables, [](const assembly::Cable& cable) {
                         return Json{{"kind", to_string(cable.kind)},
                                     {"side", to_string(cable.side)},
                                     {"from", cable.from},
                                     {"to", cable.to},
                                     {"length_mm", cable.length_mm}};
                     })}};
    return json_text(json);
}

}  // namespace fusee::report
