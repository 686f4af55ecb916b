#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "csv.h"
#include "fields.h"
#include "fusee/core/error.h"
#include "fusee/gap_case/likely_unit.h"
#include "fusee/gap_case/reference.h"
#include "fusee/math/statistics.h"

namespace fusee::gap_case {

namespace {

constexpr std::size_t kEnough = 30;  // rows for a statement on signs and steps
constexpr std::size_t kFew = 10;     // rows of one experiment
constexpr double kMuchPull = 9.0;    // measured over nominal: kgf cm read as Nm would be 10.2, and no spring is that far off
constexpr double kMuchLoad = 25.0;   // load over motor torque: a friction of 0.95 of the load makes 20 of it

template <class Row, class Get>
std::vector<double> column(const std::vector<Row>& rows, const Get& get) {
    std::vector<double> figures(rows.size());
    std::transform(rows.begin(), rows.end(), figures.begin(), get);
    return figures;
}

/// Pearson's coefficient; 0 where one of the two does not change.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto mean = [](const std::vector<double>& x) {
        double sum = 0.0;
        for (const double value : x) sum += value;
        return sum / static_cast<double>(x.size());
    };
    const double a0 = mean(a), b0 = mean(b);
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - a0) * (b[i] - b0);
        aa += (a[i] - a0) * (a[i] - a0);
        bb += (b[i] - b0) * (b[i] - b0);
    }
    return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

double nominal_torque(const NominalRig& rig, bool series, double deflection) {
    const auto torque = [series](const NominalRig::SpringRow& row) { return series ? row.se_torque : row.pe_torque; };
    const auto above = std::find_if(rig.springs.begin() + 1, rig.springs.end() - 1,
                                    [deflection](const NominalRig::SpringRow& row) { return row.deflection >= deflection; });
    const NominalRig::SpringRow &b = *above, &a = *(above - 1);
    return torque(a) + (torque(b) - torque(a)) * (deflection - a.deflection) / (b.deflection - a.deflection);
}

/// The unit of values that are `ratio` times those in Nm over rad.
std::string likely_unit(double ratio) {
    static const std::vector<OtherUnit> kUnits{{1000.0, "are the torques Nmm"},
                                               {100.0, "are the torques Ncm"},
                                               {10.2, "are the torques kgf cm"},
                                               {core::kPi / 180.0, "are the deflections degrees"},
                                               {0.001, "are the deflections milliradians"}};
    return likely_unit(ratio, kUnits);
}

class Checker {
public:
    Checker(const Case& gap_case, fs::path folder, std::string springs)
        : gap_case_(gap_case), rows_(gap_case.rows), folder_(std::move(folder)), springs_(std::move(springs)) {}

    std::vector<std::string> check() && {
        check_springs();
        check_commands();
        check_carried();
        check_travel();
        check_directions();
        check_loads();
        check_pull();
        check_ends();
        check_stiffness();
        check_log();
        check_encoders();
        check_counts();
        return std::move(remarks_);
    }

private:
    /// Named by the first file of the experiment.
    [[nodiscard]] core::InvalidInput fault(Experiment experiment, const std::string& columns, std::string value,
                                           std::string allowed) const {
        const std::string file = (folder_ / gap_case_.files.at(experiment).front()).string();
        return {fmt::format("{}: {}", file, columns), std::move(value), std::move(allowed)};
    }

    [[nodiscard]] core::InvalidInput springs_fault(const std::string& columns, std::string value, std::string allowed) const {
        return {fmt::format("{}: {}", (folder_ / springs_).string(), columns), std::move(value), std::move(allowed)};
    }

    /// Cams need curves that rise everywhere over a plausible capstan angle.
    void check_springs() const {
        constexpr double kLeastEnd = 0.1;  // [rad]
        const double end = gap_case_.rig.springs.back().deflection;
        if (end < kLeastEnd)
            throw springs_fault("deflection_rad", fmt::format("at most {:g}", end),
                                fmt::format("radians at the capstan, to {:g} at least; are these another unit?", kLeastEnd));
        try {
            gap_case_.rig.require_rising_springs();
        } catch (const core::InvalidInput& e) {
            throw springs_fault("se_torque_Nm, pe_torque_Nm", e.value(), e.allowed());
        }
    }

