#include <algorithm>
#include <cmath>

#include "fusee/plant/case_files.h"

namespace fusee::plant {

namespace {

/// One session of all experiments: their common state.
class Session {
public:
    Session(const TestRig& test_rig, const SetPoints& points, Random& random, double begin, const Engine& engine)
        : engine_(engine),
          test_rig_(test_rig),
          points_(points),
          range_(range_of(test_rig.nominal)),
          springs_(test_rig.nominal, test_rig.truth),
          random_(random),
          now_(begin) {}

    [[nodiscard]] std::vector<BreakAwayRow> break_away();
    [[nodiscard]] std::vector<PullRow> spring_pull();
    [[nodiscard]] std::vector<DeadBandRow> dead_band();
    [[nodiscard]] std::vector<StiffnessRow> joint_stiffness();
    [[nodiscard]] std::vector<CocontractionRow> cocontraction();
    [[nodiscard]] std::vector<LogRow> log();

private:
    // Sensors.
    [[nodiscard]] double encoder(double angle) {
        const double step = test_rig_.sensors.encoder_step;
        return step * std::round((angle + test_rig_.sensors.encoder_noise * random_.normal()) / step);
    }
    [[nodiscard]] double torque_sensor(double torque) {
        const Sensors& s = test_rig_.sensors;
        return torque * (1.0 + s.torque_noise_relative * random_.normal()) + s.torque_noise * random_.normal();
    }
    [[nodiscard]] double read_theta(const Motion& rig, std::size_t side) {
        const SideTruth& built = test_rig_.truth.sides[side];
        const double theta = rig.theta(side);
        // The disc's eccentric shift is 0 where the encoder was zeroed.
        const double shift = built.eccentricity * (std::sin(theta + built.eccentricity_phase) - std::sin(built.eccentricity_phase));
        return encoder(theta + shift);
    }
    [[nodiscard]] double read_q(const Motion& rig) {
        const JointTruth& joint = test_rig_.truth.joint;
        const double q = rig.q();
        const double shift = joint.eccentricity * (std::sin(q + joint.eccentricity_phase) - std::sin(joint.eccentricity_phase)) +
                             warmed(joint.zero_drift, joint.zero_time, rig.session());
        return encoder(joint.encoder_scale * q + shift + joint.flexibility * rig.joint_torque() + joint.encoder_offset);
    }
    // Phases.
    [[nodiscard]] std::unique_ptr<Motion> co_contracted(double torque, double hand);
    [[nodiscard]] double hand(double cocontraction) const;
    [[nodiscard]] double pushed_and_released(Motion& rig, double cocontraction, double push);
    void end(const Motion& rig) { now_ = rig.session(); }
    void pull_spring(bool series, std::size_t side, std::vector<PullRow>& rows);
    [[nodiscard]] Command log_command(double t, double knock) const;

