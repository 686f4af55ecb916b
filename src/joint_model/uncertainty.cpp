#include "fusee/joint_model/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fusee/gap_case/reference.h"

namespace fusee::joint_model {

namespace {

// Accuracy of the prediction, one sigma, found on faultless rigs (docs/theory/diagnosis.md, eq. 7); of the range of what moves.
constexpr double kDeadBandAccuracy = 0.015;      ///< of the width
constexpr double kStiffnessAccuracy = 0.002;     ///< of q's range at that co-contraction
constexpr double kCocontractionAccuracy = 6e-4;  ///< of the capstans' range
constexpr double kLogAccuracy = 1.2e-3;          ///< of the greatest range, at the beginning
constexpr double kLogGrowth = 1.2e-3;            ///< and more of it every second of the reference rig: small errors grow on the way
/// The same on a rig that sticks and slips, where the moment of a slip is random.
constexpr double kSlippingDeadBand = 0.05, kSlippingStiffness = 0.01, kSlippingCocontraction = 0.02;
constexpr double kStands = 4.0, kMoves = 15.0;  ///< encoder steps from row to row
constexpr int kManyStops = 4;                   ///< of both capstans; ramps that only turn have 2 at most
/// Shares of independent rows, from the autocorrelation of the residuals of faultless rigs.
constexpr std::array<double, gap_case::kExperiments> kIndependent{1.0, 0.7, 0.33, 0.15, 0.1, 0.06};

template <typename RowList, typename Figure>
double range_of(const RowList& rows, const Figure& figure) {
    double low = 1e300, high = -1e300;
    for (const auto& row : rows) {
        low = std::min(low, figure(row));
        high = std::max(high, figure(row));
    }
    return rows.empty() ? 0.0 : high - low;
}

/// Greatest slope of the nominal springs: turns an encoder's error into a torque's.
double steepness(const std::vector<gap_case::NominalRig::SpringRow>& springs, bool series, double x) {
    for (std::size_t i = 1; i < springs.size(); ++i)
        if (springs[i].deflection >= x || i + 1 == springs.size()) {
            const double rise = series ? springs[i].se_torque - springs[i - 1].se_torque : springs[i].pe_torque - springs[i - 1].pe_torque;
            return rise / (springs[i].deflection - springs[i - 1].deflection);
        }
    return 0.0;
}

/// Number of times a capstan stops between two moves while co-contraction continues in one direction.
int stops_on_the_way(const std::vector<gap_case::CocontractionRow>& rows, double gap_case::CocontractionRow::*angle, double step) {
    int stops = 0;
    bool moved = false, stands = false;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].up != rows[i - 1].up) moved = stands = false;
        const double way = std::abs(rows[i].*angle - rows[i - 1].*angle);
        if (way > kMoves * step) {
            stops += moved && stands ? 1 : 0;
            moved = true;
            stands = false;
        } else if (way < kStands * step) {
            stands = true;
        }
    }
    return stops;
}

