#include <cmath>

#include "experiments.h"
#include "fusee/joint_model/hysteresis.h"

namespace fusee::joint_model {

namespace {

std::size_t place_of(const gap_case::SpringPull& row) { return 2 * static_cast<std::size_t>(row.side) + (row.series ? 0 : 1); }

/// Torque that each spring lost by relaxation, row by row.
class Relaxations {
public:
    Relaxations(const std::vector<gap_case::SpringPull>& rows, const gap_case::Protocol& protocol)
        : seconds_(2.0 * protocol.cocontraction_phase) {
        for (const gap_case::SpringPull& row : rows) ++rows_of_[place_of(row)];
    }
    [[nodiscard]] double after(std::size_t place, double torque, const SpringTerms& terms) {
        if (terms.relaxation == 0.0) return torque;
        const double step = seconds_ / static_cast<double>(rows_of_[place]);
        relaxed_[place] -= std::expm1(-step / terms.relaxation_time) * (torque - relaxed_[place]);
        return terms.relaxed(torque, relaxed_[place]);
    }

private:
    double seconds_;
    std::array<std::size_t, 4> rows_of_{};
    std::array<double, 4> relaxed_{};
};

}  // namespace

std::vector<double> predict_spring_pull(const BuiltRig& rig, const std::vector<gap_case::SpringPull>& rows,
                                        const gap_case::Protocol& protocol) {
    std::vector<double> torques;
    std::array<Hysteresis, 4> memory;
    Relaxations relaxations(rows, protocol);
    for (const gap_case::SpringPull& row : rows) {
        const std::size_t place = place_of(row);
        const BuiltSide& built = rig.sides[static_cast<std::size_t>(row.side)];
        const CamSpring& spring = row.series ? built.se : built.pe;
        const double a = row.series ? built.se_build.hysteresis : built.pe_build.hysteresis;
        const double scale = row.series ? built.capstan_scale : 1.0, x = scale * row.deflection;
        const double torque = memory[place].torque(x, scale * spring.torque(x), a);
        torques.push_back(relaxations.after(place, torque, row.series ? built.se_terms : built.pe_terms));
    }
    return torques;
}

}  // namespace fusee::joint_model
