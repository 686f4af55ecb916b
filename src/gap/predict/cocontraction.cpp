#include <algorithm>
#include <cmath>

#include "experiments.h"
#include "fusee/gap/motion.h"
#include "reading.h"

namespace fusee::gap {

std::vector<double> predict_cocontraction(const BuiltRig& rig, const std::vector<CocontractionRow>& rows, const Protocol& protocol) {
    double most = 1e-9;
    for (const CocontractionRow& row : rows) most = std::max(most, std::abs(row.motor_torque));
    std::vector<double> read;
    Motion motion(rig, kSlowStep);
    Reading reading(rig);
    double torque = 0.0;
    for (const CocontractionRow& row : rows) {
        motion.lead_to({row.motor_torque, row.motor_torque, 0.0},
                       protocol.cocontraction_phase * std::abs(row.motor_torque - torque) / most);
        torque = row.motor_torque;
        reading.append(motion, read);
    }
    return read;
}

}  // namespace fusee::gap
