#include "fusee/joint_model/build_parameters.h"

#include <algorithm>
#include <cmath>

namespace fusee::joint_model {

namespace {

constexpr double kHandDamping = 0.3;  ///< one sigma of the hand's damping, of its logarithm
constexpr double kHandShare = 0.04;   ///< of settle_share

/// max(0, x) with a round corner: the slope does not vanish where a fit has no friction.
double positive(double x, double corner) {
    if (corner <= 0.0) return std::max(0.0, x);
    return x > 0.0 ? x + corner * std::log1p(std::exp(-x / corner)) : corner * std::log1p(std::exp(x / corner));
}

void add_side(const gap_case::Case& gap_case, int side, std::vector<BuildParameter>& all) {
    const gap_case::Tolerance& t = gap_case.tolerance;
    const double ratio = gap_case.rig.ratio(), inertia = gap_case.rig.motor_inertia;
    const std::string of = std::string(" ") + to_string(static_cast<gap_case::Side>(side));
    const auto add = [&](const char* name, const char* unit, double sigma, std::function<void(BuiltSide&, double)> change) {
        all.push_back({name + of, unit, sigma, [side, change](BuiltRig& rig, double x) { change(rig.sides[side], x); }, true});
    };
    add("gear load friction", "1", t.gear_load_friction * gap_case.rig.gear_load_friction,
        [](BuiltSide& s, double x) { s.gear.load_friction += x; });
    add("K_SE rate", "1", t.spring_rate, [](BuiltSide& s, double x) { s.se_build.rate += x; });
    add("K_PE rate", "1", t.spring_rate, [](BuiltSide& s, double x) { s.pe_build.rate += x; });
    add("K_SE radius", "m", t.se_radius, [](BuiltSide& s, double x) { s.se_build.radius += x; });
    add("K_PE radius", "m", t.pe_radius, [](BuiltSide& s, double x) { s.pe_build.radius += x; });
    add("K_SE preload", "rad", t.se_preload, [](BuiltSide& s, double x) { s.se_build.preload += x; });
    add("K_PE preload", "m", t.pe_preload, [](BuiltSide& s, double x) { s.pe_build.preload += x; });
    add("torque scale", "1", t.torque_scale, [](BuiltSide& s, double x) { s.gear.torque_scale += x; });
    add("joint radius", "1", t.radii, [ratio](BuiltSide& s, double x) { s.ratio += ratio * x; });
    add("capstan radius", "1", t.radii, [](BuiltSide& s, double x) { s.capstan_scale += x; });
    add("motor inertia", "1", t.inertia, [inertia](BuiltSide& s, double x) { s.motor_inertia += inertia * x; });
}

}  // namespace

std::vector<BuildParameter> build_parameters(const gap_case::Case& gap_case) {
    std::vector<BuildParameter> all;
    const gap_case::Tolerance& t = gap_case.tolerance;
    for (const int side : {0, 1}) add_side(gap_case, side, all);
    const double joint = gap_case.rig.joint_inertia;
    all.push_back({"joint inertia", "1", t.inertia, [joint](BuiltRig& r, double x) { r.joint_inertia += joint * x; }});
    all.push_back({"joint bearing friction", "Nm", t.joint_coulomb,
                   [usual = t.joint_coulomb](BuiltRig& r, double x) { r.joint_coulomb += positive(usual + x, 0.5 * usual); }});
    all.push_back({"joint encoder zero", "rad", t.joint_offset, [](BuiltRig& r, double x) { r.joint_offset += x; }});
    all.push_back({"hand damping", "log", kHandDamping, [](BuiltRig& r, double x) { r.hand.damping *= std::exp(x); }, false});
    all.push_back({"hand settling share", "1", kHandShare,
                   [](BuiltRig& r, double x) { r.hand.settle_share = std::clamp(r.hand.settle_share + x, 0.0, 0.9); }, false});
    return all;
}

}  // namespace fusee::joint_model