    void check_travel() const {
        constexpr double kMostAngle = 30.0, kMostTravel = 0.25, kLeastTravel = 1e-4;  // [m], of the reference rig
        const double radius = reference_of(gap_case_.rig).radius;
        const BaseTravel travel = base_travel(gap_case_.rig);
        const std::string file = (folder_ / "case.toml").string();
        if (travel.spool_angle > kMostAngle)
            throw core::InvalidInput(
                file + ": rig.se_torsion_rate_Nm_per_rad", fmt::format("{:g}", gap_case_.rig.se_torsion_rate),
                fmt::format("a rate in Nm/rad, and springs in Nm over rad: the spool would turn by {:.3g} rad", travel.spool_angle));
        if (travel.compression > kMostTravel * radius || travel.compression < kLeastTravel * radius)
            throw core::InvalidInput(
                file + ": rig.pe_compression_rate_N_per_m", fmt::format("{:g}", gap_case_.rig.pe_compression_rate),
                fmt::format("a rate in N/m, and springs in Nm over rad: the spring would deflect by {:.3g} m", travel.compression));
    }

    /// Commands far below the spring torques are in another unit.
    void check_commands() const {
        constexpr double kLeastShare = 0.03;  // of the springs' greatest torque: rigs use half of it, Ncm would be a hundredth
        const double springs = gap_case_.rig.springs.back().se_torque + gap_case_.rig.springs.back().pe_torque;
        for_each_experiment(rows_, [&]<class Row>(Experiment experiment, const std::vector<Row>& rows) {
            for (const Field<Row>& field : fields<Row>()) {
                if (field.measured || field.quantity != Quantity::kPull || rows.empty()) continue;
                const std::vector<double> torques = column(rows, field.get);
                const double greatest = *std::max_element(torques.begin(), torques.end());
                if (greatest > 0.0 && greatest < kLeastShare * springs)
                    throw fault(experiment, field.column, fmt::format("at most {:.3g}", greatest),
                                fmt::format("Nm; the springs reach {:.3g} Nm: is one of the two in another unit (Ncm)?", springs));
            }
        });
    }

    /// Friction is positive: a load above the motor torque drives back, one below it is lifted.
    void check_directions() {
        std::size_t rows[2] = {0, 0}, wrong[2] = {0, 0};
        for (const BreakAway& row : rows_.breakaway) {
            ++rows[row.backdrive];
            wrong[row.backdrive] += row.friction() < 0.0 ? 1 : 0;
        }
        const bool swapped = wrong[0] * 2 > rows[0] && wrong[1] * 2 > rows[1];
        if (swapped)
            throw fault(Experiment::kBreakAway, "direction",
                        fmt::format("{} of {} loads on the wrong side", wrong[0] + wrong[1], rows_.breakaway.size()),
                        "backdrive with a load above the motor torque, drive with one below it: are the two swapped?");
        if (wrong[0] + wrong[1] > 0)
            remarks_.push_back(fmt::format("breakaway: {} of {} loads lie on the wrong side of the motor torque for their direction",
                                           wrong[0] + wrong[1], rows_.breakaway.size()));
    }

    void check_loads() const {
        double loads = 0.0, motors = 0.0;
        for (const BreakAway& row : rows_.breakaway) {
            loads += std::abs(row.load_torque);
            motors += std::abs(row.motor_torque);
        }
        if (motors > 0.0 && (loads > kMuchLoad * motors || motors > kMuchLoad * loads))
            throw fault(Experiment::kBreakAway, "load_torque_Nm", fmt::format("{:.3g} times the motor torques", loads / motors),
                        fmt::format("Nm at the capstan, as the motor torques{}", likely_unit(loads / motors)));
    }

