#include <cmath>

#include "experiments.h"
#include "fusee/joint_model/hysteresis.h"

namespace fusee::joint_model {

namespace {

std::size_t place_of(const gap_case::SpringPull& row) { return 2 * static_cast<std::size_t>(row.side) + (row.series ? 0 : 1); }

/// The time of each row in the session, and the torque that each spring lost by relaxation, row by row.
class Relaxations {
public:
    Relaxations(const gap_case::Rows& rows, const gap_case::Protocol& protocol)
        : seconds_(2.0 * protocol.cocontraction_phase), session_(session_at(rows, protocol, gap_case::Experiment::kSpringPull)) {
        for (const gap_case::SpringPull& row : rows.spring_pull) ++rows_of_[place_of(row)];
    }
    [[nodiscard]] double session() const { return session_; }  ///< of the next row [s]
    [[nodiscard]] double after(std::size_t place, double torque, const SpringTerms& terms) {
        const double step = seconds_ / static_cast<double>(rows_of_[place]);
        session_ += step;
        if (terms.relaxation == 0.0) return torque;
        relaxed_[place] -= std::expm1(-step / terms.relaxation_time) * (torque - relaxed_[place]);
        return terms.relaxed(torque, relaxed_[place]);
    }

private:
    double seconds_, session_;
    std::array<std::size_t, 4> rows_of_{};
    std::array<double, 4> relaxed_{};
};

}  // namespace

std::vector<double> predict_spring_pull(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    std::vector<double> torques;
    std::array<Hysteresis, 4> memory;
    Relaxations relaxations(rows, protocol);
    for (const gap_case::SpringPull& row : rows.spring_pull) {
        const std::size_t place = place_of(row);
        const BuiltSide& built = rig.sides[static_cast<std::size_t>(row.side)];
        const CamSpring& spring = row.series ? built.se : built.pe;
        const double a = row.series ? built.se_build.hysteresis : built.pe_build.hysteresis;
        const double scale = row.series ? built.capstan_scale : 1.0, x = scale * row.deflection;
        const SpringTerms& terms = row.series ? built.se_terms : built.pe_terms;
        const double elastic = scale * spring.torque(x) * terms.drift.factor(relaxations.session());
        torques.push_back(relaxations.after(place, memory[place].torque(x, elastic, a), terms));
    }
    return torques;
}

}  // namespace fusee::joint_model
