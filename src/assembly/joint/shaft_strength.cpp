#include <fmt/format.h>

#include <cmath>

#include "fusee/checks/limits.h"
#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

/// A bore for the next shaft on sale, with its key.
core::Suggestion thicker(const std::string& part, const ShaftLoad& load, double most_MPa) {
    const auto size = checks::shaft_sizes().at_least(core::mm_from_m(load.diameter) * std::cbrt(load.stress_MPa / most_MPa));
    if (!size) return "a nearer bearing: between the parts on the shaft";
    core::Suggestion bore = core::change(part + ".hub.bore_mm", core::number(*size));
    const checks::KeySize* key = checks::key_size(core::m_from_mm(*size));
    if (!load.keyed || key == nullptr) return bore;
    return bore.with(part + ".hub.key_width_mm", core::number(core::mm_from_m(key->width)))
        .with(part + ".hub.key_depth_mm", core::number(core::mm_from_m(key->hub_depth)));
}

core::Finding judged_shaft(const char* shaft, const char* bearing, const std::string& part, const ShaftLoad& load, const Allowed& allowed) {
    const double most = allowed_shaft_stress_MPa(load.keyed);
    core::Finding f = checks::compare(load.stress_MPa, {allowed("required", 2.0 * most), allowed("review", most)});
    f.what = fmt::format("shear stress of the {} of {:g} mm at its bearing, {}, by {:.3g} Nm of bending and {:.3g} Nm of torsion", shaft,
                         core::mm_from_m(load.diameter), bearing, load.moment, load.torque);
    f.where = shaft;
    f.suggestion = thicker(part, load, f.allowed);
    return f;
}

core::Findings measure_joint_shaft_strength(const Assembly& assembly, const Allowed& allowed) {
    core::Findings all{judged_shaft("motor_shaft", "beside k_pe or behind the set collar", "k_pe", motor_shaft_load(assembly), allowed),
                       judged_shaft("axle", "the sleeve in the carriage", "k_se", axle_load(assembly), allowed)};
    if (assembly.find("bearings") != nullptr)
        all.push_back(judged_shaft("joint_shaft", "in joint_tower", "k_pe", joint_shaft_load(assembly), allowed));
    return all;
}

}  // namespace

Rule joint_shaft_strength() {
    return {
        {"joint.shaft_strength",
         "a shaft that bends for good under the cables",
         "16 sqrt((1.5 M)^2 + T^2)/(pi d^3) of motor shaft, spool axle and joint's shaft, at their nearest bearings, over the working "
         "range",
         "ASME code: 0.3 of the yield strength, 0.18 of the tensile strength, a quarter less with a keyway (engineersedge, careerride); "
         "42CrMo4+QT: 900 and 1100 MPa (Saarstahl); twice that breaks the shaft (practice)",
         {required(kAtMost, "MPa", "twice the review limit"), review(kAtMost, "MPa", "198 MPa, 148.5 MPa with a keyway")}},
        measure_joint_shaft_strength};
}

}  // namespace fusee::assembly