    /// Torque of the nominal springs at the measured angles over the motor torque: friction changes it by a share, a wrong unit by a
    /// factor.
    void check_carried() const {
        double carried = 0.0, given = 0.0;
        const auto add = [&](double theta, double torque) {
            if (theta > 0.0) carried += nominal_torque(gap_case_.rig, true, theta) + nominal_torque(gap_case_.rig, false, theta);
            given += std::abs(torque);
        };
        const auto judge = [&](Experiment experiment) {
            if (given > 0.0 && (carried > kMuchPull * given || given > kMuchPull * carried))
                throw fault(experiment, "theta_agonist_rad, theta_antagonist_rad",
                            fmt::format("angles at which the springs carry {:.3g} times the motor torques", carried / given),
                            fmt::format("springs and motor torques in Nm, angles and deflections in rad{}", likely_unit(carried / given)));
            carried = given = 0.0;
        };
        for (const CocontractionRow& row : rows_.cocontraction) {
            add(row.theta_agonist, row.motor_torque);
            add(row.theta_antagonist, row.motor_torque);
        }
        judge(Experiment::kCocontraction);
        for (const LogRow& row : rows_.log) {
            add(row.theta_agonist, row.torque_agonist);
            add(row.theta_antagonist, row.torque_antagonist);
        }
        judge(Experiment::kLog);
    }

    void check_pull() const {
        for (const bool series : {true, false}) {
            double measured = 0.0, nominal = 0.0;
            for (const SpringPull& row : rows_.spring_pull) {
                if (row.series != series) continue;
                measured += std::abs(row.torque);
                nominal += std::abs(nominal_torque(gap_case_.rig, series, row.deflection));
            }
            if (nominal > 0.0 && (measured > kMuchPull * nominal || nominal > kMuchPull * measured))
                throw fault(
                    Experiment::kSpringPull, "torque_Nm",
                    fmt::format("{:.3g} times the torque of {}'s nominal curve", measured / nominal, series ? "se" : "pe"),
                    fmt::format("torques in Nm at the capstan over deflections in rad at the capstan{}", likely_unit(measured / nominal)));
        }
    }

    void check_ends() const {
        const double noise = 10.0 * (gap_case_.sensors.encoder_step + gap_case_.sensors.encoder_noise);
        for (const DeadBandRow& row : rows_.dead_band)
            if (row.width < -noise)
                throw fault(Experiment::kDeadBand, "q_low_rad, q_high_rad",
                            fmt::format("{:g} above {:g} at {:g} Nm, repeat {}", row.q_low, row.q_high, row.cocontraction, row.repeat),
                            "q_low_rad below q_high_rad");
    }

    void check_stiffness() const {
        constexpr double kWrongWay = -0.3;  // faultless and faulty rigs: 0.57 to 0.91
        const auto& rows = rows_.joint_stiffness;
        if (rows.size() < kEnough) return;
        const double r = correlation(column(rows, [](const auto& row) { return row.joint_torque; }),
                                     column(rows, [](const auto& row) { return row.q; }));
        if (r < kWrongWay)
            throw fault(Experiment::kJointStiffness, "q_rad", "falls as joint_torque_Nm rises",
                        "a joint that follows its torque: one of the two has the wrong sign");
    }

    /// The agonist winds in: the joint goes down (docs/gap.md). Faultless and faulty rigs: -0.57 to -0.97, 0.16 to 0.65.
    void check_log() {
        constexpr double kJoint = 0.3, kMotors = -0.3;
        const auto& rows = rows_.log;
        check_rate();
        if (rows.size() < kEnough) return;
        const auto capstans = column(rows, [](const LogRow& row) { return row.theta_agonist - row.theta_antagonist; });
        const auto motors = column(rows, [](const LogRow& row) { return row.torque_agonist - row.torque_antagonist; });
        if (correlation(capstans, column(rows, [](const LogRow& row) { return row.q; })) > kJoint)
            throw fault(Experiment::kLog, "q_rad", "rises as the agonist winds in",
                        "a joint that the agonist turns to negative q: are the sides swapped, or the sign of q?");
        const double motors_turn = correlation(capstans, motors);
        if (motors_turn < 0.0 && motors_turn >= kMotors)
            remarks_.emplace_back(
                "log: the capstans hardly follow their motors; if the sides of torques or angles are swapped, the diagnosis swaps them "
                "too");
        if (motors_turn < kMotors)
            throw fault(Experiment::kLog, "motor_torque_agonist_Nm", "moves the antagonist's capstan",
                        "torques and angles of the same side: are the sides of one of them swapped?");
    }

