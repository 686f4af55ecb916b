#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "fusee/subsystem/subsystem.h"

/// Subsystem cases whose truth is known, made without the model's code.
namespace fusee::fixtures {

/// A friction element as a chain of 40 sliders behind one play: each slider holds its share of the force up to its own limit; all limits
/// equal, it is a spring with one slider.
struct Element {
    double coulomb = 1000.0, deflection = 0.0, backlash = 0.0, asymmetry = 0.0, viscous = 0.0, stribeck = 0.0, stribeck_speed = 0.01;
    double load = 0.0;  ///< N of friction per N of preload
    double noise = 20.0;
    int rows = 300;  ///< of a file
};

/// 3 amplitudes at 3 frequencies, 4 cycles each from rest.
inline subsystem::Case measure(const Element& e, unsigned seed, bool preloads = false) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    subsystem::Case subsystem_case;
    subsystem_case.name = "element";
    subsystem_case.sensors["force_noise_N"] = e.noise;
    for (const double amplitude : {0.005, 0.01, 0.02})
        for (const double frequency : {0.25, 0.5, 1.0}) {
            subsystem::Record record{
                "force_loop", "a" + std::to_string(amplitude) + "f" + std::to_string(frequency) + ".csv", {}, {}, {}, {}};
            const double preload = 100.0 * frequency + 20000.0 * amplitude;
            if (preloads) record.parameters["preload_N"] = preload;
            double slider = 0.0, before = 0.0, force = 0.0;
            for (int i = 0; i <= e.rows; ++i) {
                const double t = i * 4.2 / frequency / e.rows, turn = 2.0 * 3.14159265358979 * frequency;
                const double x = amplitude * std::sin(turn * t), v = amplitude * turn * std::cos(turn * t);
                const double most = (e.coulomb + e.load * preload) * (1.0 + e.stribeck * std::exp(-std::pow(v / e.stribeck_speed, 2))) +
                                    e.viscous * std::abs(v);
                const double up = most * (1.0 + e.asymmetry), down = most * (1.0 - e.asymmetry);
                if (e.deflection == 0.0 && e.backlash == 0.0) {
                    if (x != before) force = x > before ? up : -down;
                } else {
                    // The spring's end rests on the slider at `slider`; play of +- backlash/2 between them.
                    const double u = x - slider, free = 0.5 * e.backlash, bend = std::max(e.deflection, 1e-9);
                    const double rate_up = (e.coulomb + e.load * preload) * (1.0 + e.asymmetry) / bend;
                    const double rate_down = (e.coulomb + e.load * preload) * (1.0 - e.asymmetry) / bend;
                    force = u > free ? rate_up * (u - free) : u < -free ? rate_down * (u + free) : 0.0;
                    if (force > up) force = up, slider = x - free - up / rate_up;
                    if (force < -down) force = -down, slider = x + free + down / rate_down;
                }
                before = x;
                record.columns["t_s"].push_back(t);
                record.columns["x_m"].push_back(x);
                record.columns["v_m_s"].push_back(v);
                record.columns["F_N"].push_back(force + e.noise * normal(random));
            }
            subsystem_case.records.push_back(std::move(record));
        }
    return subsystem_case;
}

/// A servo that swings a mass; explicit steps of 0.2 ms, friction by a steep tanh.
struct Servo {
    double kt = 0.4, resistance = 5.0, armature = 0.0015, coulomb = 0.02, viscous = 0.004, offset = 0.01;
    double load_friction = 0.0, load_quadratic = 0.0, stribeck = 0.0, asymmetry = 0.0, delay = 0.0;
};

