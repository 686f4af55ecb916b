#pragma once
#include <cmath>
#include <limits>

namespace fusee::joint_model {

// Generic terms: laws for what no effect of the library describes (docs/theory/unknown.md). Each stands at a place of the joint and depends
// on one quantity; all are off in a new rig.

/// a sin(n x + phase).
struct Ripple {
    double amplitude = 0.0;
    double turns = 1.0;  ///< n [1/rad]
    double phase = 0.0;  ///< [rad]
    [[nodiscard]] bool is_on() const { return amplitude != 0.0; }
    [[nodiscard]] double operator()(double x) const { return amplitude * std::sin(turns * x + phase); }
    [[nodiscard]] double integral(double x) const {
        return amplitude / turns * (std::cos(phase) - std::cos(turns * x + phase));
    }  ///< from 0
};

/// a exp(-((x - at)/width)^2).
struct Bump {
    double height = 0.0, at = 0.0, width = 1.0;
    [[nodiscard]] bool is_on() const { return height != 0.0; }
    [[nodiscard]] double operator()(double x) const {
        const double away = (x - at) / width;
        return height * std::exp(-away * away);
    }
};

/// Terms of a gear with its motor and capstan.
struct GearTerms {
    Ripple friction;          ///< friction is (1 + ripple) times, over the capstan angle
    Ripple torque;            ///< added to the motor torque [Nm], over the capstan angle
    Ripple reading;           ///< added to the capstan's encoder [rad], over the capstan angle
    double crosstalk = 0.0;   ///< share of the other motor's command that is added to the motor torque
    double drift = 0.0;       ///< friction is (1 + drift (1 - exp(-t/drift_time))) times at the time t of the session
    double drift_time = 1.0;  ///< [s]
    /// Factor of the friction at a time of the session [s], at least 0.
    [[nodiscard]] double drifted(double session) const {
        return drift == 0.0 ? 1.0 : std::fmax(0.0, 1.0 - drift * std::expm1(-session / drift_time));
    }
    [[nodiscard]] bool move() const { return friction.is_on() || torque.is_on() || crosstalk != 0.0; }
};

/// Terms of a spring with its cam and cable.
struct SpringTerms {
    double slope = 0.0;                                        ///< torque is (1 + slope x/end) times
    double relaxation = 0.0;                                   ///< a: share of the torque that is lost as held
    double relaxation_time = 1.0;                              ///< [s]
    double fast_share = 0.0;                                   ///< w: the law is that of the fast torque (0), or of the settled one (1)
    double slip_at = std::numeric_limits<double>::infinity();  ///< torque from which the cable slips on its capstan [Nm]
    double slip_drag = 1.0;                                    ///< slip speed is (torque - slip_at)/slip_drag [Nms/rad]
    double jump_at = std::numeric_limits<double>::infinity();  ///< torque at which the cable leaves its groove, once in a run [Nm]
    double jump = 0.0;                                         ///< and loses this [rad]
    [[nodiscard]] bool have_memory() const { return relaxation != 0.0 || std::isfinite(slip_at) || jump != 0.0; }
    /// Torque F (1 + a w) - a R, of the elastic one F and of R, which follows it with the time constant. [Nm]
    [[nodiscard]] double relaxed(double elastic, double following) const {
        return elastic * (1.0 + relaxation * fast_share) - relaxation * following;
    }
    /// Factor of the torque at `share` of the cam's end.
    [[nodiscard]] double factor(double share) const { return 1.0 + slope * share; }
};

/// Terms of the joint.
struct JointTerms {
    double spring = 0.0;       ///< to ground: torque -spring q [Nm/rad]
    double hardening = 0.0;    ///< torque -hardening q^3 [Nm/rad^3]
    Ripple torque;             ///< added to the joint torque [Nm], over q
    Ripple arm;                ///< both cables' arms at the joint are (1 + ripple) times, over q
    Bump friction;             ///< added to the joint friction [Nm], over q
    double reading = 0.0;      ///< the joint's encoder reads (1 + reading) q
    double flexibility = 0.0;  ///< and this times the joint torque more [rad/Nm]
    double lag = 0.0;          ///< of a log: q was read so much earlier [s]
    [[nodiscard]] double torque_at(double q) const { return torque(q) - (spring + hardening * q * q) * q; }
};

}  // namespace fusee::joint_model