    void check_rate() {
        constexpr double kMilli = 1000.0, kNear = 0.05, kOther = 1.5;
        const auto& rows = rows_.log;
        if (rows.size() < 3) return;
        std::vector<double> steps;
        for (std::size_t i = 1; i < rows.size(); ++i) steps.push_back(rows[i].time - rows[i - 1].time);
        const double step = math::upper_median(std::move(steps)), ratio = step * gap_case_.sensors.log_rate;
        if (std::abs(ratio / kMilli - 1.0) < kNear)
            throw fault(Experiment::kLog, "t_s", fmt::format("a row every {:g} s", step),
                        fmt::format("seconds: {:g} Hz in [sensors] would be {:g} s; are these milliseconds?", gap_case_.sensors.log_rate,
                                    1.0 / gap_case_.sensors.log_rate));
        if (ratio > kOther || ratio * kOther < 1.0)
            remarks_.push_back(fmt::format("log: a row every {:g} s, where log_rate_Hz = {:g} says {:g} s; the times are taken as they are",
                                           step, gap_case_.sensors.log_rate, 1.0 / gap_case_.sensors.log_rate));
    }

    /// Readings of an encoder are multiples of its step: in degrees or milliradians they are multiples of another one.
    void check_encoder(Experiment experiment, const char* name, const std::vector<double>& readings) const {
        constexpr double kMilli = 1000.0, kDegree = 180.0 / core::kPi;
        if (readings.size() < kEnough || gap_case_.sensors.encoder_step == 0.0) return;
        for (const auto& [unit, factor] : {std::pair{"degrees", kDegree}, {"milliradians", kMilli}})
            if (counted_in(readings, factor * gap_case_.sensors.encoder_step))
                throw fault(
                    experiment, name, fmt::format("multiples of {:.4g}", factor * gap_case_.sensors.encoder_step),
                    fmt::format("radians, with the encoder's step of {:.4g} rad; are these {}?", gap_case_.sensors.encoder_step, unit));
    }

    void check_encoders() const {
        for_each_experiment(rows_, [this]<class Row>(Experiment experiment, const std::vector<Row>& rows) {
            for (const Field<Row>& field : fields<Row>())
                if (field.measured && (field.quantity == Quantity::kJointAngle || field.quantity == Quantity::kCapstanAngle))
                    check_encoder(experiment, field.column, column(rows, field.get));
        });
    }

    void check_counts() {
        constexpr std::size_t kFewInAll = 30;
        for (const auto& [experiment, files] : gap_case_.files)
            if (rows_.size(experiment) < kFew)
                remarks_.push_back(
                    fmt::format("{}: {} rows only, which carry little weight", to_string(experiment), rows_.size(experiment)));
        if (rows_.size() < kFewInAll)
            remarks_.push_back(fmt::format("{} rows in all: only a large effect can be distinguished from scatter", rows_.size()));
        if (rows_.dead_band_width_only)
            remarks_.emplace_back("dead_band: the table holds widths only, which do not show the side of a fault");
    }

    const Case& gap_case_;
    const Rows& rows_;
    fs::path folder_;
    std::string springs_;
    std::vector<std::string> remarks_;
};

}  // namespace

BaseTravel base_travel(const NominalRig& rig) {
    double series = 0.0, parallel = 0.0;  // energies, by the trapezoidal rule
    for (std::size_t i = 1; i < rig.springs.size(); ++i) {
        const NominalRig::SpringRow &a = rig.springs[i - 1], &b = rig.springs[i];
        series += 0.5 * (a.se_torque + b.se_torque) * (b.deflection - a.deflection);
        parallel += 0.5 * (a.pe_torque + b.pe_torque) * (b.deflection - a.deflection);
    }
    return {std::sqrt(2.0 * series / rig.se_torsion_rate), std::sqrt(2.0 * parallel / rig.pe_compression_rate)};
}

std::vector<std::string> check_rows(const Case& gap_case, const fs::path& folder, const std::string& springs) {
    return Checker(gap_case, folder, springs).check();
}

}  // namespace fusee::gap_case