inline subsystem::Case measure(const Servo& s, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 6e-4);
    subsystem::Case subsystem_case;
    subsystem_case.kind = subsystem::Kind::kServoPendulum;
    subsystem_case.name = "servo";
    const double weight = 0.49 * 9.81 * 0.1, inertia = 0.49 * 0.01 + s.armature, h = 2e-4;
    for (const double kp : {100.0, 300.0, 800.0})
        for (const int trajectory : {0, 1}) {
            subsystem::Record record{"pendulum_log",
                                     std::to_string(static_cast<int>(kp)) + "_" + std::to_string(trajectory) + ".csv",
                                     {{"mass_kg", 0.49}, {"length_m", 0.1}, {"kp", kp}, {"vin_V", 7.4}},
                                     {{"trajectory", trajectory == 0 ? "swing" : "drop"}},
                                     {},
                                     {}};
            double q = 0.0, v = 0.0;
            std::vector<double> errors;
            for (int i = 0; i <= 12500; ++i) {
                const double t = i * h, goal = trajectory == 0 ? 1.2 * std::sin(2.0 * t + 0.8 * t * t) : 1.5 * std::sin(1.1 * t);
                const bool on = trajectory == 0 || t < 2.5;
                if (i % 40 == 0) {
                    record.columns["t_s"].push_back(t);
                    record.columns["q_rad"].push_back(q + normal(random));
                    record.columns["q_goal_rad"].push_back(goal);
                    record.columns["torque_enable"].push_back(on ? 1.0 : 0.0);
                }
                errors.push_back(goal - q);
                const auto late = static_cast<std::size_t>(s.delay / h);
                const double error = errors.size() > late ? errors[errors.size() - 1 - late] : errors.front();
                const double duty = std::clamp(error * kp * 4096.0 / 6.283185307179586 / (256.0 * 885.0), -1.0, 1.0);
                const double motor = on ? s.kt * duty * 7.4 / s.resistance - s.kt * s.kt * v / s.resistance : 0.0;
                const double pull = -weight * std::sin(q + s.offset);
                const double load = 0.5 * std::abs(motor - pull);
                double friction = s.coulomb + s.load_friction * load + s.load_quadratic * load * load;
                friction *= 1.0 + s.stribeck * std::exp(-std::pow(v / 0.5, 2));
                friction *= 1.0 + (v > 0.0 ? s.asymmetry : -s.asymmetry);
                v += h * (motor + pull - s.viscous * v - friction * std::tanh(v / 0.003)) / inertia;
                q += h * v;
            }
            subsystem_case.records.push_back(std::move(record));
        }
    return subsystem_case;
}

/// Break-aways of one motor or two; the scatter is that of the friction.
struct Motor {
    double mu = 0.25, constant = 0.0, asymmetry = 0.0, quadratic = 0.0, scale = 0.0, scatter = 0.02;
};

inline subsystem::Case measure(const std::vector<std::pair<std::string, Motor>>& motors, unsigned seed,
                               const std::vector<double>& torques = {0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2}) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    subsystem::Case subsystem_case;
    subsystem_case.kind = subsystem::Kind::kMotorBreakaway;
    subsystem_case.name = "motor";
    subsystem_case.sensors["breakaway_scatter"] = motors.front().second.scatter;
    subsystem::Record record{"breakaway", "breakaway.csv", {}, {}, {}, {}};
    for (const auto& [side, m] : motors)
        for (const double s : {1.0, -1.0})
            for (const double torque : torques)
                for (int repeat = 0; repeat < 3; ++repeat) {
                    const double met = 1.0 + m.scatter * normal(random);
                    double load = torque;
                    for (int i = 0; i < 200; ++i)  // L = k tau + s f(L): contracts, since f is flatter than 1
                        load = (1.0 + m.scale) * torque +
                               s * met * (m.constant + m.mu * (1.0 + s * m.asymmetry) * load + m.quadratic * load * load);
                    record.texts["side"].push_back(side);
                    record.texts["direction"].push_back(s > 0.0 ? "backdrive" : "drive");
                    record.columns["motor_torque_Nm"].push_back(torque);
                    record.columns["load_torque_Nm"].push_back(load);
                }
    subsystem_case.records.push_back(std::move(record));
    return subsystem_case;
}

/// A joint with one cam or the other, turned by a dynamometer: 0, low, high, 0, at rest. Its friction turns round over 4 mrad.
struct CamRig {
    double scale = 0.0, series = 0.0, preload = 0.0, hysteresis = 0.0, coulomb = 0.0;
    double tilt = 0.0, bow = 0.0;  ///< of the arm over the angle: tilt at the ends; bow at +- 0.2 rad more than in the middle; both scale
                                   ///< nothing, weighted by the square of the torque
    double zero = 0.8;             ///< of the sensor in the first file [Nm]; the next have -1, -2, ... times as much
    double noise = 0.3;            ///< [Nm]
    int rows = 500;
};

