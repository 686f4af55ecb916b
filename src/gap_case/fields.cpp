#include "fields.h"

#include "fusee/gap_case/reference.h"

namespace fusee::gap_case {

namespace {

// The list's rows; `place` is a member of the row.
#define FUSEE_NUMBER(row, name, is_measured, is_required, of, place)                                \
    Field<row> {                                                                                    \
        .column = name, .measured = is_measured, .required = is_required, .quantity = Quantity::of, \
        .get = [](const row& r) { return static_cast<double>(r.place); },                           \
        .set = [](row& r, double value) { r.place = static_cast<decltype(r.place)>(value); }        \
    }
#define FUSEE_INPUT(row, name, of, place) FUSEE_NUMBER(row, name, false, true, of, place)
#define FUSEE_MEASURED(row, name, of, place) FUSEE_NUMBER(row, name, true, true, of, place)

template <class Row>
Field<Row> word(const char* column, std::vector<std::string> words, double (*get)(const Row&), void (*set)(Row&, double)) {
    return {.column = column, .get = get, .set = set, .words = std::move(words)};
}

const std::vector<std::string> kSides{"agonist", "antagonist"};

}  // namespace

template <>
const std::vector<Field<BreakAway>>& fields() {
    using Row = BreakAway;
    static const std::vector<Field<Row>> kFields{
        word<Row>(
            "side", kSides, [](const Row& r) { return r.side == kSides[1] ? 1.0 : 0.0; },
            [](Row& r, double place) { r.side = kSides[static_cast<std::size_t>(place)]; }),
        word<Row>(
            "direction", {"drive", "backdrive"}, [](const Row& r) { return r.backdrive ? 1.0 : 0.0; },
            [](Row& r, double place) { r.backdrive = place == 1.0; }),
        FUSEE_INPUT(Row, "motor_torque_Nm", kPull, motor_torque),
        FUSEE_MEASURED(Row, "load_torque_Nm", kPull, load_torque),
    };
    return kFields;
}

template <>
const std::vector<Field<SpringPull>>& fields() {
    using Row = SpringPull;
    static const std::vector<Field<Row>> kFields{
        word<Row>(
            "spring", {"pe", "se"}, [](const Row& r) { return r.series ? 1.0 : 0.0; },
            [](Row& r, double place) { r.series = place == 1.0; }),
        word<Row>(
            "side", kSides, [](const Row& r) { return static_cast<double>(r.side); },
            [](Row& r, double place) { r.side = place == 1.0 ? Side::kAntagonist : Side::kAgonist; }),
        word<Row>(
            "phase", {"load", "unload"}, [](const Row& r) { return r.load ? 0.0 : 1.0; },
            [](Row& r, double place) { r.load = place == 0.0; }),
        FUSEE_INPUT(Row, "deflection_rad", kDeflection, deflection),
        FUSEE_MEASURED(Row, "torque_Nm", kTorque, torque),
    };
    return kFields;
}

template <>
const std::vector<Field<DeadBandRow>>& fields() {
    using Row = DeadBandRow;
    static const std::vector<Field<Row>> kFields{
        FUSEE_INPUT(Row, "cocontraction_Nm", kPull, cocontraction),
        FUSEE_NUMBER(Row, "repeat", false, false, kCount, repeat),
        FUSEE_NUMBER(Row, "push_torque_Nm", false, false, kJointTorque, push_torque),
        FUSEE_NUMBER(Row, "q_low_rad", true, false, kJointAngle, q_low),
        FUSEE_NUMBER(Row, "q_high_rad", true, false, kJointAngle, q_high),
        FUSEE_NUMBER(Row, "width_rad", true, false, kJointAngle, width),
    };
    return kFields;
}

template <>
const std::vector<Field<StiffnessRow>>& fields() {
    using Row = StiffnessRow;
    static const std::vector<Field<Row>> kFields{
        FUSEE_INPUT(Row, "cocontraction_Nm", kPull, cocontraction),
        word<Row>(
            "phase", {"load+", "unload+", "load-", "unload-"}, [](const Row& r) { return static_cast<double>(r.phase); },
            [](Row& r, double place) { r.phase = static_cast<StiffnessPhase>(place); }),
        FUSEE_INPUT(Row, "joint_torque_Nm", kJointTorque, joint_torque),
        FUSEE_MEASURED(Row, "q_rad", kJointAngle, q),
    };
    return kFields;
}

template <>
const std::vector<Field<CocontractionRow>>& fields() {
    using Row = CocontractionRow;
    static const std::vector<Field<Row>> kFields{
        word<Row>(
            "phase", {"up", "down"}, [](const Row& r) { return r.up ? 0.0 : 1.0; }, [](Row& r, double place) { r.up = place == 0.0; }),
        FUSEE_INPUT(Row, "motor_torque_Nm", kPull, motor_torque),
        FUSEE_MEASURED(Row, "theta_agonist_rad", kCapstanAngle, theta_agonist),
        FUSEE_MEASURED(Row, "theta_antagonist_rad", kCapstanAngle, theta_antagonist),
        FUSEE_MEASURED(Row, "q_rad", kJointAngle, q),
    };
    return kFields;
}

template <>
const std::vector<Field<LogRow>>& fields() {
    using Row = LogRow;
    static const std::vector<Field<Row>> kFields{
        FUSEE_INPUT(Row, "t_s", kTime, time),
        FUSEE_INPUT(Row, "motor_torque_agonist_Nm", kTorque, torque_agonist),
        FUSEE_INPUT(Row, "motor_torque_antagonist_Nm", kTorque, torque_antagonist),
        FUSEE_INPUT(Row, "joint_torque_Nm", kJointTorque, joint_torque),
        FUSEE_MEASURED(Row, "theta_agonist_rad", kCapstanAngle, theta_agonist),
        FUSEE_MEASURED(Row, "theta_antagonist_rad", kCapstanAngle, theta_antagonist),
        FUSEE_MEASURED(Row, "q_rad", kJointAngle, q),
    };
    return kFields;
}

#undef FUSEE_MEASURED
#undef FUSEE_INPUT
#undef FUSEE_NUMBER

std::vector<NumberKey> on_rig(std::vector<NumberKey> keys, const NominalRig& rig) {
    const Reference torque{.torque = reference_of(rig).torque};
    for (NumberKey& key : keys) {
        key.low *= torque.of(key.unit);
        key.high *= torque.of(key.unit);
    }
    return keys;
}

std::vector<NumberKey> rig_keys(NominalRig& rig) {
    constexpr double kLeastRadius = 5e-4, kMostRadius = 0.5, kLeastInertia = 1e-9;
    return {{"capstan_radius_m", kLeastRadius, kMostRadius, "m", &rig.capstan_radius, "r_c, where the capstan takes the joint's cable"},
            {"joint_radius_m", kLeastRadius, kMostRadius, "m", &rig.joint_radius, "r_j, of the joint's pulley"},
            {"gear_load_friction", 0.0, 0.95, "", &rig.gear_load_friction, "mu: the gear's friction is mu times its load"},
            {"motor_inertia_kgm2", kLeastInertia, 1.0, "kg m^2", &rig.motor_inertia, "of one motor with its gear, at the capstan"},
            {"joint_inertia_kgm2", kLeastInertia, 1.0, "kg m^2", &rig.joint_inertia, "of the joint and what it carries"},
            {"motor_viscous_Nms", 0.0, 1.0, "Nms/rad", &rig.motor_viscous, "drag of one motor, at the capstan"},
            {"joint_viscous_Nms", 0.0, 1.0, "Nms/rad", &rig.joint_viscous, "drag of the joint"},
            {"se_torsion_rate_Nm_per_rad", 1e-4, 100.0, "Nm/rad", &rig.se_torsion_rate, "of the torsion spring behind a K_SE spool"},
            {"pe_compression_rate_N_per_m", 10.0, 1e6, "N/m", &rig.pe_compression_rate, "of the compression spring behind a K_PE cam"}};
}

std::vector<NumberKey> tolerance_keys(Tolerance& t) {
    return {{"gear_load_friction", 0.0, 0.5, "", &t.gear_load_friction, "relative"},
            {"radii", 0.0, 0.5, "", &t.radii, "of capstan and joint, relative"},
            {"inertia", 0.0, 0.9, "", &t.inertia, "relative"},
            {"spring_rate", 0.0, 0.5, "", &t.spring_rate, "of the base springs, relative"},
            {"se_radius_m", 0.0, 2e-3, "m", &t.se_radius, "of every arm of the spool"},
            {"pe_radius_m", 0.0, 2e-3, "m", &t.pe_radius, "of every arm of the cam"},
            {"se_preload_rad", 0.0, 1.0, "rad", &t.se_preload, "of the torsion spring, at the spool"},
            {"pe_preload_m", 0.0, 5e-3, "m", &t.pe_preload, "of the compression spring"},
            {"torque_scale", 0.0, 0.5, "", &t.torque_scale, "torque delivered over torque commanded, relative"},
            {"joint_coulomb_Nm", 0.0, 10.0, "Nm", &t.joint_coulomb, "friction of a good bearing"},
            {"joint_offset_rad", 0.0, 0.5, "rad", &t.joint_offset, "zero of the joint's encoder"}};
}

std::vector<NumberKey> sensor_keys(Sensors& s) {
    return {{"encoder_step_rad", 0.0, 0.03, "rad", &s.encoder_step, "between two readings of an encoder"},
            {"encoder_noise_rad", 0.0, 0.03, "rad", &s.encoder_noise, "one sigma, in addition to the step"},
            {"torque_noise_relative", 0.0, 0.3, "", &s.torque_noise_relative, "one sigma of a torque reading, relative"},
            {"torque_noise_Nm", 0.0, 1.0, "Nm", &s.torque_noise, "one sigma of a torque reading, added to it"},
            {"breakaway_scatter", 0.0, 0.5, "", &s.breakaway_scatter, "one sigma of friction from one break-away to the next, relative"},
            {"log_rate_Hz", 0.1, 1e5, "Hz", &s.log_rate, "rows of log.csv in a second"}};
}

std::vector<NumberKey> protocol_keys(Protocol& p) {
    constexpr double kShortest = 1e-3, kLongest = 300.0;
    return {{"motor_ramp_s", kShortest, kLongest, "s", &p.motor_ramp, "motor torques from 0 to the co-contraction"},
            {"motor_settle_s", kShortest, kLongest, "s", &p.motor_settle, "wait after it"},
            {"dead_band_push_s", kShortest, kLongest, "s", &p.dead_band_push, "joint torque from 0 to push_torque, held to the end of it"},
            {"dead_band_release_s", kShortest, kLongest, "s", &p.dead_band_release, "back to 0"},
            {"joint_stiffness_phase_s", kShortest, kLongest, "s", &p.joint_stiffness_phase, "each of load+, unload+, load-, unload-"},
            {"cocontraction_phase_s", kShortest, kLongest, "s", &p.cocontraction_phase, "each of up and down"}};
}

}  // namespace fusee::gap_case
