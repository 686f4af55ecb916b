#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

/// The simulated rig, independent of the model (docs/theory/plant.md): nominal and as built. Everything is SI; a capstan's angle and
/// torque are positive when they wind its own cable in.
namespace fusee::plant {

/// Counter-based random numbers: a stream depends on (seed, index, purpose) and the number of draws, not on threads.
/// Each number is a hash of key and counter (the finaliser of SplitMix64, Steele, Lea & Flood 2014).
class Random {
public:
    Random(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose);

    [[nodiscard]] std::uint64_t bits();
    [[nodiscard]] double uniform(double low, double high);
    [[nodiscard]] double normal();                         ///< standard normal (Box & Muller)
    [[nodiscard]] double either_sign(double magnitude);    ///< +magnitude or -magnitude at even odds
    [[nodiscard]] std::uint64_t below(std::uint64_t end);  ///< 0 .. end - 1. @pre end > 0 and far below 2^64

private:
    std::uint64_t key_, counter_ = 0;
};

/// Torques of the spring pair over the deflection, both at the capstan: rows close enough for a trapezoidal rule.
struct SpringCurves {
    std::vector<double> deflection;  ///< [rad], ascending from 0
    std::vector<double> se, pe;      ///< [Nm], 0 at 0
};
enum class LawKind { kStictionCompensating, kExponential, kCubic, kLinear };

/// The nominal rig.
struct Nominal {
    double capstan_radius = 0.015, joint_radius = 0.022;  ///< [m]
    double mu = 0.25;                                     ///< gear friction over load
    double motor_inertia = 0.002, joint_inertia = 0.006;  ///< at the capstan, at the joint [kg m^2]
    double motor_viscous = 0.004, joint_viscous = 0.002;  ///< [Nms]
    double torsion_rate = 0.0;                            ///< of K_SE's base spring [Nm/rad]
    double compression_rate = 0.0;                        ///< of K_PE's base spring [N/m]
    double top_torque = 1.5;                              ///< highest motor torque of the experiments [Nm]
    SpringCurves springs;
    [[nodiscard]] double ratio() const { return joint_radius / capstan_radius; }  ///< g
};

/// One sigma, relative unless a unit is named.
struct Tolerance {
    double mu = 0.02, radii = 0.003, inertia = 0.03, spring_rate = 0.008;
    double se_radius = 3e-5, pe_radius = 2e-5;  ///< [m]
    double se_preload = 0.005;                  ///< [rad]
    double pe_preload = 5e-5;                   ///< [m]
    double torque_scale = 0.005;
    double joint_coulomb = 0.005;  ///< [Nm]
    double joint_offset = 0.003;   ///< [rad]
};
struct Sensors {
    double encoder_step = 7.6699039e-4, encoder_noise = 6e-4;     ///< [rad]
    double torque_noise_relative = 0.003, torque_noise = 1.5e-3;  ///< -, [Nm]
    double breakaway_scatter = 0.03;                              ///< relative, of the friction
    double log_rate = 100.0;                                      ///< [Hz]
};
/// How long each phase takes [s].
struct Protocol {
    double motor_ramp = 0.6, motor_settle = 0.4;
    double dead_band_push = 2.4, dead_band_release = 5.0;
    double joint_stiffness_phase = 2.0, cocontraction_phase = 5.0;
};

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A base spring with its cam and cable as built.
struct SpringTruth {
    double rate = 0.0;                         ///< of the base spring [Nm/rad] or [N/m]
    double radius_offset = 0.0;                ///< of every arm [m]
    double preload = 0.0;                      ///< wound (+) or slack (-) [rad] or [m]
    double hysteresis = 0.0;                   ///< a in F (1 + a z)
    double hysteresis_reach = 0.02;            ///< deflection after which z has turned [rad]
    double bottoming = kNever;                 ///< deflection of the base spring at which it binds
    double cable_stiffness = kNever;           ///< in series, at the capstan [Nm/rad]
    double crack_at = kNever;                  ///< deflection of the base spring (K_SE) or capstan angle (K_PE) from which arms are short
    double crack_share = 0.0;                  ///< by this share
    double warm_share = 0.0, warm_time = 1.0;  ///< torque (1 + share t/(t + time)) with the session's time
    double creep_share = 0.0;                  ///< of the torque that relaxes
    double creep_time = 1.0;                   ///< within this time [s]
};

/// How friction slides and sticks: bristles that bend.
enum class Presliding { kElastoPlastic, kLuGre };

/// A motor with its gear, capstan and springs as built.
struct SideTruth {
    double capstan_radius = 0.0, joint_radius = 0.0;  ///< [m]
    double mu = 0.0;
    double coulomb = 0.0;                                            ///< on top of mu load [Nm]
    double stribeck = 0.0, stribeck_speed = 0.1;                     ///< s, v_s [rad/s]
    double viscous = 0.0;                                            ///< [Nms]
    double inertia = 0.0;                                            ///< [kg m^2]
    double torque_scale = 1.0;                                       ///< delivered over commanded
    double crosstalk = 0.0;                                          ///< share of the other motor's torque that is added
    double ripple = 0.0, ripple_turns = 1.0, ripple_phase = 0.0;     ///< friction (1 + ripple sin(turns theta + phase))
    double drift = 0.0, drift_time = 1.0;                            ///< friction (1 + drift (1 - exp(-t/time))) with the session's time
    double cogging = 0.0, cogging_turns = 1.0, cogging_phase = 0.0;  ///< motor torque + cogging sin(turns theta + phase) [Nm]
    double jump_torque = kNever, jump = 0.0;              ///< K_SE's cable leaves its groove once above it [Nm], and loses this [rad]
    double eccentricity = 0.0, eccentricity_phase = 0.0;  ///< encoder reads theta + e sin(theta + phase) [rad]
    double slip_torque = kNever, slip_drag = 1.0;         ///< K_SE's cable slips at (F - slip_torque)/drag [Nm], [Nms]
    double fade = 0.0, fade_time = 1.0;                   ///< motor torque (1 + fade t/(t + time)) with the session's time
    double saturation = kNever;                           ///< S of a motor torque tau/sqrt(1 + (tau/S)^2) [Nm]
    double rise = 0.0, rise_speed = 1.0;                  ///< friction (1 + rise v/(v + rise_speed)) [rad/s]
    SpringTruth se, pe;
    [[nodiscard]] double ratio() const { return joint_radius / capstan_radius; }
};

struct JointTruth {
    double inertia = 0.0, viscous = 0.0, coulomb = 0.0;
    double tension_friction = 0.0;                          ///< c of friction c g (F_SE1 + F_SE2)
    double stop = kNever;                                   ///< at +- this angle [rad]
    double gravity = 0.0;                                   ///< m g l: pulls back to q = 0 [Nm]
    double harness = 0.0, hardening = 0.0;                  ///< torque harness q + hardening q^3, to ground
    double rough = 0.0, rough_at = 0.0, rough_width = 1.0;  ///< friction that peaks at one angle [Nm], [rad], [rad]
    double pulley = 0.0, pulley_phase = 0.0;                ///< both cables' arm is (1 + pulley sin(q + phase)) times
    double flexibility = 0.0;                               ///< the encoder reads q + flexibility times the joint torque [rad/Nm]
    double encoder_lag = 0.0;                               ///< of a log: q was read so much earlier [s]
    double encoder_offset = 0.0, encoder_scale = 1.0;
    double zero_drift = 0.0, zero_time = 1.0;             ///< the encoder's zero moves by drift t/(t + time) with the session [rad]
    double eccentricity = 0.0, eccentricity_phase = 0.0;  ///< the encoder reads q + e (sin(q + phase) - sin(phase)) [rad]
    double drag = 0.0;                                    ///< of fluid_drag() [Nm s^2/rad^2]
    double play = 0.0;                                    ///< between pulley and link, of which the encoder reads the link [rad]
    double mount = 0.0;                                   ///< both cables slacken by mount (F_SE1 + F_SE2) [rad/Nm]
    [[nodiscard]] double arm_factor(double q) const { return 1.0 + pulley * std::sin(q + pulley_phase); }
    [[nodiscard]] double wound(double q) const { return q + pulley * (std::cos(pulley_phase) - std::cos(q + pulley_phase)); }
};

/// The rig as built: both sides different.
struct Truth {
    std::array<SideTruth, 2> sides;  ///< agonist, antagonist
    JointTruth joint;
    Presliding presliding = Presliding::kElastoPlastic;
    double bristle = 1500.0;  ///< stiffness of the gear's bristles [Nm/rad]
    double hand = 1.0;        ///< damping by hand in the dead-band test: (0.04 s + 0.1 s torque/top torque) times this
};

/// The stiction-compensating law (k, u, C) closed in the load, with a parabola from the origin to its start; an exponential, a cubic or a
/// linear pair.
/// @pre 0 < mu < 1, top_load > 0
[[nodiscard]] SpringCurves draw_springs(LawKind kind, double mu, double top_load, Random& random);
/// A random rig: radii, friction, law and base springs. With linear_springs the law is a straight line, all else as without.
[[nodiscard]] Nominal draw_nominal(Random& random, bool linear_springs = false);
/// Every nominal figure within its tolerance, on each side anew; friction model and bristles at random.
[[nodiscard]] Truth build(const Nominal& nominal, const Tolerance& tolerance, Random& random);

/// Torque of a spring at a deflection between its rows (straight lines). @pre inside the rows
[[nodiscard]] double torque_at(const std::vector<double>& deflection, const std::vector<double>& torque, double x);
/// Deflection at which the pair, or one spring, reaches a torque; the end if it does not. @pre torque rises
[[nodiscard]] double deflection_at(const std::vector<double>& deflection, const std::vector<double>& torque, double wanted);
/// F_SE + F_PE row by row: the load of equal co-contraction at q = 0.
[[nodiscard]] std::vector<double> load_of(const SpringCurves& springs);
/// Energy of a spring over its rows [J], trapezoidal.
[[nodiscard]] std::vector<double> energy_of(const std::vector<double>& deflection, const std::vector<double>& torque);

/// Operating range of a rig in the experiments: reference of effect and push sizes.
struct RigRange {
    const Nominal* nominal = nullptr;
    double scale = 1.0;      ///< of every torque set point: top torque/1.5 Nm
    double travel = 0.0;     ///< capstan angle at the top torque without friction [rad]
    double series = 0.0;     ///< F_SE there [Nm]
    double spool = 0.0;      ///< spool angle there [rad]
    double stroke = 0.0;     ///< compression there [m]
    double se_arm = 0.0;     ///< of K_SE's cam half way [m]
    double pe_arm = 0.0;     ///< of K_PE's cam at the top torque [m]
    double most_push = 0.0;  ///< at the joint, that K_SE bears inside its table [Nm]
    double reach = 0.0;      ///< joint angle of a push of half of it, the other cable slack and both capstans unwound [rad]
};
[[nodiscard]] RigRange range_of(const Nominal& nominal);

}  // namespace fusee::plant