class Maker {
public:
    Maker(const gap_case::Case& gap_case, const Scatter& scatter) : gap_case_(gap_case), rows_(gap_case.rows) {
        result_.scatter = scatter;
        const gap_case::Sensors& s = gap_case.sensors;
        encoder_ = std::hypot(s.encoder_noise, s.encoder_step / std::sqrt(12.0));
        const double step = std::max(s.encoder_step, s.encoder_noise);
        result_.stick_slip = stops_on_the_way(rows_.cocontraction, &gap_case::CocontractionRow::theta_agonist, step) +
                                 stops_on_the_way(rows_.cocontraction, &gap_case::CocontractionRow::theta_antagonist, step) >=
                             kManyStops;
    }
    Uncertainty make() {
        torques();
        dead_band();
        stiffness();
        paths();
        result_.weight = kIndependent;
        return result_;
    }

private:
    [[nodiscard]] double torque_noise(double torque) const {
        return std::hypot(gap_case_.sensors.torque_noise, gap_case_.sensors.torque_noise_relative * torque);
    }
    void add(gap_case::Experiment experiment, double sensor, double accuracy) {
        result_.sensors[experiment].push_back(sensor);
        result_.sigma[experiment].push_back(std::hypot(sensor, accuracy));
    }
    /// Of the columns of a path: both capstans, joint.
    [[nodiscard]] double encoder(std::size_t column) const { return encoder_ * result_.scatter.encoder.at(column); }
    void torques() {
        for (const gap_case::BreakAway& row : rows_.breakaway) {  // friction mu L scatters, and L (1 -+ mu) = tau
            const double mu = gap_case_.rig.gear_load_friction, lever = row.backdrive ? 1.0 - mu : 1.0 + mu;
            const double friction = gap_case_.sensors.breakaway_scatter * mu * row.motor_torque / (lever * lever);
            add(gap_case::Experiment::kBreakAway, result_.scatter.breakaway * std::hypot(friction, torque_noise(row.motor_torque)), 0.0);
        }
        for (const gap_case::SpringPull& row : rows_.spring_pull)
            add(gap_case::Experiment::kSpringPull,
                result_.scatter.spring_pull *
                    std::hypot(torque_noise(row.torque), encoder_ * steepness(gap_case_.rig.springs, row.series, row.deflection)),
                0.0);
    }
    void dead_band() {
        for (const gap_case::DeadBandRow& row : rows_.dead_band)
            for (std::size_t i = 0; i < (rows_.dead_band_width_only ? 1U : 2U); ++i)
                add(gap_case::Experiment::kDeadBand, encoder(2), (result_.stick_slip ? kSlippingDeadBand : kDeadBandAccuracy) * row.width);
    }
    void stiffness() {
        std::map<double, core::Range> ranges;
        for (const gap_case::StiffnessRow& row : rows_.joint_stiffness) {
            core::Range& range = ranges.try_emplace(row.cocontraction, core::Range{row.q, row.q}).first->second;
            range = {std::min(range.low, row.q), std::max(range.high, row.q)};
        }
        const double accuracy = result_.stick_slip ? kSlippingStiffness : kStiffnessAccuracy;
        for (const gap_case::StiffnessRow& row : rows_.joint_stiffness)
            add(gap_case::Experiment::kJointStiffness, encoder(2), accuracy * ranges.at(row.cocontraction).width());
    }
    void paths() {
        const double up = range_of(rows_.cocontraction, [](const auto& r) { return r.theta_agonist; });
        for (std::size_t i = 0; i < 3 * rows_.cocontraction.size(); ++i)
            add(gap_case::Experiment::kCocontraction, encoder(i % 3),
                (result_.stick_slip ? kSlippingCocontraction : kCocontractionAccuracy) * up);
        const double swing = std::max({range_of(rows_.log, [](const auto& r) { return r.theta_agonist; }),
                                       range_of(rows_.log, [](const auto& r) { return r.theta_antagonist; }),
                                       range_of(rows_.log, [](const auto& r) { return r.q; })});
        const double growth = kLogGrowth / gap_case::reference_of(gap_case_.rig).time;
        double begin = 0.0, last = std::numeric_limits<double>::infinity();
        for (const gap_case::LogRow& row : rows_.log) {
            if (row.time < last) begin = row.time;  // the first row, and each further part whose clock begins anew
            last = row.time;
            for (std::size_t i = 0; i < 3; ++i)
                add(gap_case::Experiment::kLog, encoder(i), swing * (kLogAccuracy + growth * (row.time - begin)));
        }
    }

    const gap_case::Case& gap_case_;
    const gap_case::Rows& rows_;
    double encoder_ = 0.0;
    Uncertainty result_;
};

}  // namespace

Uncertainty uncertainty(const gap_case::Case& gap_case, const Scatter& scatter) { return Maker(gap_case, scatter).make(); }

Uncertainty uncertainty(const gap_case::Case& gap_case) {
    Uncertainty stated = uncertainty(gap_case, {});
    Scatter scatter = measured_scatter(gap_case, stated.sensors);
    return scatter.remarks.empty() ? stated : uncertainty(gap_case, scatter);
}

}  // namespace fusee::joint_model
