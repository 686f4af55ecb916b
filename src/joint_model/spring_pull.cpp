#include "experiments.h"
#include "fusee/joint_model/hysteresis.h"

namespace fusee::joint_model {

std::vector<double> predict_spring_pull(const BuiltRig& rig, const std::vector<gap_case::SpringPull>& rows) {
    std::vector<double> torques;
    std::array<Hysteresis, 4> memory;
    for (const gap_case::SpringPull& row : rows) {
        const int side = static_cast<int>(row.side);
        const BuiltSide& built = rig.sides[side];
        const CamSpring& spring = row.series ? built.se : built.pe;
        const double a = row.series ? built.se_build.hysteresis : built.pe_build.hysteresis;
        const double scale = row.series ? rig.capstan_scale : 1.0, x = scale * row.deflection;
        torques.push_back(memory[2 * side + (row.series ? 0 : 1)].torque(x, scale * spring.torque(x), a));
    }
    return torques;
}

}  // namespace fusee::joint_model
