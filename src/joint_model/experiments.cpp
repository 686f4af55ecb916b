#include "experiments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "fusee/joint_model/hysteresis.h"

namespace fusee::joint_model {

namespace {

/// Number of stretches of rows with the same key.
template <class Row, class Key>
double stretches(const std::vector<Row>& rows, const Key& key) {
    double count = rows.empty() ? 0.0 : 1.0;
    for (std::size_t i = 1; i < rows.size(); ++i) count += key(rows[i]) == key(rows[i - 1]) ? 0.0 : 1.0;
    return count;
}

double duration(const gap_case::Rows& rows, const gap_case::Protocol& p, gap_case::Experiment experiment) {
    switch (experiment) {
        case gap_case::Experiment::kBreakAway:
            return static_cast<double>(rows.breakaway.size()) * break_away_time(p);
        case gap_case::Experiment::kSpringPull:
            return p.cocontraction_phase *
                   stretches(rows.spring_pull, [](const auto& row) { return std::tuple(row.series, row.side, row.load); });
        case gap_case::Experiment::kDeadBand:
            return rows.dead_band.empty() ? 0.0 : dead_band_until(rows, p, rows.dead_band.size() - 1);
        case gap_case::Experiment::kJointStiffness:
            return (p.motor_ramp + p.motor_settle) * stretches(rows.joint_stiffness, [](const auto& row) { return row.cocontraction; }) +
                   p.joint_stiffness_phase *
                       stretches(rows.joint_stiffness, [](const auto& row) { return std::tuple(row.cocontraction, row.phase); });
        case gap_case::Experiment::kCocontraction:
            return p.cocontraction_phase * stretches(rows.cocontraction, [](const auto& row) { return row.up; });
        case gap_case::Experiment::kLog:
            return rows.log.empty() ? 0.0 : rows.log.back().time - rows.log.front().time;
    }
    return 0.0;
}

constexpr double kLocked = 1e3;  ///< replaces a load that does not exist because friction grows faster, on the reference rig [Nm]

/// The load at which |load - torque| = c + m load + k load^2, on the side above (backdrive) or below the torque.
double break_away_load(double torque, double way, double c, double m, double k, double locked) {
    double load = (torque + way * c) / (1.0 - way * m);
    for (int i = 0; i < 20 && k != 0.0; ++i) load = std::min(locked, (torque + way * (c + k * load * load)) / (1.0 - way * m));
    return std::max(0.0, load);
}

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

double dead_band_until(const gap_case::Rows& rows, const gap_case::Protocol& p, std::size_t i) {
    const std::size_t row = rows.dead_band[i].row > 0 ? rows.dead_band[i].row : i + 1;
    return static_cast<double>(row) * (p.motor_ramp + p.motor_settle + 2.0 * (p.dead_band_push + p.dead_band_release));
}

double session_at(const gap_case::Rows& rows, const gap_case::Protocol& protocol, gap_case::Experiment experiment) {
    double begin = 0.0;
    for (const gap_case::Experiment before : gap_case::kAllExperiments) {
        if (before == experiment) break;
        begin += duration(rows, protocol, before);
    }
    return begin;
}

std::vector<double> predict_break_away(const BuiltRig& rig, const std::vector<gap_case::BreakAway>& rows,
                                       const gap_case::Protocol& protocol) {
    std::vector<double> loads;
    const double locked = kLocked * rig.reference.torque;
    for (const gap_case::BreakAway& row : rows) {
        const Gear& gear = rig.sides[row.side == to_string(gap_case::Side::kAgonist) ? 0 : 1].gear;
        const double way = row.backdrive ? 1.0 : -1.0;  // the load drives back: the cable pays out
        const double session = break_away_time(protocol) * static_cast<double>(loads.size());
        const double at_rest = (1.0 + gear.stribeck) * (1.0 - way * gear.asymmetry) * gear.terms.friction_drift.factor(session);
        const double command = row.motor_torque * gear.terms.torque_drift.factor(session);
        const double torque = std::min(gear.saturation, command * (1.0 + gear.torque_scale));
        loads.push_back(break_away_load(torque, way, at_rest * gear.coulomb, std::min(0.95, at_rest * gear.load_friction),
                                        at_rest * gear.quadratic, locked));
    }
    return loads;
}

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
