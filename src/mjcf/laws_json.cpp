#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/provenance.h"
#include "fusee/mjcf/write.h"

namespace fusee::mjcf {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: null is "none".
Json limit(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json spring_json(const Curve& curve) {
    const Cubic fit = fit_cubic(curve);
    return {{"low_rad", curve.low},
            {"high_rad", curve.high},
            {"end_stiffness_Nm_per_rad", curve.end_stiffness},
            {"stop_travel_rad", curve.stop_travel},
            {"hysteresis", curve.hysteresis},
            {"table_error_Nm", curve.table_error},
            {"cubic",
             {{"free_rad", fit.free},
              {"stiffness", {fit.linear, fit.square, fit.cube}},
              {"worst_error_Nm", fit.worst},
              {"worst_at_rad", fit.worst_at},
              {"worst_share", fit.worst / curve.greatest()}}},
            {"torque_Nm", curve.torque}};
}

Json gear_json(const TwinGear& gear) {
    return {{"load_Nm", gear.load},
            {"friction_Nm", gear.friction},
            {"asymmetry", gear.asymmetry},
            {"rest_excess", gear.rest_excess},
            {"rest_speed_rad_per_s", gear.rest_speed},
            {"viscous_Nms", gear.viscous},
            {"torque_scale", gear.torque_scale},
            {"saturation_Nm", limit(gear.saturation)},
            {"backlash_rad", gear.backlash}};
}

Json side_json(const TwinSide& side) {
    return {{"ratio", side.ratio},          {"capstan_scale", side.capstan_scale}, {"motor_inertia_kgm2", side.motor_inertia},
            {"gear", gear_json(side.gear)}, {"k_se", spring_json(side.se)},        {"k_pe", spring_json(side.pe)}};
}

Json joint_json(const Twin& twin) {
    return {{"friction_Nm", twin.joint_friction}, {"tension_share", twin.tension_share}, {"viscous_Nms", twin.joint_viscous},
            {"gravity_Nm", twin.gravity},         {"stop_rad", limit(twin.stop)},        {"stop_stiffness_Nm_per_rad", twin.stop_stiffness},
            {"stop_damping", twin.stop_damping},  {"offset_rad", twin.joint_offset}};
}

}  // namespace

std::string laws_json(const Twin& twin) {
    const Json all{{"fusee", core::version()},
                   {"name", twin.name},
                   {"source", twin.source},
                   {"timestep_s", time_step(twin)},
                   {"joint_inertia_kgm2", twin.joint_inertia},
                   {"reference_torque_Nm", twin.reference_torque},
                   {"delay_s", twin.delay},
                   {"joint", joint_json(twin)},
                   {"agonist", side_json(twin.sides[0])},
                   {"antagonist", side_json(twin.sides[1])},
                   {"not_expressed", twin.not_expressed}};
    return all.dump(1) + "\n";
}

}  // namespace fusee::mjcf