inline double cam_torque(bool second, double q) {
    return second ? 120.0 * q + 35.0 * (std::tanh(25.0 * (q - 0.1)) + std::tanh(2.5)) : 22.0 * std::sinh(8.0 * q);
}

inline subsystem::Record cam_pull(const CamRig& rig, bool second, double zero, const std::string& name, std::mt19937_64& random) {
    std::normal_distribution<double> normal(0.0, 1.0);
    subsystem::Record record{"pull", "pull_" + name + ".csv", {}, {}, {}, {}, {"law_" + name + ".csv", {}, {}}};
    for (int i = -260; i <= 260; ++i) {
        record.law.q_rad.push_back(i * 1e-3);
        record.law.torque_Nm.push_back(cam_torque(second, i * 1e-3));
    }
    const auto driven = [&](int i) {
        const double t = static_cast<double>(i) / rig.rows;
        return t < 0.2 ? -0.85 * t : t < 0.6 ? -0.17 + 0.925 * (t - 0.2) : t < 0.9 ? 0.2 - (t - 0.6) * 0.2 / 0.3 : 0.0;
    };
    const auto curve = [&](double q) { return rig.tilt * q / 0.2 + rig.bow * 25.0 * q * q; };
    double sum = 0.0, weights = 0.0;
    for (int i = 0; i <= rig.rows; ++i)
        for (const bool cam : {false, true}) {
            sum += std::pow(cam_torque(cam, driven(i)), 2) * curve(driven(i));
            weights += std::pow(cam_torque(cam, driven(i)), 2);
        }
    const auto spring = [&](double q) {
        const double arm = 1.0 + curve(q) - sum / weights;
        return (1.0 + rig.scale) * arm * cam_torque(second, q + rig.preload);
    };
    double before = 0.0, turn = 0.0;
    for (int i = 0; i <= rig.rows; ++i) {
        const double q = driven(i);
        double low = q - 1.0, high = q + 1.0;  // the cam's angle
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (low + high);
            (middle + rig.series * spring(middle) < q ? low : high) = middle;
        }
        turn = std::clamp(turn + (q - before) / 0.002, -1.0, 1.0);
        before = q;
        const double torque = spring(0.5 * (low + high));
        record.columns["t_s"].push_back(15.0 * i / rig.rows);
        record.columns["q_rad"].push_back(q);
        record.columns["torque_Nm"].push_back(zero + torque + turn * (rig.coulomb + rig.hysteresis * std::abs(torque)) +
                                              rig.noise * normal(random));
    }
    return record;
}

/// Each cam alone, once.
inline subsystem::Case measure(const CamRig& rig, unsigned seed) {
    std::mt19937_64 random(seed);
    subsystem::Case subsystem_case;
    subsystem_case.kind = subsystem::Kind::kCamJoint;
    subsystem_case.name = "cams";
    subsystem_case.sensors["torque_noise_Nm"] = rig.noise;
    subsystem_case.records.push_back(cam_pull(rig, false, rig.zero, "first", random));
    subsystem_case.records.push_back(cam_pull(rig, true, -rig.zero, "second", random));
    return subsystem_case;
}

/// A folder of measurements by others: in that of FUSEE_GAP_REAL, or beside the source tree.
inline std::filesystem::path real_measurements(const char* name) {
    const char* real = std::getenv("FUSEE_GAP_REAL");
    return (real != nullptr ? std::filesystem::path(real) : std::filesystem::path(FUSEE_SOURCE_DIR) / "../shared/gap/real") / name;
}

inline std::string names_of(const diagnosis::Diagnosis& d) {
    std::vector<std::string> names;
    for (const diagnosis::FoundEffect& e : d.effects) names.push_back(e.cause.id + (e.cause.side == "none" ? "" : " " + e.cause.side));
    std::sort(names.begin(), names.end());
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
}

inline bool says(const diagnosis::Diagnosis& d, const std::string& text) {
    return std::any_of(d.remarks.begin(), d.remarks.end(), [&](const std::string& r) { return r.find(text) != std::string::npos; });
}

}  // namespace fusee::fixtures
