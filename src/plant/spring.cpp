#include <algorithm>
#include <cmath>

#include "fusee/plant/machine.h"

namespace fusee::plant {

namespace {

constexpr std::size_t kRows = 8192;
constexpr std::size_t kBeyond = 600;   // rows that go on behind the drawing's last arm
constexpr double kLeastArm = 2e-4;     // [m]: no cable runs closer to its axis
constexpr double kBindingRate = 20.0;  // a compression spring whose coils touch, over its own rate

/// A cam of the drawing: its arm over the state of its spool or the angle of its capstan.
struct CamArms {
    std::vector<double> place, arm;
};

/// Deflection of the base spring for the energy of each row, and the drawing's arm at it; the first row, where both torque and
/// deflection are 0, continues the next two.
CamArms cam_arms_of(const std::vector<double>& deflection, const std::vector<double>& torque, double rate, double capstan_radius,
                    bool series) {
    CamArms cam;
    const std::vector<double> energy = energy_of(deflection, torque);
    for (std::size_t i = 0; i < deflection.size(); ++i) {
        const double state = std::sqrt(2.0 * energy[i] / rate);
        cam.place.push_back(series ? state : deflection[i]);
        if (i == 0)
            cam.arm.push_back(0.0);
        else
            cam.arm.push_back(series ? rate * state * capstan_radius / torque[i] : torque[i] / (rate * state));
    }
    cam.arm[0] = 2.0 * cam.arm[1] - cam.arm[2];
    const double step = 0.001 * cam.place.back();
    for (std::size_t i = 0; i < kBeyond; ++i) {
        cam.place.push_back(cam.place.back() + step);
        cam.arm.push_back(cam.arm.back());
    }
    return cam;
}

double cut_arm(double arm, double place, const SpringTruth& truth) {
    const double whole = arm + truth.radius_offset;
    return std::max(kLeastArm, place < truth.crack_at ? whole : whole * (1.0 - truth.crack_share));
}

}  // namespace

TorqueTable::TorqueTable(const std::vector<double>& x, const std::vector<double>& torque) : torque_(kRows + 1) {
    const double step = x.back() / static_cast<double>(kRows);
    std::size_t row = 0;
    for (std::size_t i = 0; i <= kRows; ++i) {
        const double wanted = std::min(static_cast<double>(i) * step, x.back());
        while (row + 2 < x.size() && x[row + 1] <= wanted) ++row;
        const double width = x[row + 1] - x[row];
        const double share = width > 0.0 ? (wanted - x[row]) / width : 1.0;
        torque_[i] = torque[row] + share * (torque[row + 1] - torque[row]);
    }
    per_step_ = 1.0 / step;
    last_ = static_cast<double>(kRows - 1);
}

TorqueTable build_series(const Nominal& nominal, const SideTruth& side) {
    const CamArms cam = cam_arms_of(nominal.springs.deflection, nominal.springs.se, nominal.torsion_rate, nominal.capstan_radius, true);
    std::vector<double> deflection, torque;
    double cable = 0.0, arm_before = 0.0;
    for (std::size_t i = 0; i < cam.place.size(); ++i) {
        const double arm = cut_arm(cam.arm[i], cam.place[i], side.se);
        if (i > 0) cable += 0.5 * (arm + arm_before) * (cam.place[i] - cam.place[i - 1]);
        arm_before = arm;
        const double spool = std::max(0.0, side.se.rate * (cam.place[i] + side.se.preload));
        const double pull = spool * side.capstan_radius / arm;
        const double stretched = cable / side.capstan_radius + pull / side.se.cable_stiffness;
        deflection.push_back(i == 0 ? 0.0 : std::max(stretched, deflection.back()));
        torque.push_back(pull);
    }
    return {deflection, torque};
}

TorqueTable build_parallel(const Nominal& nominal, const SideTruth& side) {
    const CamArms cam =
        cam_arms_of(nominal.springs.deflection, nominal.springs.pe, nominal.compression_rate, nominal.capstan_radius, false);
    std::vector<double> torque;
    double pressed = 0.0, arm_before = 0.0;
    for (std::size_t i = 0; i < cam.place.size(); ++i) {
        const double arm = cut_arm(cam.arm[i], cam.place[i], side.pe);
        if (i > 0) pressed += 0.5 * (arm + arm_before) * (cam.place[i] - cam.place[i - 1]);
        arm_before = arm;
        const double state = std::max(0.0, pressed + side.pe.preload);
        const double bound = std::max(0.0, state - side.pe.bottoming);
        torque.push_back(side.pe.rate * (state + kBindingRate * bound) * arm);
    }
    return {cam.place, torque};
}

}  // namespace fusee::plant