    const Engine& engine_;
    const TestRig& test_rig_;
    const SetPoints& points_;
    RigRange range_;
    BuiltSprings springs_;
    Random& random_;
    double now_;
};

constexpr int kBreakAwayRepeats = 3, kDeadBandRepeats = 3;
constexpr double kBreakAwayTime = 3.0;  // [s] of one break-away
constexpr int kPullRows = 60, kStiffnessRows = 25, kCocontractionRows = 60;
constexpr double kPullTime = 6.0;                        // [s] of a load or an unload
constexpr double kHandAtRest = 0.035, kHandAtTop = 0.1;  // [Nms] at no and at the top torque of the motors
constexpr double kPushScatter = 0.03;                    // scatter of a push by hand

/// 0 to 1 with no speed at either end.
double smooth(double s) {
    s = std::clamp(s, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

std::vector<double> scaled(std::vector<double> values, double scale) {
    for (double& value : values) value = 1e-3 * std::round(1e3 * scale * value);
    return values;
}

}  // namespace

SetPoints set_points(bool heldout, double scale) {
    SetPoints p;
    if (heldout) {
        p.breakaway = scaled({0.15, 0.4, 0.8, 1.2}, scale);
        p.dead_band = scaled({0.18, 0.36, 0.62, 0.9, 1.12, 1.38}, scale);
        p.joint_stiffness = scaled({0.5, 1.05}, scale);
        p.log_torque = 0.95, p.log_swing = 0.25, p.log_slow = 0.15, p.log_fast = 0.65;
    } else {
        p.breakaway = scaled({0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.1, 1.3}, scale);
        p.dead_band = scaled({0.12, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5}, scale);
        p.joint_stiffness = scaled({0.3, 0.8, 1.3}, scale);
    }
    for (double* torque : {&p.log_torque, &p.log_swing, &p.log_knock}) *torque *= scale;
    return p;
}

std::vector<BreakAwayRow> Session::break_away() {
    std::vector<BreakAwayRow> rows;
    for (std::size_t side = 0; side < 2; ++side)
        for (const double motor : points_.breakaway)
            for (const bool backdrive : {true, false})
                for (int repeat = 0; repeat < kBreakAwayRepeats; ++repeat) {
                    const double theta = random_.uniform(0.0, range_.travel);
                    const double scatter = 1.0 + test_rig_.sensors.breakaway_scatter * random_.normal();
                    const double load = engine_.break_away(test_rig_.truth.sides[side], motor, backdrive, theta, scatter, now_);
                    rows.push_back({side, backdrive, motor, std::max(0.0, torque_sensor(load))});
                    now_ += kBreakAwayTime;
                }
    return rows;
}

void Session::pull_spring(bool series, std::size_t side, std::vector<PullRow>& rows) {
    constexpr int kParts = 20;  // between two rows
    const SideTruth& built = test_rig_.truth.sides[side];
    Spring spring = series ? Spring(springs_.se[side], built.se) : Spring(springs_.pe[side], built.pe);
    spring.warm_up(now_);
    const double dt = kPullTime / (kPullRows * kParts);
    for (int i = 0; i <= 2 * kPullRows; ++i) {
        const bool load = i <= kPullRows;
        const double deflection = range_.travel * (load ? i : 2 * kPullRows - i) / kPullRows;
        const double step = (load ? 1.0 : -1.0) * range_.travel / (kPullRows * kParts);
        double torque = 0.0;
        for (int part = kParts - 1; part >= 0; --part) torque = spring.pull(i == 0 ? 0.0 : deflection - part * step, dt);
        rows.push_back({series, side, load, encoder(deflection), torque_sensor(torque)});
    }
    now_ += 2.0 * kPullTime;
}

std::vector<PullRow> Session::spring_pull() {
    std::vector<PullRow> rows;
    for (std::size_t side = 0; side < 2; ++side)
        for (const bool series : {true, false}) pull_spring(series, side, rows);
    return rows;
}

std::unique_ptr<Motion> Session::co_contracted(double torque, double hand) {
    std::unique_ptr<Motion> rig = engine_.start(test_rig_.truth, springs_, now_);
    const Protocol& p = test_rig_.protocol;
    rig->run(p.motor_ramp + p.motor_settle, [&](double t) {
        const double motor = torque * std::min(1.0, t / p.motor_ramp);
        return Command{{motor, motor}, 0.0, hand};
    });
    return rig;
}

/// Damping by hand [Nms]: higher for a stiffer joint, so that it neither swings nor creeps back.
double Session::hand(double cocontraction) const {
    return test_rig_.truth.hand * (kHandAtRest + kHandAtTop * cocontraction / test_rig_.nominal.top_torque);
}

/// Up within 3/4 of the push's time, held for the rest; down within 4/5 of the release's time, left to rest, read.
double Session::pushed_and_released(Motion& rig, double cocontraction, double push) {
    const Protocol& p = test_rig_.protocol;
    const auto run = [&](double seconds, const auto& torque) {
        rig.run(seconds, [&](double t) { return Command{{cocontraction, cocontraction}, torque(t / seconds), hand(cocontraction)}; });
    };
    run(p.dead_band_push, [&](double s) { return push * smooth(s / 0.75); });
    run(p.dead_band_release, [&](double s) { return push * (1.0 - smooth(s / 0.8)); });
    return read_q(rig);
}

std::vector<DeadBandRow> Session::dead_band() {
    std::vector<DeadBandRow> rows;
    for (const double cocontraction : points_.dead_band)
        for (int repeat = 1; repeat <= kDeadBandRepeats; ++repeat) {
            const double wanted = (0.9 * range_.scale + 1.15 * cocontraction) * (1.0 + kPushScatter * random_.normal());
            DeadBandRow row{cocontraction, repeat, 1e-3 * std::round(1e3 * std::min(wanted, range_.most_push)), 0.0, 0.0};
            const std::unique_ptr<Motion> rig = co_contracted(cocontraction, hand(cocontraction));
            row.q_high = pushed_and_released(*rig, cocontraction, row.push);
            row.q_low = pushed_and_released(*rig, cocontraction, -row.push);
            end(*rig);
            rows.push_back(row);
        }
    return rows;
}

std::vector<StiffnessRow> Session::joint_stiffness() {
    struct Phase {
        const char* name;
        double from, to;
    };
    constexpr std::array<Phase, 4> kPhases{{{"load+", 0.0, 1.0}, {"unload+", 1.0, 0.0}, {"load-", 0.0, -1.0}, {"unload-", -1.0, 0.0}}};
    std::vector<StiffnessRow> rows;
    const double seconds = test_rig_.protocol.joint_stiffness_phase / kStiffnessRows;
    for (const double c : points_.joint_stiffness) {
        const std::unique_ptr<Motion> rig = co_contracted(c, 0.0);
        const double top = std::min(0.5 * range_.scale + 0.6 * c, range_.most_push);
        for (const Phase& phase : kPhases)
            for (int i = 0; i < kStiffnessRows; ++i) {
                const auto torque = [&](double s) { return top * (phase.from + (phase.to - phase.from) * (i + s) / kStiffnessRows); };
                rows.push_back({c, phase.name, torque_sensor(torque(0.0)), read_q(*rig)});
                rig->run(seconds, [&](double t) { return Command{{c, c}, torque(t / seconds), 0.0}; });
            }
        end(*rig);
    }
    return rows;
}

std::vector<CocontractionRow> Session::cocontraction() {
    std::vector<CocontractionRow> rows;
    const double seconds = test_rig_.protocol.cocontraction_phase / kCocontractionRows;
    const std::unique_ptr<Motion> rig = engine_.start(test_rig_.truth, springs_, now_);
    for (const bool up : {true, false})
        for (int i = 0; i <= kCocontractionRows; ++i) {
            const auto torque = [&](double row) {
                const double share = std::min(1.0, row / kCocontractionRows);
                return test_rig_.nominal.top_torque * (up ? share : 1.0 - share);
            };
            rows.push_back({up, torque(i), {read_theta(*rig, 0), read_theta(*rig, 1)}, read_q(*rig)});
            if (i == kCocontractionRows) continue;
            rig->run(seconds, [&](double t) {
                const double motor = torque(i + t / seconds);
                return Command{{motor, motor}, 0.0, 0.0};
            });
        }
    end(*rig);
    return rows;
}

/// Five seconds of a swing from motor to motor whose frequency rises, whole periods of it; a second and a half of rest; a knock on the
/// joint.
Command Session::log_command(double t, double knock) const {
    constexpr double kSwing = 5.0, kKnockAt = 6.5, kKnockFor = 0.2;
    const double frequency = points_.log_slow + 0.5 * (points_.log_fast - points_.log_slow) * t / kSwing;
    const double swing = t < kSwing ? points_.log_swing * std::sin(2.0 * core::kPi * frequency * t) : 0.0;
    const double s = (t - kKnockAt) / kKnockFor;
    return {{points_.log_torque + swing, points_.log_torque - swing}, s > 0.0 && s < 1.0 ? knock * std::sin(core::kPi * s) : 0.0, 0.0};
}

std::vector<LogRow> Session::log() {
    constexpr double kSeconds = 8.0;
    std::vector<LogRow> rows;
    const double knock = random_.either_sign(points_.log_knock), rate = test_rig_.sensors.log_rate;
    std::vector<double> late;  // q as read, before the lag
    const auto behind = static_cast<std::size_t>(std::lround(test_rig_.truth.joint.encoder_lag * rate));
    const std::unique_ptr<Motion> rig = co_contracted(points_.log_torque, 0.0);
    const long samples = std::lround(kSeconds * rate);
    for (long i = 0; i <= samples; ++i) {
        const double time = static_cast<double>(i) / rate;
        rows.push_back({time, log_command(time, knock), {read_theta(*rig, 0), read_theta(*rig, 1)}, read_q(*rig)});
        late.push_back(rows.back().q);
        rows.back().q = late[late.size() - 1 - std::min(late.size() - 1, behind)];
        if (i < samples) rig->run(1.0 / rate, [&](double t) { return log_command(time + t, knock); });
    }
    end(*rig);
    return rows;
}

Measured measure(const TestRig& test_rig, const SetPoints& points, Random& random, double begin, const Engine& engine) {
    Session session(test_rig, points, random, begin, engine);
    Measured m;
    m.breakaway = session.break_away();
    m.spring_pull = session.spring_pull();
    m.dead_band = session.dead_band();
    m.joint_stiffness = session.joint_stiffness();
    m.cocontraction = session.cocontraction();
    m.log = session.log();
    return m;
}

}  // namespace fusee::plant
